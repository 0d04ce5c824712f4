// Where trainings from many random starts end, and how curved it is there.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult TrainFromManyStarts(StabilityEffort effort);
StabilityResult GaussNewtonAtTheEnd(StabilityEffort effort);

}  // namespace warplut
