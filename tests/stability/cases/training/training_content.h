// Trainings on extreme images.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult TrainOnConstant(StabilityEffort effort);
StabilityResult TrainOnBlack(StabilityEffort effort);
StabilityResult TrainOnWhite(StabilityEffort effort);
StabilityResult TrainOnImpulse(StabilityEffort effort);
StabilityResult TrainOnCheckerboard(StabilityEffort effort);
StabilityResult TrainOnWhiteNoise(StabilityEffort effort);
StabilityResult TrainOnToneMappedHdr(StabilityEffort effort);
StabilityResult TrainOnFlatAndNoise(StabilityEffort effort);
StabilityResult RefuseWhatCannotBeTrained(StabilityEffort effort);

}  // namespace warplut
