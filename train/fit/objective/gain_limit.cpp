#include "train/fit/objective/gain_limit.h"

#include <algorithm>
#include <cmath>

#include "luts/certificate/certificate.h"
#include "luts/certificate/gain.h"
#include "luts/filters.h"
#include "train/fit/rivals/kaiser_family.h"
#include "train/fit/rivals/keys_search.h"
#include "train/fit/rivals/spline_family.h"
#include "train/fit/train_options.h"

namespace warplut {
namespace {

constexpr int kHalvings = 10;

// The mix of the weights of one node and its base.
class NodeMix {
 public:
  NodeMix(const Weights<double>& base, const Weights<double>& weights, const Prefilter& prefilter)
      : base_(base), weights_(weights), prefilter_(prefilter) {}

  double GainAtShare(double share) const {
    Weights<double> mixed{};
    for (int k = 0; k < kWeights; ++k) mixed[k] = base_[k] + share * (weights_[k] - base_[k]);
    return MaxGain(mixed, prefilter_).gain;
  }

  // The largest share that keeps the limit, from below. The line from the base's gain at 0 to
  // `gain` at 1 lies above the gain: the search begins where it meets the limit.
  double LargestShare(double base_gain, double gain, double limit) const {
    double low = (limit - base_gain) / (gain - base_gain), high = 1;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2;
      (GainAtShare(middle) <= limit ? low : high) = middle;
    }
    return low;
  }

 private:
  const Weights<double>& base_;
  const Weights<double>& weights_;
  const Prefilter& prefilter_;
};

// Of `mlp_size` parameters.
void ScaleLastLayer(double share, int mlp_size, std::vector<double>& parameters) {
  std::for_each(parameters.begin() + MlpLayerOffset(kMlpLayers - 1), parameters.begin() + mlp_size,
                [&](double& p) { p *= share; });
}

// Weights alone are mixed, each node for itself.
double LimitWeights(double limit, ResamplerModel& model, std::vector<double>& parameters) {
  const Resampler resampler = model.ForwardStored(parameters.data());
  const Prefilter prefilter = Rounded(resampler.prefilter);
  const bool with_prefilter = HasPrefilter(prefilter);
  const bool wide = resampler.footprint != Footprint::k16;
  const CanonicalWeights<double> base =
      with_prefilter ? SplineResampler(resampler.prefilter).weights
      : wide         ? WideBase(resampler.footprint, model.kaiser_b()).weights
                     : KeysCanonicalWeights(kCatmullRomA);
  double share = 1;
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const double gain = MaxGain(resampler.weights[c], prefilter).gain;
    if (gain <= limit) continue;
    const NodeMix mix(base[c], resampler.weights[c], prefilter);
    const double base_gain = with_prefilter || wide ? mix.GainAtShare(0) : 1;
    share = std::min(share, mix.LargestShare(base_gain, gain, limit));
  }
  if (share < 1) ScaleLastLayer(share, model.mlp_size(), parameters);
  return share;
}

double LimitFir(double limit, ResamplerModel& model, std::vector<double>& parameters) {
  const RealPrefilter trained = model.map().At(parameters.data() + kMlpParameters);
  const std::vector<double> start =
      model.map().NumbersOf(FirPrefilter(trained.side, trained.reach));
  const auto mixed = [&](double share) {
    std::vector<double> result = parameters;
    ScaleLastLayer(share, kMlpParameters, result);
    for (int j = 1; j <= trained.reach; ++j) {
      double& tap = result[static_cast<std::size_t>(kMlpParameters + j)];
      tap = std::lerp(start[static_cast<std::size_t>(j)], tap, share);
    }
    return result;
  };
  const auto keeps = [&](const std::vector<double>& candidate) {
    const Resampler& resampler = model.ForwardStored(candidate.data());
    return IsValid(Rounded(resampler.prefilter)) && LargestNodeGain(resampler) <= limit;
  };
  if (keeps(parameters)) return 1;
  double low = 0, high = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (keeps(mixed(middle)) ? low : high) = middle;
  }
  parameters = mixed(low);
  return low;
}

}  // namespace

double LargestGain(double gain_bound) {
  return std::max(std::pow(gain_bound, 1 / (1 - kGrowthReserve)), 1 + kUnitGainTolerance);
}

double LimitGain(double limit, ResamplerModel& model, std::vector<double>& parameters) {
  return model.map().kind() == PrefilterKind::kFir ? LimitFir(limit, model, parameters)
                                                   : LimitWeights(limit, model, parameters);
}

}  // namespace warplut
