#include <algorithm>

#include "runtime/generation/motion/motion_model.h"
#include "runtime/generation/motion/surface_before.h"
#include "runtime/generation/splat.h"

namespace warplut::generation {

namespace {

constexpr Vector kNowhere = {std::numeric_limits<float>::quiet_NaN(),
                             std::numeric_limits<float>::quiet_NaN()};

Vector PerspectiveDisplacement(const GenerationJob& job, int x, int y, Vector m1) {
  const SurfaceBefore before = FindSurfaceBefore(job, x, y, m1);
  const PerspectivePath<float> path{job.time(), before.ratio};
  if (!(path.Depth() >= kLeastDepthRatio)) return kNowhere;
  const float gate = path.DepthBefore() > 0.0f ? before.gate : 0.0f;
  const Vector displacement = {path.Displacement(m1.x, before.motion.x, gate),
                               path.Displacement(m1.y, before.motion.y, gate)};
  return IsFinite(displacement) ? displacement : kNowhere;
}

}  // namespace

Vector ForwardDisplacement(const GenerationJob& job, int x, int y) {
  const Vector m1 = MotionAt(job.motion1, x, y);
  if (!IsFinite(m1)) return kNowhere;
  if (job.FollowsPerspective()) return PerspectiveDisplacement(job, x, y, m1);
  Vector m0 = m1;
  const PixelIndex p0 = NearestPixel(job, x, y, {-m1.x, -m1.y});
  if (job.CountsMotion0() && p0.x >= 0 && IsFinite(MotionAt(job.motion0, p0.x, p0.y))) {
    const float difference = DepthDifference(DepthOf(job.options), DepthAt(job.depth0, p0.x, p0.y),
                                             DepthAt(job.depth1, x, y));
    const float gate = Gate(std::abs(difference), job.depth_threshold(), job.options.gate_width);
    m0 = m1 + gate * (MotionAt(job.motion0, p0.x, p0.y) - m1);
  }
  if (job.Interpolates()) {
    return {InterpolatedDisplacement(m1.x, m0.x, job.alpha),
            InterpolatedDisplacement(m1.y, m0.y, job.alpha)};
  }
  return {ExtrapolatedDisplacement(m1.x, m0.x, job.alpha),
          ExtrapolatedDisplacement(m1.y, m0.y, job.alpha)};
}

RowRange ForwardRowReference(const GenerationJob& job, int y, const MutableMotionView& forward) {
  RowRange range{job.height(), 0};
  for (int x = 0; x < job.width(); ++x) {
    const Vector displacement = ForwardDisplacement(job, x, y);
    SetMotion(forward, x, y, displacement);
    const PixelIndex q = NearestPixel(job, x, y, displacement);
    if (q.x < 0) continue;
    range = {std::min(range.first, q.y), std::max(range.last, q.y + 1)};
  }
  return range;
}

void SplatRowReference(const GenerationJob& job, const MotionView& forward, int y, RowRange target,
                       const KeyView& keys) {
  const auto width = static_cast<std::uint32_t>(job.width());
  for (int x = 0; x < job.width(); ++x) {
    const PixelIndex q = NearestPixel(job, x, y, MotionAt(forward, x, y));
    if (q.x < 0 || q.y < target.first || q.y >= target.last) continue;
    const auto source = static_cast<std::uint32_t>(y) * width + static_cast<std::uint32_t>(x);
    SplatKey& kept = keys.Row(q.y)[q.x];
    kept = std::min(kept, MakeSplatKey(DepthAt(job.depth1, x, y), source));
  }
}

}  // namespace warplut::generation
