#include "train/mlp_objective.h"

#include <cmath>

#include "train/random.h"

namespace warplut {

double MlpObjective::Evaluate(const double* parameters, double* gradient) {
  ++evaluations_;
  const CanonicalWeights<double>& weights = head_.Forward(parameters);
  CanonicalWeights<double> weight_gradient{};
  double value = objective_.Evaluate(weights, gradient != nullptr ? &weight_gradient : nullptr);
  value += penalty_factor_ * penalty_.AddGradient(weights, penalty_factor_, weight_gradient);
  if (gradient != nullptr) head_.Backward(parameters, weight_gradient, gradient);
  return value;
}

std::vector<double> RandomParameters(std::uint64_t seed) {
  std::vector<double> parameters(kMlpParameters, 0.0);
  Random random(seed);
  for (int layer = 0; layer < kMlpLayers; ++layer) {
    const int n_in = kMlpWidths[layer];
    const int n_out = kMlpWidths[layer + 1];
    double reach = std::sqrt(6.0 / (n_in + n_out));
    if (layer + 1 == kMlpLayers) reach *= kLastLayerScale;
    double* weight = parameters.data() + MlpLayerOffset(layer);
    for (int i = 0; i < n_in * n_out; ++i) weight[i] = reach * (2 * random.Uniform() - 1);
  }
  return parameters;
}

}  // namespace warplut
