#include "train/replay/reprojection_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/core/pixel.h"
#include "runtime/gates.h"
#include "runtime/motion/point_carrier.h"

namespace warplut {
namespace {

const CameraMatrices& CameraOf(const Clip& clip, int frame) {
  return *clip.frames[static_cast<std::size_t>(frame)].camera;
}

// Where the point of pixel (x, y) was in the frame before, or that it was not shown.
bool WasAt(const PointCarrier& to_before, int x, int y, float depth, float& before_x,
           float& before_y) {
  const bool finite = depth >= 0 && depth < kFarthestDepth;
  const float g = finite ? 1 / std::max(depth, 1e-6f) : 0;
  const PointMap::Point p =
      to_before.forward.Apply(static_cast<float>(x), static_cast<float>(y), g);
  before_x = p.x;
  before_y = p.y;
  return p.w > 0;
}

}  // namespace

CameraMatrices CameraAt(const Clip& clip, CameraSchedule schedule, int every, double time) {
  const int step = schedule == CameraSchedule::kBetween ? every : 1;
  const double whole = std::round(time / step) * step;
  const int last = (static_cast<int>(clip.frames.size()) - 1) / step * step;
  if (time == whole && time <= last) return CameraOf(clip, static_cast<int>(whole));
  const int first =
      std::clamp(static_cast<int>(std::floor(time / step)) * step, 0, std::max(last - step, 0));
  return CameraBetween(CameraOf(clip, first), CameraOf(clip, first + step), (time - first) / step);
}

ReprojectionSource::ReprojectionSource(const Clip& clip, CameraSchedule schedule, int every,
                                       bool references)
    : clip_(clip), schedule_(schedule), every_(every), references_(references) {
  const GridSize grid = references ? clip.output : clip.render;
  moving_ = ImageBuffer(grid.width, grid.height, PixelFormat::kR32F);
  drawn_moving_ = ImageBuffer(grid.width, grid.height, PixelFormat::kR32F);
  drawn_ = ImageBuffer(grid.width, grid.height, Color(0).view().format);
  reprojection_.depth_unit = references ? clip.reference_depth_unit : clip.depth_unit;
}

const ImageBuffer& ReprojectionSource::Color(int frame) const {
  const ClipFrame& f = clip_.frames[static_cast<std::size_t>(frame)];
  return references_ ? f.reference : f.color;
}

void ReprojectionSource::FindMoving(int frame, const MutableImageView& moving) const {
  for (int y = 0; y < moving.height; ++y) {
    std::fill_n(moving.Row<float>(y), moving.width, 0.0f);
  }
  const ClipFrame& now = clip_.frames[static_cast<std::size_t>(frame)];
  if (now.cut || frame < every_) return;
  Reprojection step;
  step.source = CameraOf(clip_, frame);
  step.generated = CameraOf(clip_, frame - every_);
  step.depth_unit = reprojection_.depth_unit;
  const auto carrier = PointCarrier::Of(step, moving.width, moving.height);
  if (!carrier) return;
  const ImageView depth = (references_ ? now.reference_depth : now.depth).view();
  const MotionView motion = (references_ ? now.reference_motion : now.motion).view();
  for (int y = 0; y < moving.height; ++y) {
    const float* m = motion.Row(y);
    for (int x = 0; x < moving.width; ++x) {
      float before_x, before_y;
      if (!WasAt(*carrier, x, y, depth.Row<float>(y)[x], before_x, before_y)) continue;
      const float off_x = std::abs(static_cast<float>(x) - m[2 * x] - before_x);
      const float off_y = std::abs(static_cast<float>(y) - m[2 * x + 1] - before_y);
      if (!(std::max(off_x, off_y) > kUnexplainedMotion)) continue;
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, moving.height - 1); ++j) {
        float* row = moving.Row<float>(j);
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, moving.width - 1); ++i) row[i] = 1;
      }
    }
  }
}

const Reprojection& ReprojectionSource::At(int source, double time) {
  Reprojection& r = reprojection_;
  r.source = CameraOf(clip_, source);
  r.generated = r.source;
  r.moving = {};
  r.drawn = {};
  const auto count = static_cast<double>(clip_.frames.size());
  const double next = schedule_ == CameraSchedule::kBetween ? source + every_ : std::ceil(time);
  if (next < count && clip_.frames[static_cast<std::size_t>(next)].cut) return r;
  r.generated = CameraAt(clip_, schedule_, every_, time);
  if (time != std::round(time) || time < every_ || time >= count) return r;
  const int frame = static_cast<int>(time);
  FindMoving(source, moving_.view());
  FindMoving(frame, drawn_moving_.view());
  const ImageView color = Color(frame).view();
  const MutableImageView drawn = drawn_.view();
  for (int y = 0; y < drawn.height; ++y) {
    const float* moves = drawn_moving_.view().Row<float>(y);
    for (int x = 0; x < drawn.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        StoreChannel(drawn.format, LoadChannel(color.format, color.At(x, y), c), drawn.At(x, y), c);
      }
      StoreChannel(drawn.format, moves[x] * ChannelScale(drawn.format), drawn.At(x, y), 3);
    }
  }
  r.moving = std::as_const(moving_).view();
  r.drawn = std::as_const(drawn_).view();
  return r;
}

}  // namespace warplut
