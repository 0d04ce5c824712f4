// The Keys kernels as weights, and the search among them: the baseline that a fit must beat.
#pragma once

#include <vector>

#include "train/fit/objective/canonical_nodes.h"

namespace warplut {

class Objective;

// The weights of the Keys kernel at the canonical nodes.
CanonicalWeights<double> KeysCanonicalWeights(double a);

// The Keys parameters that are looked at when a best one is wanted.
inline constexpr double kKeysFirst = -0.50;
inline constexpr double kKeysLast = -0.86;
inline constexpr double kKeysStep = 0.02;

// What a Keys kernel loses (Objective::Losses).
struct KeysLoss {
  double a = 0;
  std::vector<double> losses;
};

// The losses of each of these kernels, in order.
std::vector<KeysLoss> KeysLosses(const Objective& objective);

// The parameter a of the Keys kernel with the least L.
double FitKeys(const Objective& objective);

}  // namespace warplut
