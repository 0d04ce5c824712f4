#include "train/rollout.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/train/noise_image.h"
#include "train/warp_objective.h"

namespace warplut {
namespace {

constexpr std::array<int, 2> kHorizons = {4, 10};

struct Case {
  BorderedPlane image = ToPlane(NoiseImage(64, 48, 6));
  Ssim ssim{InnerView(image)};
  std::vector<RolloutStep> steps = ToSteps(MakeTrajectory(Offsets::kRandom, kHorizons, kNodes, 3));
  RolloutWorkspace workspace{64, 48, 10};

  std::array<double, 2> Losses(const CanonicalWeights<double>& weights) {
    std::array<double, 2> losses{};
    workspace.Forward(image, ssim, steps, kHorizons, weights, losses);
    return losses;
  }
};

TEST(Rollout, StepsSplitDisplacementsIntoCellAndNode) {
  const std::vector<Displacement> displacements = {{0.25, -0.25}, {-0.5, 0.5}, {0, 0}};
  const auto steps = ToSteps(displacements);
  // Sampled at p - v: -0.25 lies in cell -1 at 0.75, 0.25 in cell 0 at 0.25.
  EXPECT_EQ(steps[0].cell_x, -1);
  EXPECT_EQ(steps[0].cell_y, 0);
  EXPECT_EQ(steps[0].node.index, ToCanonical(24, 8).index);
  EXPECT_EQ(steps[1].cell_x, 0);
  EXPECT_EQ(steps[1].cell_y, -1);
  EXPECT_EQ(steps[2].node.index, 0);
  EXPECT_EQ(steps[2].cell_x, 0);
}

TEST(Rollout, TheExactFilterOfWholeShiftsLosesNothing) {
  Case c;
  c.steps.assign(10, {ToCanonical(0, 0), 0, 0});
  for (const double loss : c.Losses(KeysCanonicalWeights(-0.5))) EXPECT_NEAR(loss, 0, 2e-6);
}

TEST(Rollout, SharperKeysLosesLessThanBilinearLike) {
  Case c;
  EXPECT_LT(c.Losses(KeysCanonicalWeights(-0.6))[1], c.Losses(KeysCanonicalWeights(-0.1))[1]);
}

TEST(Rollout, GradientEqualsDifferences) {
  Case c;
  CanonicalWeights<double> weights = KeysCanonicalWeights(-0.55);
  const std::array<double, 2> factors = {1.0, 0.5};
  c.Losses(weights);
  CanonicalWeights<double> gradient{};
  c.workspace.Backward(c.image, c.ssim, c.steps, kHorizons, factors, weights, gradient);
  const auto total = [&] {
    const auto losses = c.Losses(weights);
    return factors[0] * losses[0] + factors[1] * losses[1];
  };
  for (const std::size_t step : {0u, 3u, 7u}) {
    const int node = c.steps[step].node.index;
    for (const int k : {0, 5, 6, 10, 13}) {
      const double saved = weights[node][k];
      const double h = 1e-3;
      weights[node][k] = saved + h;
      const double above = total();
      weights[node][k] = saved - h;
      const double below = total();
      weights[node][k] = saved;
      const double expected = (above - below) / (2 * h);
      EXPECT_NEAR(gradient[node][k], expected, 0.01 * std::abs(expected) + 2e-3);
    }
  }
}

}  // namespace
}  // namespace warplut
