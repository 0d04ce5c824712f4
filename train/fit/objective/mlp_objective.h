// The function that the optimizers minimise: an objective and the bound on gain, as a function of
// the parameters of a resampler (train/fit/resampler_model.h).
//
//   J(theta) = L(w(theta)) + f P(w(theta)), f the factor of the penalty
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "train/fit/objective/gain_penalty.h"
#include "train/fit/objective/objective.h"
#include "train/fit/parameter_function.h"
#include "train/fit/resampler_model.h"

namespace warplut {

// The factor of the penalty by which weights are finally judged: high enough that what is left
// above the bound is of the order of 1e-4.
inline constexpr double kGainPenaltyFactor = 20.0;

class MlpObjective final : public ParameterFunction {
 public:
  // `objective` must outlive this.
  MlpObjective(const Objective& objective, double gain_bound, double penalty_factor,
               const ResamplerModel& model = ResamplerModel())
      : objective_(objective),
        penalty_(gain_bound, model.footprint()),
        penalty_factor_(penalty_factor),
        model_(model) {}

  // J(parameters). Counts evaluations.
  double Evaluate(const double* parameters, double* gradient) override;

  std::int64_t evaluations() const { return evaluations_; }

 private:
  const Objective& objective_;
  GainPenalty penalty_;
  double penalty_factor_;
  ResamplerModel model_;
  std::int64_t evaluations_ = 0;
};

// Random starting parameters of the MLP: layers uniform with variance 2 / (in + out)
// (Glorot and Bengio 2010), the last one scaled by kLastLayerScale so that the start lies near the
// head's base kernel; biases 0.
std::vector<double> RandomParameters(std::uint64_t seed, Footprint footprint = Footprint::k16);

inline constexpr double kLastLayerScale = 0.1;

}  // namespace warplut
