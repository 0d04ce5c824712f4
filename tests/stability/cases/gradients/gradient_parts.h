// Gradients of the parts: SSIM, the head and its MLP, the penalty on gain, the differences of the
// calibration.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult SsimGradient(StabilityEffort effort);
StabilityResult HeadGradient(StabilityEffort effort);
StabilityResult HeadGradientSaturated(StabilityEffort effort);
StabilityResult HeadGradientTiny(StabilityEffort effort);
StabilityResult HeadGradientAtExtremeOffsets(StabilityEffort effort);
StabilityResult GainPenaltyGradient(StabilityEffort effort);
StabilityResult CalibrationDifferences(StabilityEffort effort);

}  // namespace warplut
