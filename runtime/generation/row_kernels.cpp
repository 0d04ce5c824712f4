#include "runtime/generation/row_kernels.h"

#include "runtime/core/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/generation/row_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "runtime/generation/blend-inl.h"
#include "runtime/generation/hdr_rows-inl.h"
#include "runtime/generation/motion/target_motion-inl.h"
#include "runtime/generation/splat-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace warplut::generation {
namespace HWY_NAMESPACE {

RowKernels Kernels() {
#if HWY_TARGET == HWY_SCALAR
  return ReferenceRowKernels();
#else
  constexpr bool kSplats = Contains(kPipeline.generation.splat, true);
  constexpr bool kHdr = Contains(kPipeline.generation.encoding, ColorEncoding::kLinearHdr);
  constexpr bool kTakesOwn = Contains(kPipeline.generation.splat, false);
  return {ForwardRow,
          kSplats ? SplatRow : nullptr,
          kSplats ? TargetMotionRow : nullptr,
          kTakesOwn ? OwnMotionRow : nullptr,
          BlendRow,
          kHdr ? EncodeHdrRow : nullptr,
          kHdr ? DecodeHdrRow : nullptr};
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::generation
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace warplut::generation {

HWY_EXPORT(Kernels);

RowKernels ReferenceRowKernels() {
  // Named, so that the linker can drop it: unnamed constants of a file share a section.
  static constexpr RowKernels kKernels = {
      ForwardRowReference, SplatRowReference,     TargetMotionRowReference, OwnMotionRowReference,
      BlendRowReference,   EncodeHdrRowReference, DecodeHdrRowReference};
  return kKernels;
}

RowKernels FastRowKernels() { return HWY_DYNAMIC_DISPATCH(Kernels)(); }

}  // namespace warplut::generation
#endif  // HWY_ONCE
