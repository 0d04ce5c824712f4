// What the optimizers minimise: objective `warp` and the bound on gain, as a function of the MLP's
// parameters.
//
//   J(theta) = L(w(theta)) + kGainPenaltyFactor * P(w(theta))
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "train/gain_penalty.h"
#include "train/head_batch.h"
#include "train/warp_objective.h"

namespace warplut {

// High enough that what is left above the bound is of the order of 1e-3.
inline constexpr double kGainPenaltyFactor = 2.0;

class MlpObjective {
 public:
  // `warp` must outlive this.
  MlpObjective(const WarpObjective& warp, double gain_bound) : warp_(warp), penalty_(gain_bound) {}

  // J(parameters), and its gradient where `gradient` is not null; kMlpParameters values each.
  // Counts evaluations.
  double Evaluate(const double* parameters, double* gradient);

  const CanonicalWeights<double>& WeightsOf(const double* parameters) {
    return head_.Forward(parameters);
  }
  const GainPenalty& penalty() const { return penalty_; }
  std::int64_t evaluations() const { return evaluations_; }

 private:
  const WarpObjective& warp_;
  GainPenalty penalty_;
  HeadBatch head_;
  std::int64_t evaluations_ = 0;
};

// Random starting parameters: layers uniform with variance 2 / (in + out) (Glorot and Bengio 2010),
// the last one scaled by kLastLayerScale so that the start lies near the head's base kernel; biases
// 0.
std::vector<double> RandomParameters(std::uint64_t seed);

inline constexpr double kLastLayerScale = 0.1;

}  // namespace warplut
