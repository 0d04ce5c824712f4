#include "tools/report/budget/budget_motion.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "luts/half.h"
#include "runtime/gates.h"
#include "train/metrics/same_surface.h"
#include "train/replay/image_views.h"
#include "train/replay/motion_composition.h"

namespace warplut {
namespace {

constexpr float kLargestCode = 255 * 255;  // of two bytes, as r + g / 255 in units of 255
constexpr int kIterations = 6;

ImageBuffer Copy(const ImageBuffer& image) {
  const ImageView from = image.view();
  if (from.width == 0) return {};
  ImageBuffer to(from.width, from.height, from.format);
  CopyPixels(from, to.view());
  return to;
}

MotionBuffer Stored(const MotionBuffer& motion, GridSize grid, GridSize output,
                    MotionStorage storage) {
  const MotionView from = motion.view();
  if (from.width == 0) return {};
  const auto size = [](int displayed, int of_grid, int of_output) {
    return static_cast<float>(displayed) * static_cast<float>(of_grid) /
           static_cast<float>(of_output);
  };
  const float width = size(kStoredDisplay.width, grid.width, output.width);
  const float height = size(kStoredDisplay.height, grid.height, output.height);
  MotionBuffer stored(from.width, from.height);
  for (int y = 0; y < from.height; ++y) {
    const float* in = from.Row(y);
    float* out = stored.view().Row(y);
    for (int x = 0; x < from.width; ++x) {
      out[2 * x] = StoredMotion(in[2 * x], width, storage);
      out[2 * x + 1] = StoredMotion(in[2 * x + 1], height, storage);
    }
  }
  return stored;
}

Vec2 MotionAt(const MotionView& motion, int x, int y) {
  const float* m = motion.Row(y) + 2 * x;
  return {m[0], m[1]};
}

double DepthAt(const ImageView& depth, int x, int y) {
  const double d = depth.Row<float>(y)[x];
  return d >= 0 && d <= kFarthestDepth ? d : kFarthestDepth;
}

bool SameSurface(double a, double b) {
  return std::abs(DepthDifference(DepthMeasure::kRelative, a, b)) <= kSameSurface;
}

// The motion of the next frame at a position (pixel centres at + 1/2), bilinear among the texels
// that show a surface at about `depth`; nothing outside the image or where no texel does.
std::optional<Vec2> NextMotion(const FrameGeometry& next, const Vec2& position, double depth) {
  const int width = next.motion.width, height = next.motion.height;
  if (!(position.x >= 0 && position.y >= 0 && position.x <= width && position.y <= height)) {
    return std::nullopt;
  }
  const double u = std::clamp(position.x - 0.5, 0.0, width - 1.0);
  const double v = std::clamp(position.y - 0.5, 0.0, height - 1.0);
  const int left = static_cast<int>(u), top = static_cast<int>(v);
  Vec2 sum;
  double total = 0;
  for (int k = 0; k < 4; ++k) {
    const int x = std::min(left + k % 2, width - 1), y = std::min(top + k / 2, height - 1);
    const double weight = (1 - std::abs(u - left - k % 2)) * (1 - std::abs(v - top - k / 2));
    const Vec2 m = MotionAt(next.motion, x, y);
    if (!(weight > 0) || !std::isfinite(m.x) || !std::isfinite(m.y)) continue;
    if (!SameSurface(DepthAt(next.depth, x, y), depth)) continue;
    sum.x += weight * m.x;
    sum.y += weight * m.y;
    total += weight;
  }
  if (!(total > 0)) return std::nullopt;
  return Vec2{sum.x / total, sum.y / total};
}

// The first source pixel of the next frame that arrives at each pixel, least depth first; -1
// without one.
std::vector<int> Arrivals(const FrameGeometry& next) {
  const int width = next.motion.width, height = next.motion.height;
  std::vector<int> arrivals(static_cast<std::size_t>(width) * height, -1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec2 m = MotionAt(next.motion, x, y);
      const double u = std::floor(x + 0.5 - m.x), v = std::floor(y + 0.5 - m.y);
      if (!(u >= 0 && v >= 0 && u < width && v < height)) continue;
      int& arrival = arrivals[static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u)];
      if (arrival < 0 ||
          DepthAt(next.depth, x, y) < DepthAt(next.depth, arrival % width, arrival / width)) {
        arrival = y * width + x;
      }
    }
  }
  return arrivals;
}

// v at a pixel centre p, from the arrival at a neighbour as a first guess; *closure is how far it
// fails to close.
std::optional<Vec2> Follow(const FrameGeometry& next, const Vec2& p, double depth, Vec2 v,
                           double* closure) {
  for (int i = 0; i < kIterations; ++i) {
    const std::optional<Vec2> m = NextMotion(next, {p.x + v.x, p.y + v.y}, depth);
    if (!m) return std::nullopt;
    *closure = std::hypot(m->x - v.x, m->y - v.y);
    v = *m;
  }
  return v;
}

}  // namespace

float StoredMotion(float m, float size, MotionStorage storage) {
  if (!std::isfinite(m)) return m;
  const float share = (m / size + 1) / 2;
  const float stored =
      storage == MotionStorage::kHalf
          ? HalfToFloat(FloatToHalf(share))
          : std::round(std::clamp(share, 0.0f, 1.0f) * kLargestCode) / kLargestCode;
  return (2 * stored - 1) * size;
}

Clip WithStoredMotion(const Clip& clip, MotionStorage storage) {
  Clip stored;
  stored.name = clip.name;
  stored.render = clip.render;
  stored.output = clip.output;
  stored.encoding = clip.encoding;
  for (const ClipFrame& frame : clip.frames) {
    ClipFrame& copy = stored.frames.emplace_back();
    copy.number = frame.number;
    copy.cut = frame.cut;
    copy.jitter = frame.jitter;
    copy.color = Copy(frame.color);
    copy.depth = Copy(frame.depth);
    copy.motion = Stored(frame.motion, clip.render, clip.output, storage);
    copy.reference = Copy(frame.reference);
    copy.reference_depth = Copy(frame.reference_depth);
    copy.reference_motion = Stored(frame.reference_motion, clip.output, clip.output, storage);
  }
  return stored;
}

ForwardMotion ForwardMotionOf(const FrameGeometry& now, const FrameGeometry& next) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const int width = next.motion.width, height = next.motion.height;
  const std::vector<int> arrivals = Arrivals(next);
  ForwardMotion forward{MotionBuffer(width, height), PixelMask(arrivals.size(), 0)};
  tbb::parallel_for(0, height, [&](int y) {
    float* out = forward.motion.view().Row(y);
    for (int x = 0; x < width; ++x) {
      const double depth = DepthAt(now.depth, x, y);
      double nearest = kClosure;
      float* v = out + 2 * x;
      v[0] = v[1] = kNan;
      for (int k = 0; k < 9; ++k) {
        const int u = std::clamp(x + k % 3 - 1, 0, width - 1);
        const int w = std::clamp(y + k / 3 - 1, 0, height - 1);
        const int arrival = arrivals[static_cast<std::size_t>(w) * width + u];
        if (arrival < 0) continue;
        double closure = 0;
        const std::optional<Vec2> found =
            Follow(next, {x + 0.5, y + 0.5}, depth,
                   MotionAt(next.motion, arrival % width, arrival / width), &closure);
        if (!found || !(closure < nearest)) continue;
        nearest = closure;
        v[0] = static_cast<float>(-found->x);
        v[1] = static_cast<float>(-found->y);
        forward.known[static_cast<std::size_t>(y) * width + x] = 1;
      }
    }
  });
  return forward;
}

}  // namespace warplut
