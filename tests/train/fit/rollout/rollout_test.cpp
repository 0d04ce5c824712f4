#include "train/fit/rollout/rollout.h"

#include <gtest/gtest.h>

#include <array>

#include "train/fit/rivals/kaiser_family.h"
#include "train/fit/rivals/keys_search.h"
#include "train/fit/rivals/spline_family.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

constexpr std::array<int, 2> kHorizons = {4, 10};

// A rollout of 10 steps from a noise image to itself; with samples, those of another image.
struct Case {
  explicit Case(bool with_samples = false) {
    rollout.start = &image;
    rollout.ssim = &ssim;
    rollout.steps = ToSteps(MakeTrajectory(Offsets::kRandom, kHorizons, kNodes, 3));
    rollout.horizons = {kHorizons.begin(), kHorizons.end()};
    for (std::size_t i = 0; with_samples && i < rollout.steps.size(); ++i) {
      const SampleGrid& grid = grids[i % grids.size()];
      FrameSamples frame{&grid, std::vector<float>(grid.columns() * grid.rows())};
      grid.Read(target, frame.values);
      rollout.frames.push_back(std::move(frame));
    }
  }
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;

  std::array<double, 2> Losses(const CanonicalWeights<double>& weights) {
    std::array<double, 2> losses{};
    workspace.Forward(rollout, weights, losses);
    return losses;
  }

  BorderedPlane image = ToPlane(NoiseImage(64, 48, 6));
  BorderedPlane target = ToPlane(NoiseImage(64, 48, 7));
  Ssim ssim{InnerView(image)};
  std::array<SampleGrid, 2> grids = {
      SampleGrid({.width = 64, .height = 48, .scale = 1.7, .blend_a = 0.7, .blend_b = 0.8},
                 {0.2, -0.4}),
      SampleGrid({.width = 64, .height = 48, .scale = 1.7, .blend_a = 0.7, .blend_b = 0.8},
                 {-0.1, 0.3})};
  Rollout rollout;
  RolloutWorkspace workspace{64, 48};
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
  c.rollout.steps.assign(10, {ToCanonical(0, 0), 0, 0});
  for (const double loss : c.Losses(KeysCanonicalWeights(-0.5))) EXPECT_NEAR(loss, 0, 2e-6);
}

TEST(Rollout, SharperKeysLosesLessThanBilinearLike) {
  Case c;
  EXPECT_LT(c.Losses(KeysCanonicalWeights(-0.6))[1], c.Losses(KeysCanonicalWeights(-0.1))[1]);
}

// Against central differences, with and without samples.
TEST(Rollout, GradientEqualsDifferences) {
  for (const bool with_samples : {false, true}) {
    Case c(with_samples);
    CanonicalWeights<double> weights = KeysCanonicalWeights(-0.55);
    const std::array<double, 2> factors = {1.0, 0.5};
    c.Losses(weights);
    Resampler gradient;
    c.workspace.Backward(c.rollout, factors, weights, gradient);
    const auto total = [&] {
      const auto losses = c.Losses(weights);
      return factors[0] * losses[0] + factors[1] * losses[1];
    };
    for (const std::size_t step : {0u, 3u, 7u}) {
      const int node = c.rollout.steps[step].node.index;
      for (const int i : {0, 5, 6, 10, 13}) {
        const int k = TapsOf(Footprint::k16)[i];
        const double saved = weights[node][k];
        const double h = 1e-3;
        weights[node][k] = saved + h;
        const double above = total();
        weights[node][k] = saved - h;
        const double below = total();
        weights[node][k] = saved;
        const double expected = (above - below) / (2 * h);
        EXPECT_NEAR(gradient.weights[node][k], expected, 0.01 * std::abs(expected) + 2e-3)
            << with_samples << " " << step << " " << k;
      }
    }
  }
}

