#include <cmath>

#include "train/fit/minimize.h"

namespace warplut {

void MinimizeAdam(ParameterFunction& objective, int iterations, const MinimizeCallback& callback,
                  AdamState& state, std::vector<double>& parameters) {
  state.mean.resize(parameters.size(), 0.0);
  state.variance.resize(parameters.size(), 0.0);
  std::vector<double> gradient(parameters.size());
  for (int i = 0; i < iterations; ++i) {
    const double value = objective.Evaluate(parameters.data(), gradient.data());
    if (!callback(parameters.data(), value)) return;
    ++state.step;
    const double mean_scale = 1 / (1 - std::pow(kAdamBeta1, state.step));
    const double variance_scale = 1 / (1 - std::pow(kAdamBeta2, state.step));
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      double& mean = state.mean[p];
      double& variance = state.variance[p];
      mean += (1 - kAdamBeta1) * (gradient[p] - mean);
      variance += (1 - kAdamBeta2) * (gradient[p] * gradient[p] - variance);
      parameters[p] -= kAdamLearningRate * mean * mean_scale /
                       (std::sqrt(variance * variance_scale) + kAdamEpsilon);
    }
  }
}

}  // namespace warplut
