#include "train/replay/motion_composition.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/gates.h"
#include "train/metrics/same_surface.h"

namespace warplut {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool IsFinite(const Vec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }

Vec2 MotionAt(const Image& motion, int x, int y) {
  return {motion.at(x, y, 0), motion.at(x, y, 1)};
}

double DepthAt(const Image& depth, int x, int y) {
  const double d = depth.at(x, y);
  return d <= kFarthestDepth ? d : kFarthestDepth;
}

// A surface that is followed back in time: where it is, and its depth where it was seen last.
struct Track {
  Vec2 position;
  double depth = 0;
};

// Moves `track` one frame back, from its position in the frame of `field`. Its coordinates are
// those of `grid`.
void StepBack(const MotionField& field, const Image& grid, Track& track) {
  const Image& motion = *field.motion;
  const Vec2 scale = {double{1} * motion.width / grid.width,
                      double{1} * motion.height / grid.height};
  const Vec2 at = {track.position.x * scale.x - field.offset.x - 0.5,
                   track.position.y * scale.y - field.offset.y - 0.5};
  const double u = std::clamp(at.x, 0.0, motion.width - 1.0);
  const double v = std::clamp(at.y, 0.0, motion.height - 1.0);
  const int left = static_cast<int>(u), top = static_cast<int>(v);
  double total = 0, depth = 0, nearest_weight = -1;
  Vec2 step, nearest = {kNan, kNan};
  for (int k = 0; k < 4; ++k) {
    const int i = k % 2, j = k / 2;
    const int x = std::min(left + i, motion.width - 1);
    const int y = std::min(top + j, motion.height - 1);
    const double weight = (1 - std::abs(u - left - i)) * (1 - std::abs(v - top - j));
    const Vec2 m = MotionAt(motion, x, y);
    if (!IsFinite(m)) continue;
    if (weight > nearest_weight) {
      nearest_weight = weight;
      nearest = m;
    }
    const double d = field.depth != nullptr ? DepthAt(*field.depth, x, y) : track.depth;
    const double change = DepthDifference(DepthMeasure::kRelative, d, track.depth);
    if (std::abs(change) > kSameSurface) continue;
    total += weight;
    depth += weight * d;
    step.x += weight * m.x;
    step.y += weight * m.y;
  }
  if (total > 0) {
    track.depth = depth / total;
    nearest = {step.x / total, step.y / total};
  }
  track.position.x -= nearest.x / scale.x;
  track.position.y -= nearest.y / scale.y;
}

}  // namespace

Image ComposeMotion(std::span<const MotionField> fields) {
  const MotionField& now = fields.front();
  if (fields.size() == 1) return *now.motion;
  Image composed(now.motion->width, now.motion->height, 2);
  tbb::parallel_for(0, composed.height, [&](int y) {
    for (int x = 0; x < composed.width; ++x) {
      const Vec2 start = {x + 0.5 + now.offset.x, y + 0.5 + now.offset.y};
      const Vec2 first = MotionAt(*now.motion, x, y);
      Track track{.position = {start.x - first.x, start.y - first.y},
                  .depth = now.depth != nullptr ? DepthAt(*now.depth, x, y) : 0};
      for (const MotionField& field : fields.subspan(1)) {
        if (!IsFinite(track.position)) break;
        StepBack(field, *now.motion, track);
      }
      const bool known = IsFinite(track.position);
      composed.at(x, y, 0) = static_cast<float>(known ? start.x - track.position.x : kNan);
      composed.at(x, y, 1) = static_cast<float>(known ? start.y - track.position.y : kNan);
    }
  });
  return composed;
}

}  // namespace warplut
