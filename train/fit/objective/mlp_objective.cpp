#include "train/fit/objective/mlp_objective.h"

#include <cmath>

#include "train/fit/random.h"

namespace warplut {

double MlpObjective::Evaluate(const double* parameters, double* gradient) {
  ++evaluations_;
  const Resampler& resampler = model_.Forward(parameters);
  Resampler of_resampler;
  double value = objective_.Evaluate(resampler, gradient != nullptr ? &of_resampler : nullptr);
  value += penalty_factor_ * penalty_.AddGradient(resampler, penalty_factor_, of_resampler);
  if (gradient != nullptr) model_.Backward(parameters, of_resampler, gradient);
  return value;
}

std::vector<double> RandomParameters(std::uint64_t seed, Footprint footprint) {
  std::vector<double> parameters(static_cast<std::size_t>(MlpParameters(footprint)), 0.0);
  Random random(seed);
  for (int layer = 0; layer < kMlpLayers; ++layer) {
    const int n_in = MlpWidth(layer, footprint);
    const int n_out = MlpWidth(layer + 1, footprint);
    double reach = std::sqrt(6.0 / (n_in + n_out));
    if (layer + 1 == kMlpLayers) reach *= kLastLayerScale;
    double* weight = parameters.data() + MlpLayerOffset(layer);
    for (int i = 0; i < n_in * n_out; ++i) weight[i] = reach * (2 * random.Uniform() - 1);
  }
  return parameters;
}

}  // namespace warplut
