#include "train/fit/objective/sr_objective.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "train/fit/rivals/keys_search.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

constexpr SrObjectiveOptions kOptions = {
    .scale = 1.7, .blend_a = 0.7, .blend_b = 0.8, .pan_share = 0.25, .pans_per_crop = 1};

std::vector<BorderedPlane> Crops(int count = 3) {
  std::vector<BorderedPlane> crops;
  for (int i = 0; i < count; ++i) crops.push_back(ToPlane(NoiseImage(64, 64, i)));
  return crops;
}

TEST(SrObjective, ProtocolsAreRandomThenPan) {
  const SrObjective objective(Crops(), {2, 8}, 5, kOptions);
  ASSERT_EQ(objective.protocols().size(), 3u);
  EXPECT_EQ(objective.protocols()[1].offsets, Offsets::kRandom);
  EXPECT_EQ(objective.protocols()[1].warps, 8);
  EXPECT_EQ(objective.protocols()[2].offsets, Offsets::kPan);
  EXPECT_EQ(objective.protocols()[2].warps, kNodes);
}

TEST(SrObjective, TheLoopSettlesFarBelowTheFirstFrameAndWhatWarpsAloneLose) {
  const SrObjective objective(Crops(), {2, 40}, 5, {.scale = 2, .blend_a = 0.7, .blend_b = 0.8});
  const std::vector<double> losses = objective.Losses(KeysCanonicalWeights(-0.55));
  EXPECT_GT(losses[0], 2 * losses[1]);
  EXPECT_LT(losses[1], 0.1);
}

// The filter matters here, and a soft one is worse.
TEST(SrObjective, BaselinesAreTheBestKeysKernels) {
  const SrObjective objective(Crops(), {4, 24}, 5, kOptions);
  const double best = objective.Evaluate(KeysCanonicalWeights(FitKeys(objective)));
  EXPECT_GE(best, 1 - 1e-12);
  EXPECT_LT(best, 1.1);
  EXPECT_GT(objective.Evaluate(KeysCanonicalWeights(-0.1)), best);
}

TEST(SrObjective, AConstantImageStaysConstant) {
  Image flat(64, 64, 1);
  for (float& value : flat.data) value = 0.4f;
  std::vector<BorderedPlane> crops;
  crops.push_back(ToPlane(flat));
  const SrObjective objective(std::move(crops), {4, 24}, 5, kOptions);
  for (const double loss : objective.Losses(KeysCanonicalWeights(-0.6))) EXPECT_NEAR(loss, 0, 2e-6);
}

// Noise favours filters that blur.
TEST(SrObjective, AliasingAddsLossAndMovesTheBestKernelTowardsSoft) {
  SrObjectiveOptions options = kOptions;
  const SrObjective clean(Crops(), {4, 24}, 5, options);
  options.aliasing = 1.5;
  const SrObjective noisy(Crops(), {4, 24}, 5, options);
  EXPECT_GT(noisy.Losses(KeysCanonicalWeights(-0.6))[1],
            1.2 * clean.Losses(KeysCanonicalWeights(-0.6))[1]);
  EXPECT_GT(FitKeys(noisy), FitKeys(clean));
}

TEST(SrObjective, ScaledBaselinesAreThoseOfTheOtherCropsTimesWhatCatmullRomLoses) {
  const SrObjective there(Crops(2), {4, 24}, 5, kOptions);
  const SrObjective here(Crops(3), {4, 24}, 6, kOptions, &there);
  const CanonicalWeights<double> catmull_rom = KeysCanonicalWeights(-0.5);
  const auto a = there.Losses(catmull_rom), b = here.Losses(catmull_rom);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(here.baselines()[i], there.baselines()[i] * b[i] / a[i], 1e-12);
  }
}

TEST(SrObjective, GradientEqualsDifferences) {
  const SrObjective objective(Crops(), {2, 8}, 5, kOptions);
  CanonicalWeights<double> weights = KeysCanonicalWeights(-0.6);
  Resampler gradient;
  objective.Evaluate(weights, &gradient);
  double size = 0;
  for (const auto& node : gradient.weights) {
    for (const double value : node) size = std::max(size, std::abs(value));
  }
  int compared = 0;
  for (int c = 0; c < kCanonicalNodes; ++c) {
    for (const int k : {TapWeight(0, -1), TapWeight(0, 0), TapWeight(1, 1)}) {
      if (std::abs(gradient.weights[c][k]) < 0.2 * size) continue;
      const double saved = weights[c][k];
      const double h = 2e-3;
      weights[c][k] = saved + h;
      const double above = objective.Evaluate(weights);
      weights[c][k] = saved - h;
      const double below = objective.Evaluate(weights);
      weights[c][k] = saved;
      const double expected = (above - below) / (2 * h);
      EXPECT_NEAR(gradient.weights[c][k], expected, 0.02 * std::abs(expected)) << c << " " << k;
      ++compared;
    }
  }
  EXPECT_GT(compared, 3);
}

TEST(SrObjective, SameBitsForAnyNumberOfThreads) {
  const CanonicalWeights<double> weights = KeysCanonicalWeights(-0.57);
  const auto evaluate = [&](int threads, Resampler* gradient) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return SrObjective(Crops(), {2, 8}, 5, kOptions).Evaluate(weights, gradient);
  };
  Resampler one, many;
  EXPECT_EQ(evaluate(1, &one), evaluate(4, &many));
  EXPECT_EQ(one.weights, many.weights);
}

}  // namespace
}  // namespace warplut
