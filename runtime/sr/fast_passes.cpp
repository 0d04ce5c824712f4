#include "runtime/core/instruction_sets.h"
#include "runtime/sr/passes.h"
#include "runtime/sr/reference.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/sr/fast_passes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "runtime/sr/update-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

const SrPasses& PassesOfTarget() {
#if HWY_TARGET == HWY_SCALAR
  return ReferencePasses();  // without vectors the formulas are the kernels
#else
  constexpr bool kResidual = kContainsHistory && kPipeline.sr.form != HistoryForm::kSample;
  constexpr bool kDepthGate = kContainsHistory && kPipeline.sr.depth != DepthMeasure::kNone &&
                              kPipeline.sr.motion != MotionUpsampling::kStatic;
  static constexpr SrPasses kPasses = {FillPlanes,
                                       Geometry,
                                       Predict,
                                       kResidual ? Residual : nullptr,
                                       Update,
                                       kDepthGate ? DepthRange : nullptr,
                                       kContainsHistory ? ReactiveReach : nullptr,
                                       false};
  return kPasses;
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace warplut {

HWY_EXPORT(PassesOfTarget);

const SrPasses& FastPasses() { return HWY_DYNAMIC_DISPATCH(PassesOfTarget)(); }

}  // namespace warplut
#endif  // HWY_ONCE
