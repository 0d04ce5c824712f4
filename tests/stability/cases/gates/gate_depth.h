// The depth gate at the precision of the depth format.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult DepthCodesAsDerived(StabilityEffort effort);
StabilityResult DepthGate16Forward(StabilityEffort effort);
StabilityResult DepthGate16Reversed(StabilityEffort effort);
StabilityResult DepthGate24Forward(StabilityEffort effort);
StabilityResult DepthGate24Reversed(StabilityEffort effort);
StabilityResult DepthGateFloatForward(StabilityEffort effort);
StabilityResult DepthGateFloatReversed(StabilityEffort effort);
StabilityResult DepthGate24Moderate(StabilityEffort effort);

}  // namespace warplut
