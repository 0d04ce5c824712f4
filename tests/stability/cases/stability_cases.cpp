#include "tests/stability/cases/stability_case.h"

namespace warplut {

std::vector<StabilityCase> StabilityCases() {
  std::vector<StabilityCase> all;
  for (const std::span<const StabilityCase> group :
       {TrainingCases(), GateCases(), GradientCases(), HistoryCases(), RuntimeCases()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

}  // namespace warplut
