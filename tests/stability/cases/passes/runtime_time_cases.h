// Cases of times, cuts, disocclusion, gates and ties, for every method of the registry.
#pragma once

#include "tests/stability/cases/stability_case.h"

namespace warplut {

StabilityResult AlphaOutside(StabilityEffort effort);
StabilityResult AlphaNearTheEnds(StabilityEffort effort);
StabilityResult EmptyHistory(StabilityEffort effort);
StabilityResult CutInEachFrame(StabilityEffort effort);
StabilityResult AllDisoccluded(StabilityEffort effort);
StabilityResult AllGatesShut(StabilityEffort effort);
StabilityResult EqualDepthTies(StabilityEffort effort);
StabilityResult EqualDepthOverlap(StabilityEffort effort);

}  // namespace warplut
