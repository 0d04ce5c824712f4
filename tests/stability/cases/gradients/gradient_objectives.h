// Gradients of rollouts and of what a training minimises.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult RolloutGradient(StabilityEffort effort);
StabilityResult RolloutGradientOfContent(StabilityEffort effort);
StabilityResult RolloutGradientOfWeights(StabilityEffort effort);
StabilityResult RolloutGradientAtOffsets(StabilityEffort effort);
StabilityResult WarpObjectiveGradient(StabilityEffort effort);
StabilityResult SrObjectiveGradient(StabilityEffort effort);
StabilityResult TrainingGradient(StabilityEffort effort);

}  // namespace warplut
