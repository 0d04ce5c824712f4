// Trainings on little, repeated or far-reaching data, and on one or two threads.
#pragma once

#include "tools/stability/stability_case.h"

namespace warplut {

StabilityResult TrainOnDuplicates(StabilityEffort effort);
StabilityResult TrainOnOneImage(StabilityEffort effort);
StabilityResult TrainOnThreads(StabilityEffort effort);
StabilityResult TrainOverHorizons(StabilityEffort effort);

}  // namespace warplut
