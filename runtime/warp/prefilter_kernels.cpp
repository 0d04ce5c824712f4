#include "runtime/warp/prefilter_kernels.h"

#include "runtime/core/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/warp/prefilter_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "runtime/warp/prefilter-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

void TileOfTarget(const PrefilterJob& job, const TileRect& pixels) {
#if HWY_TARGET == HWY_SCALAR
  PrefilterReferencePixels(job.prefilter, job.samples, pixels, job.coefficients);
#else
  FilterTile(job, pixels);
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace warplut {

HWY_EXPORT(TileOfTarget);

void PrefilterTile(const PrefilterJob& job, const TileRect& pixels) {
  HWY_DYNAMIC_DISPATCH(TileOfTarget)(job, pixels);
}

}  // namespace warplut
#endif  // HWY_ONCE
