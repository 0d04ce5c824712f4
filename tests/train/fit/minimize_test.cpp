#include "train/fit/minimize.h"

#include <gtest/gtest.h>

#include "train/fit/objective/mlp_objective.h"
#include "train/fit/objective/warp_objective.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

// Both optimizers, on a small objective from one start.
class Minimize : public testing::Test {
 protected:
  std::vector<BorderedPlane> Crops() {
    std::vector<BorderedPlane> crops;
    for (std::uint64_t i = 0; i < 2; ++i) crops.push_back(ToPlane(NoiseImage(64, 64, 20 + i)));
    return crops;
  }
  WarpObjective warp_{Crops(), {2, 4}, 5, {.power = 8}};
  MlpObjective objective_{warp_, 1.02, kGainPenaltyFactor};
  std::vector<double> parameters_ = RandomParameters(1);
  const MinimizeCallback go_on_ = [](const double*, double) { return true; };
};

TEST_F(Minimize, LbfgsDescendsAndEndsAtItsBestPoint) {
  const double start = objective_.Evaluate(parameters_.data(), nullptr);
  std::vector<double> values;
  MinimizeLbfgs(
      objective_, 15,
      [&](const double*, double value) {
        values.push_back(value);
        return true;
      },
      parameters_);
  ASSERT_FALSE(values.empty());
  EXPECT_LT(values.back(), start);
  EXPECT_EQ(objective_.Evaluate(parameters_.data(), nullptr), values.back());
}

TEST_F(Minimize, LbfgsStopsWhenTold) {
  int calls = 0;
  MinimizeLbfgs(
      objective_, 50, [&](const double*, double) { return ++calls < 3; }, parameters_);
  EXPECT_EQ(calls, 3);
}

TEST_F(Minimize, AdamTakesTheStepsOfItsFormula) {
  std::vector<double> gradient(kMlpParameters);
  objective_.Evaluate(parameters_.data(), gradient.data());
  const std::vector<double> start = parameters_;
  AdamState state;
  MinimizeAdam(objective_, 1, go_on_, state, parameters_);
  EXPECT_EQ(state.step, 1);
  for (int p = 0; p < kMlpParameters; p += 101) {
    // The first step: mean and variance corrected are the gradient and its square.
    const double expected =
        kAdamLearningRate * gradient[p] / (std::abs(gradient[p]) + kAdamEpsilon);
    EXPECT_NEAR(start[p] - parameters_[p], expected, 1e-12);
  }
}

TEST_F(Minimize, AdamGoesOnFromItsState) {
  std::vector<double> apart = parameters_;
  AdamState whole_state, parts_state;
  MinimizeAdam(objective_, 6, go_on_, whole_state, parameters_);
  MinimizeAdam(objective_, 2, go_on_, parts_state, apart);
  MinimizeAdam(objective_, 4, go_on_, parts_state, apart);
  EXPECT_EQ(parameters_, apart);
}

}  // namespace
}  // namespace warplut