// Of every tap.
TEST(Rollout, OfMoreTapsGradientEqualsDifferences) {
  for (const Footprint footprint : {Footprint::k24, Footprint::k36}) {
    Case c;
    Resampler at = WideBase(footprint, 4.5), gradient;
    const std::array<double, 2> factors = {1.0, 0.5};
    const auto total = [&] {
      std::array<double, 2> losses{};
      c.workspace.Forward(c.rollout, at, losses);
      return factors[0] * losses[0] + factors[1] * losses[1];
    };
    total();
    c.workspace.Backward(c.rollout, factors, at, gradient);
    const int node = c.rollout.steps[3].node.index;
    for (const int k : TapsOf(footprint)) {
      double& number = at.weights[node][k];
      const double saved = number, h = 1e-3;
      number = saved + h;
      const double above = total();
      number = saved - h;
      const double below = total();
      number = saved;
      const double expected = (above - below) / (2 * h);
      EXPECT_NEAR(gradient.weights[node][k], expected, 0.01 * std::abs(expected) + 2e-3)
          << TapCount(footprint) << " " << k;
    }
  }
}

// Weights, side and taps; differences in float need a step that is large.
TEST(Rollout, WithAPrefilterGradientEqualsDifferences) {
  for (const bool with_samples : {false, true}) {
    for (const RealPrefilter& prefilter : {RecursivePrefilter(0.17), FirPrefilter(0.15, 3)}) {
      Case c(with_samples);
      Resampler at = SplineResampler(prefilter), gradient;
      const std::array<double, 2> factors = {1.0, 0.5};
      const auto total = [&] {
        std::array<double, 2> losses{};
        c.workspace.Forward(c.rollout, at, losses);
        return factors[0] * losses[0] + factors[1] * losses[1];
      };
      total();
      c.workspace.Backward(c.rollout, factors, at, gradient);
      const auto compare = [&](double analytic, double& number) {
        const double saved = number, h = 1e-3;
        number = saved + h;
        const double above = total();
        number = saved - h;
        const double below = total();
        number = saved;
        const double expected = (above - below) / (2 * h);
        EXPECT_NEAR(analytic, expected, 0.01 * std::abs(expected) + 2e-3) << with_samples;
      };
      for (const std::size_t step : {0u, 7u}) {
        const int node = c.rollout.steps[step].node.index;
        for (const int i : {0, 5, 10}) {
          const int k = TapsOf(Footprint::k16)[i];
          compare(gradient.weights[node][k], at.weights[node][k]);
        }
      }
      if (prefilter.reach == 0) compare(gradient.prefilter.side, at.prefilter.side);
      for (int j = 0; j <= prefilter.reach && prefilter.reach > 0; ++j) {
        compare(gradient.prefilter.taps[j], at.prefilter.taps[j]);
      }
    }
  }
}

TEST(Rollout, WholeShiftsThroughAPrefilterLoseNothing) {
  Case c;
  c.rollout.steps.assign(10, {ToCanonical(0, 0), 0, 0});
  std::array<double, 2> losses{};
  c.workspace.Forward(c.rollout, SplineResampler(RecursivePrefilter(0.19)), losses);
  for (const double loss : losses) EXPECT_NEAR(loss, 0, 2e-6);
}

TEST(Rollout, WithFullShareAndASampleOnEveryPixelTheImageIsItsSamples) {
  Case c;
  const Ssim target(InnerView(c.target));
  c.rollout.ssim = &target;
  const SampleGrid grid({.width = 64, .height = 48, .scale = 1, .blend_a = 1, .blend_b = 0}, {});
  FrameSamples frame{&grid, std::vector<float>(64 * 48)};
  grid.Read(c.target, frame.values);
  c.rollout.frames.assign(c.rollout.steps.size(), frame);
  for (const double loss : c.Losses(KeysCanonicalWeights(-0.3))) EXPECT_NEAR(loss, 0, 2e-6);
}

TEST(Rollout, SamplesPullTheImageTowardsWhatTheySee) {
  Case pure, refreshed(true);
  const Ssim target(InnerView(pure.target));
  pure.rollout.ssim = refreshed.rollout.ssim = &target;
  const CanonicalWeights<double> weights = KeysCanonicalWeights(-0.5);
  EXPECT_GT(pure.Losses(weights)[1], 0.5);
  EXPECT_LT(refreshed.Losses(weights)[1], 0.3);
}

}  // namespace
}  // namespace warplut
