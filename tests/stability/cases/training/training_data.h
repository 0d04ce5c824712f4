// Trainings on little, repeated or far-reaching data, and on one or two threads.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult TrainOnDuplicates(StabilityEffort effort);
StabilityResult TrainOnOneImage(StabilityEffort effort);
StabilityResult TrainOnThreads(StabilityEffort effort);
StabilityResult TrainOverHorizons(StabilityEffort effort);

}  // namespace warplut
