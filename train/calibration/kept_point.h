// The point that a calibration keeps: between the optimum of its clips and the base, as near to the
// base as the data allows.
#pragma once

#include <vector>

#include "train/calibration/pattern_search.h"

namespace warplut {

struct KeptPoint {
  Candidate at;               // its loss: of the data alone
  double standard_error = 0;  // of its loss minus the optimum's
  std::vector<bool> at_base;  // for each coordinate: the data does not tell it from the base
};

// The loss of a minus that of b, from their residuals, and its standard error: differences are
// paired, residual by residual, and independent, or, if that is more, independent between sources
// only; with one source the former.
struct LossDifference {
  double mean = 0;
  double standard_error = 0;
};
LossDifference CompareLosses(const std::vector<double>& a, const std::vector<double>& b,
                             const std::vector<int>& sources);

// 1. The base, if its loss is more than the optimum's by no more than one standard error: the
//    one-standard-error rule of Breiman, Friedman, Olshen and Stone, "Classification and Regression
//    Trees", 1984, section 3.4.3.
// 2. Otherwise the least loss times PriorFactor, over the way from the base to the optimum and
//    around the best point of it: what a few clips ask for is not what all content asks for. From
//    there each coordinate, cheapest first, goes to the base as long as the loss grows by no more
//    than one standard error.
// 3. If the loss is more than `most_loss`, back towards the optimum until it is not. The loss is
//    never more than at the base. `sources`: of each residual (ResidualFunction::Source).
//    `most_loss` is at least the optimum's. Stops early with the log.
KeptPoint KeepNearBase(RunLog& log, const SearchSpace& space, const std::vector<int>& sources,
                       const Candidate& base, const Candidate& optimum, double most_loss);

}  // namespace warplut
