#include "train/fit/objective/warp_objective.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "train/fit/rivals/keys_search.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

WarpObjective Make(std::uint64_t first_seed = 0, const Objective* like = nullptr) {
  std::vector<BorderedPlane> crops;
  for (std::uint64_t i = 0; i < 3; ++i)
    crops.push_back(ToPlane(NoiseImage(64, 64, first_seed + i)));
  return {std::move(crops), {2, 6, 8}, 5, {8, 0.2, 1}, like};
}

TEST(WarpObjective, ProtocolsAreHalfThenRandomThenPan) {
  const WarpObjective objective = Make();
  ASSERT_EQ(objective.protocols().size(), 7u);
  EXPECT_EQ(objective.protocols()[2].warps, 12);  // longer than asked
  EXPECT_EQ(objective.protocols()[1].warps, 6);
  EXPECT_EQ(objective.protocols()[1].offsets, Offsets::kHalf);
  EXPECT_EQ(objective.protocols()[5].offsets, Offsets::kRandom);
  EXPECT_EQ(objective.protocols()[5].warps, 8);
  EXPECT_EQ(objective.protocols()[6].offsets, Offsets::kPan);
  EXPECT_EQ(objective.protocols()[6].warps, kNodes);
}

TEST(WarpObjective, LossesGrowWithTheWarpsAndFromBilinearToKeys) {
  const WarpObjective objective = Make();
  const auto soft = objective.Losses(KeysCanonicalWeights(-0.2));
  const auto keys = objective.Losses(KeysCanonicalWeights(-0.5));
  for (std::size_t i = 0; i < soft.size(); ++i) {
    EXPECT_LT(keys[i], soft[i]);
    if (i % 3 != 0 && i < 6) {
      EXPECT_LT(keys[i - 1], keys[i]);
    }
  }
}

TEST(WarpObjective, NoKeysKernelBeatsEveryBaselineAndOneReachesThem) {
  const WarpObjective objective = Make();
  const double best = objective.Evaluate(KeysCanonicalWeights(FitKeys(objective)));
  EXPECT_GE(best,
            0.95);  // only a pan may gain, against the kernel that is best for half-pixel warps
  EXPECT_LT(best, 1.2);
  EXPECT_LT(best, objective.Evaluate(KeysCanonicalWeights(-0.4)));
  for (const double baseline : objective.baselines()) EXPECT_GT(baseline, 0);
}

// The kernel is searched once, on other crops, but what it loses is measured on these.
TEST(WarpObjective, HalfBaselinesLikeAnotherAreTheLossesOfItsKernelHere) {
  const WarpObjective like = Make();
  const WarpObjective objective = Make(10, &like);
  const auto searched = KeysLosses(like);
  const auto kernel = std::find_if(searched.begin(), searched.end(), [&](const KeysLoss& keys) {
    return keys.losses[0] == like.baselines()[0];
  });
  ASSERT_NE(kernel, searched.end());
  const std::vector<double> here = objective.Losses(KeysCanonicalWeights(kernel->a));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(objective.baselines()[i] / here[i], 1, 1e-12) << i;
    EXPECT_GT(std::abs(objective.baselines()[i] / like.baselines()[i] - 1), 1e-3) << i;
  }
}

TEST(WarpObjective, GradientEqualsDifferences) {
  const WarpObjective objective = Make();
  CanonicalWeights<double> weights = KeysCanonicalWeights(-0.6);
  Resampler gradient;
  objective.Evaluate(weights, &gradient);
  for (const int c : {40, 90, kCanonicalNodes - 1}) {
    for (const int k : {TapWeight(0, -1), TapWeight(0, 0), TapWeight(1, 1)}) {
      const double saved = weights[c][k];
      const double h = 2e-3;
      weights[c][k] = saved + h;
      const double above = objective.Evaluate(weights);
      weights[c][k] = saved - h;
      const double below = objective.Evaluate(weights);
      weights[c][k] = saved;
      const double expected = (above - below) / (2 * h);
      EXPECT_NEAR(gradient.weights[c][k], expected, 0.03 * std::abs(expected) + 2e-3)
          << c << " " << k;
    }
  }
}

TEST(WarpObjective, ConstantCropsHaveNoLossAndNoGradient) {
  for (const float value : {0.0f, 0.3f, 1.0f}) {
    Image flat(64, 64, 1);
    std::fill(flat.data.begin(), flat.data.end(), value);
    std::vector<BorderedPlane> crops;
    crops.push_back(ToPlane(flat));
    const WarpObjective objective(std::move(crops), {2, 6}, 5);
    for (const double baseline : objective.baselines()) EXPECT_EQ(baseline, kLeastBaseline);
    const CanonicalWeights<double> weights = KeysCanonicalWeights(-0.6);
    Resampler gradient;
    const double loss = objective.Evaluate(weights, &gradient);
    EXPECT_GE(loss, 0);
    EXPECT_LT(loss, 4e-5);
    for (const auto& node : gradient.weights) {
      for (const double g : node) EXPECT_TRUE(std::isfinite(g));
    }
  }
}

// Far above the baselines, where the power of a ratio is no number.
TEST(WarpObjective, LargeLossesHaveAFiniteValue) {
  const WarpObjective objective = Make();
  std::vector<double> losses = objective.baselines();
  for (double& loss : losses) loss *= 1e200;
  EXPECT_NEAR(objective.Value(losses) / 1e200, 1, 1e-9);
  std::fill(losses.begin(), losses.end(), 0.0);
  EXPECT_EQ(objective.Value(losses), 0);
  losses[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(objective.Value(losses)));
}

TEST(WarpObjective, SameBitsForAnyNumberOfThreads) {
  const WarpObjective objective = Make();
  const CanonicalWeights<double> weights = KeysCanonicalWeights(-0.57);
  Resampler one, many;
  double value_one = 0, value_many = 0;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    value_one = objective.Evaluate(weights, &one);
  }
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 4);
    value_many = objective.Evaluate(weights, &many);
  }
  EXPECT_EQ(value_one, value_many);
  EXPECT_EQ(one.weights, many.weights);
}

}  // namespace
}  // namespace warplut
