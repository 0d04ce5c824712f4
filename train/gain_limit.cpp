#include "train/gain_limit.h"

#include <algorithm>
#include <cmath>

#include "luts/certificate.h"
#include "luts/filters.h"
#include "luts/gain.h"
#include "train/keys_search.h"
#include "train/train_options.h"

namespace warplut {
namespace {

constexpr int kHalvings = 10;

// MaxGain at this share of the residual.
double GainAtShare(const Weights<double>& base, const Weights<double>& weights, double share) {
  Weights<double> mixed{};
  for (int k = 0; k < kWeights; ++k) mixed[k] = base[k] + share * (weights[k] - base[k]);
  return MaxGain(mixed).gain;
}

// The largest share that keeps the limit, from below. The line between gain 1 at 0 and `gain` at 1 lies above the gain: the search
// begins where it meets the limit.
double LargestShare(const Weights<double>& base, const Weights<double>& weights, double gain,
                    double limit) {
  double low = (limit - 1) / (gain - 1), high = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (GainAtShare(base, weights, middle) <= limit ? low : high) = middle;
  }
  return low;
}

}  // namespace

double LargestGain(double gain_bound) {
  return std::max(std::pow(gain_bound, 1 / (1 - kGrowthReserve)), 1 + kUnitGainTolerance);
}

double LimitGain(double limit, HeadBatch& head, std::vector<double>& parameters) {
  const CanonicalWeights<double> base = KeysCanonicalWeights(kCatmullRomA);
  const CanonicalWeights<double>& weights = head.Forward(parameters.data());
  double share = 1;
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const double gain = MaxGain(weights[c]).gain;
    if (gain > limit) {
      share = std::min(share, LargestShare(base[c], weights[c], gain, limit));
    }
  }
  if (share < 1) {
    const auto last = parameters.begin() + MlpLayerOffset(kMlpLayers - 1);
    std::for_each(last, parameters.end(), [&](double& p) { p *= share; });
  }
  return share;
}

}  // namespace warplut
