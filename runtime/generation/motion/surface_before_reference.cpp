#include <algorithm>

#include "runtime/generation/motion/surface_before.h"

namespace warplut::generation {

SurfaceBefore FindSurfaceBefore(const GenerationJob& job, int x, int y, Vector m1) {
  const SurfaceBefore none{m1, 1.0f, 0.0f};
  if (NearestPixel(job, x, y, {-m1.x, -m1.y}).x < 0) return none;
  const float right = static_cast<float>(job.width() - 1);
  const float bottom = static_cast<float>(job.height() - 1);
  const float u = std::clamp(static_cast<float>(x) - m1.x, 0.0f, right);
  const float v = std::clamp(static_cast<float>(y) - m1.y, 0.0f, bottom);
  const int left = static_cast<int>(u), top = static_cast<int>(v);
  const float fx = u - static_cast<float>(left), fy = v - static_cast<float>(top);
  const float depth1 = DepthAt(job.depth1, x, y);
  const float weights[4] = {(1.0f - fx) * (1.0f - fy), fx * (1.0f - fy), (1.0f - fx) * fy, fx * fy};
  Vector motion[4];
  float depth[4];
  float anchor = kNoArrivalDepth;
  for (int k = 0; k < 4; ++k) {
    const int i = std::min(left + k % 2, job.width() - 1);
    const int j = std::min(top + k / 2, job.height() - 1);
    motion[k] = MotionAt(job.motion0, i, j);
    depth[k] = DepthAt(job.depth0, i, j);
    if (!(weights[k] > 0.0f) || !IsFinite(motion[k])) continue;
    if (std::abs(depth[k] - depth1) < std::abs(anchor - depth1)) anchor = depth[k];
  }
  float total = 0, inverse = 0;
  Vector sum;
  for (int k = 0; k < 4; ++k) {
    const float tolerance = kSurfaceTolerance * std::min(depth[k], anchor);
    if (!IsFinite(motion[k]) || !(std::abs(depth[k] - anchor) <= tolerance)) continue;
    total += weights[k];
    inverse += weights[k] * (NotZero(anchor) / NotZero(depth[k]));
    sum = sum + weights[k] * motion[k];
  }
  if (!(total > 0.0f)) return none;
  const float share = 1.0f / total;
  const float depth0 = std::min(total / inverse * anchor, kFarthestDepth);
  const float difference = DepthDifference(DepthOf(job.options), depth0, depth1);
  const float gate = Gate(std::abs(difference), job.depth_threshold(), job.options.gate_width);
  if (!(gate > 0.0f)) return none;
  return {share * sum, NotZero(depth0) / NotZero(depth1), gate};
}

}  // namespace warplut::generation
