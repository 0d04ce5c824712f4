// Gates from wide to as good as hard, thresholds at the ends, and content that does not show them.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult GateSlope(StabilityEffort effort);
StabilityResult GateAtThresholdZero(StabilityEffort effort);
StabilityResult GateBeyondRange(StabilityEffort effort);
StabilityResult StiffGateSteps(StabilityEffort effort);
StabilityResult GateNarrowing(StabilityEffort effort);
StabilityResult GateNotIdentified(StabilityEffort effort);
StabilityResult GateWithoutOptimum(StabilityEffort effort);

}  // namespace warplut
