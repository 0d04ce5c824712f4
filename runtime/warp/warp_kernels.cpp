#include "runtime/warp/warp_kernels.h"

#include "runtime/core/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/warp/warp_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "runtime/warp/uniform_motion-inl.h"
#include "runtime/warp/warp_general-inl.h"
#include "runtime/warp/warp_uniform-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
// Without vectors of four floats the formula itself is the kernel.
bool UniformMotion(const MotionView& motion, const TileRect& pixels) {
  const float* first = motion.Row(pixels.y0) + 2 * pixels.x0;
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    const float* row = motion.Row(y) + 2 * pixels.x0;
    for (int i = 0; i < 2 * pixels.width(); ++i) {
      if (!(row[i] == first[i % 2])) return false;
    }
  }
  return true;
}

void General(const WarpJob& job, const TileRect& pixels) { WarpReferencePixels(job, pixels); }

void Uniform(const WarpJob& job, const TileRect& pixels, float, float) {
  WarpReferencePixels(job, pixels);
}
#endif

const char* TargetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace warplut {

HWY_EXPORT(UniformMotion);
HWY_EXPORT(General);
HWY_EXPORT(Uniform);
HWY_EXPORT(TargetName);

bool IsUniform(const MotionView& motion, const TileRect& pixels) {
  return HWY_DYNAMIC_DISPATCH(UniformMotion)(motion, pixels);
}

void WarpGeneral(const WarpJob& job, const TileRect& pixels) {
  HWY_DYNAMIC_DISPATCH(General)(job, pixels);
}

void WarpUniform(const WarpJob& job, const TileRect& pixels, float mx, float my) {
  HWY_DYNAMIC_DISPATCH(Uniform)(job, pixels, mx, my);
}

const char* WarpTarget() { return HWY_DYNAMIC_DISPATCH(TargetName)(); }

}  // namespace warplut
#endif  // HWY_ONCE
