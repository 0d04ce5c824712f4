// Trainings from extreme parameters, and what the head makes of extreme offsets and raw values.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult TrainFromSaturated(StabilityEffort effort);
StabilityResult TrainFromTiny(StabilityEffort effort);
StabilityResult OptimumFromSaturated(StabilityEffort effort);
StabilityResult OptimumFromTiny(StabilityEffort effort);
StabilityResult HeadAtExtremeOffsets(StabilityEffort effort);
StabilityResult HeadOfVanishingSum(StabilityEffort effort);

}  // namespace warplut
