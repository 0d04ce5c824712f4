#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/peers/generation/bidirectional.h"

namespace warplut::peers {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// From p = q - start.
Reprojection Iterate(const GenerationJob& job, const MovingFrame& frame, int x, int y,
                     Vector start) {
  Reprojection found{start, kInfinity};
  Vector last = start;
  for (int i = 0; i <= kIterations; ++i) {
    const PixelIndex p = NearestPixel(job, x, y, {-found.motion.x, -found.motion.y});
    if (p.x < 0) return {{}, kInfinity};
    const Vector m = MotionAt(frame.motion, p.x, p.y);
    if (!IsFinite(m)) return {{}, kInfinity};
    last = frame.share * m;
    if (i < kIterations) found.motion = last;
  }
  found.miss = std::max(std::abs(last.x - found.motion.x), std::abs(last.y - found.motion.y));
  return found;
}

}  // namespace

Reprojection Reproject(const GenerationJob& job, const MovingFrame& frame, const MovingFrame& other,
                       int x, int y) {
  const Reprojection first = Iterate(job, frame, x, y, {});
  if (first.miss <= job.options.parameters.bidir_tolerance) return first;
  const Vector m = MotionAt(other.motion, x, y);
  const Reprojection second = Iterate(job, frame, x, y, IsFinite(m) ? frame.share * m : Vector{});
  return second.miss < first.miss ? second : first;
}

TargetMotion BidirectionalMotionAt(const GenerationJob& job, int x, int y) {
  const bool both = job.CountsMotion0();
  const Reprojection to1 = Reproject(job, Frame1(job), both ? Frame0(job) : Frame1(job), x, y);
  Reprojection to0 = {BackwardShare(job.alpha) * to1.motion, to1.miss};
  if (both) to0 = Reproject(job, Frame0(job), Frame1(job), x, y);
  const float tolerance = job.options.parameters.bidir_tolerance;
  const bool counts0 = to0.miss <= tolerance, counts1 = to1.miss <= tolerance;
  bool takes0 = counts0 || (!counts1 && to0.miss <= to1.miss);
  bool takes1 = counts1 || (!counts0 && to1.miss <= to0.miss);
  const PixelIndex p0 = NearestPixel(job, x, y, {-to0.motion.x, -to0.motion.y});
  const PixelIndex p1 = NearestPixel(job, x, y, {-to1.motion.x, -to1.motion.y});
  if (both && counts0 && counts1 && p0.x >= 0 && p1.x >= 0) {
    const float z0 = DepthAt(job.depth0, p0.x, p0.y), z1 = DepthAt(job.depth1, p1.x, p1.y);
    if (!DepthTolerance(job).Alike(z0, z1)) {
      takes0 = z0 < z1;
      takes1 = !takes0;
    }
  }
  constexpr Vector kNotTaken = {kOutside, kOutside};
  return {takes0 ? to0.motion : kNotTaken, takes1 ? to1.motion : kNotTaken, !counts0 && !counts1};
}

void BidirectionalRowReference(const GenerationJob& job, int y, const MutableMotionView& from0,
                               const MutableMotionView& from1) {
  for (int x = 0; x < job.width(); ++x) {
    const TargetMotion motion = BidirectionalMotionAt(job, x, y);
    SetMotion(from0, x, y, motion.from0);
    SetMotion(from1, x, y, motion.from1);
  }
}

}  // namespace warplut::peers
