// Cases of motion, depth and colour that no renderer should give, for every method of the registry
// and for the warp.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult WarpOddMotion(StabilityEffort effort);
StabilityResult WarpFarMotion(StabilityEffort effort);
StabilityResult MotionNotFinite(StabilityEffort effort);
StabilityResult MotionOfAMillionPixels(StabilityEffort effort);
StabilityResult MotionWild(StabilityEffort effort);
StabilityResult MotionFilterWild(StabilityEffort effort);
StabilityResult MotionFilterUpsampledWild(StabilityEffort effort);
StabilityResult DepthNotFinite(StabilityEffort effort);
StabilityResult DepthAllEqual(StabilityEffort effort);
StabilityResult DepthReversed(StabilityEffort effort);
StabilityResult ColorNotFinite(StabilityEffort effort);

}  // namespace warplut
