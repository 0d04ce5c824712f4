// The optimizers of the training, behind one shape.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "train/fit/parameter_function.h"

namespace warplut {

// Called after every iteration with the parameters and the objective there; returns false to stop.
using MinimizeCallback = std::function<bool(const double* parameters, double value)>;

// L-BFGS with a Wolfe line search (Ceres), at most `iterations` from `parameters`, which receives
// the best point.
void MinimizeLbfgs(ParameterFunction& objective, int iterations, const MinimizeCallback& callback,
                   std::vector<double>& parameters);

// The paper's optimizer, Adam with learning rate 1e-3, betas 0.9 and 0.999, eps 1e-4 (Mob-FGSR
// supplement, section 5), on the full objective; the state is part of what a checkpoint keeps.
struct AdamState {
  std::int64_t step = 0;
  std::vector<double> mean;      // of the gradient
  std::vector<double> variance;  // of the gradient, uncentred
};

inline constexpr double kAdamLearningRate = 1e-3;
inline constexpr double kAdamBeta1 = 0.9;
inline constexpr double kAdamBeta2 = 0.999;
inline constexpr double kAdamEpsilon = 1e-4;

void MinimizeAdam(ParameterFunction& objective, int iterations, const MinimizeCallback& callback,
                  AdamState& state, std::vector<double>& parameters);

}  // namespace warplut
