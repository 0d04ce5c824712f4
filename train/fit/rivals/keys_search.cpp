#include "train/fit/rivals/keys_search.h"

#include <cmath>
#include <limits>

#include "luts/filters.h"
#include "train/fit/objective/objective.h"

namespace warplut {
namespace {

int KeysCount() { return static_cast<int>(std::lround((kKeysFirst - kKeysLast) / kKeysStep)) + 1; }
double KeysAt(int i) { return kKeysFirst - i * kKeysStep; }

}  // namespace

CanonicalWeights<double> KeysCanonicalWeights(double a) {
  CanonicalWeights<double> weights{};
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    weights[c] = KeysWeights(a, NodeOffset(i), NodeOffset(j));
  }
  return weights;
}

std::vector<KeysLoss> KeysLosses(const Objective& objective) {
  std::vector<KeysLoss> losses;
  losses.reserve(static_cast<std::size_t>(KeysCount()));
  for (int i = 0; i < KeysCount(); ++i) {
    losses.push_back({KeysAt(i), objective.Losses(KeysCanonicalWeights(KeysAt(i)))});
  }
  return losses;
}

double FitKeys(const Objective& objective) {
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < KeysCount(); ++i) {
    const double value = objective.Evaluate(KeysCanonicalWeights(KeysAt(i)));
    if (value < least) {
      least = value;
      best = KeysAt(i);
    }
  }
  return best;
}

}  // namespace warplut
