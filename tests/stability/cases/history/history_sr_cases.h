// Cases of the closed loop of super resolution: every method of the registry that keeps a history,
// with the shipped table.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult SrStaticImage(StabilityEffort effort);
StabilityResult SrStaticImageInFloat(StabilityEffort effort);
StabilityResult SrJitterCycle(StabilityEffort effort);
StabilityResult SrConstantImage(StabilityEffort effort);
StabilityResult SrPan(StabilityEffort effort);
StabilityResult SrFlicker(StabilityEffort effort);
StabilityResult SrFlickerOfResidualForm(StabilityEffort effort);

}  // namespace warplut
