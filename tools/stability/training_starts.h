// Where trainings from many random starts end, and how curved it is there.
#pragma once

#include "tools/stability/stability_case.h"

namespace warplut {

StabilityResult TrainFromManyStarts(StabilityEffort effort);
StabilityResult GaussNewtonAtTheEnd(StabilityEffort effort);

}  // namespace warplut
