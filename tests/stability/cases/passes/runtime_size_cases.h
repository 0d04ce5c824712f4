// Cases of sizes and scale factors, for the warp and every method of the registry.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult WarpSizes(StabilityEffort effort);
StabilityResult SmallSizes(StabilityEffort effort);
StabilityResult OddSizes(StabilityEffort effort);
StabilityResult WideSizes(StabilityEffort effort);
StabilityResult Scales(StabilityEffort effort);
StabilityResult ConstantAtAnySize(StabilityEffort effort);

}  // namespace warplut
