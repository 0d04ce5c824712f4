// Cases of repeated warps, alone and with a plain blend, against the certificate of the shipped
// tables.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult WarpOfStaticImage(StabilityEffort effort);
StabilityResult WarpOfConstantImage(StabilityEffort effort);
StabilityResult WarpOfWorstWave(StabilityEffort effort);
StabilityResult WarpPan(StabilityEffort effort);
StabilityResult LoopOfWorstWave(StabilityEffort effort);
StabilityResult LoopPan(StabilityEffort effort);
StabilityResult LoopFlicker(StabilityEffort effort);
StabilityResult LoopConstant(StabilityEffort effort);

}  // namespace warplut
