#include "train/fit/objective/gain_penalty.h"

#include <gtest/gtest.h>

#include "luts/filters.h"
#include "train/fit/rivals/kaiser_family.h"
#include "train/fit/rivals/keys_search.h"
#include "train/fit/rivals/spline_family.h"

namespace warplut {
namespace {

// The largest gain of a = -0.65 is 1.024, that of a = -0.70 is 1.040.
TEST(GainPenalty, SetsInAtTheGainOfAKeysKernel) {
  Resampler unused;
  const auto penalty = [&](double bound, double a) {
    return GainPenalty(bound).AddGradient(KeysCanonicalWeights(a), 1, unused);
  };
  EXPECT_LT(penalty(1.0, -0.5), 1e-15);
  EXPECT_EQ(penalty(1.026, -0.65), 0);
  EXPECT_GT(penalty(1.022, -0.65), 0);
  EXPECT_EQ(penalty(1.043, -0.70), 0);
  EXPECT_GT(penalty(1.037, -0.70), 0);
}

TEST(GainPenalty, ZeroBelowTheBoundAndPositiveAbove) {
  Resampler gradient;
  EXPECT_EQ(GainPenalty(1.01).AddGradient(KeysCanonicalWeights(-0.5), 1, gradient), 0);
  for (const auto& node : gradient.weights) {
    for (const double g : node) EXPECT_EQ(g, 0);
  }
  EXPECT_GT(GainPenalty(1.01).AddGradient(KeysCanonicalWeights(-0.65), 1, gradient), 0);
}

TEST(GainPenalty, GradientEqualsDifferences) {
  const GainPenalty penalty(1.005);
  CanonicalWeights<double> weights = KeysCanonicalWeights(-0.75);
  Resampler gradient, unused;
  penalty.AddGradient(weights, 2, gradient);
  for (const int c : {30, 100, kCanonicalNodes - 1}) {
    for (int k = 0; k < kWeights; ++k) {
      const double saved = weights[c][k];
      const double h = 1e-5;
      weights[c][k] = saved + h;
      const double above = penalty.AddGradient(weights, 0, unused);
      weights[c][k] = saved - h;
      const double below = penalty.AddGradient(weights, 0, unused);
      weights[c][k] = saved;
      EXPECT_NEAR(gradient.weights[c][k], (above - below) / h,
                  1e-5 * (1 + std::abs(gradient.weights[c][k])));
    }
  }
}

TEST(GainPenalty, OfMoreTapsGradientEqualsDifferences) {
  for (const Footprint footprint : {Footprint::k24, Footprint::k36}) {
    const GainPenalty penalty(1.0001, footprint);
    Resampler at = WideBase(footprint, 2), gradient, unused;
    EXPECT_GT(penalty.AddGradient(at, 2, gradient), 0);
    for (const int k : TapsOf(footprint)) {
      double& number = at.weights[kCanonicalNodes - 1][k];
      const double saved = number, h = 1e-6;
      number = saved + h;
      const double above = penalty.AddGradient(at, 0, unused);
      number = saved - h;
      const double below = penalty.AddGradient(at, 0, unused);
      number = saved;
      const double analytic = gradient.weights[kCanonicalNodes - 1][k];
      EXPECT_NEAR(analytic, (above - below) / h, 1e-5 * (1 + std::abs(analytic)));
    }
  }
}

// The gradient of the product with the response of the prefilter: weights, side and taps.
TEST(GainPenalty, WithAPrefilterGradientEqualsDifferences) {
  const GainPenalty penalty(1.005);
  for (const RealPrefilter& prefilter : {RecursivePrefilter(0.2), FirPrefilter(0.19, 4)}) {
    Resampler at = SplineResampler(prefilter);
    Resampler gradient, unused;
    EXPECT_GT(penalty.AddGradient(at, 2, gradient), 0);
    const auto compare = [&](double analytic, double& number) {
      const double saved = number, h = 1e-6;
      number = saved + h;
      const double above = penalty.AddGradient(at, 0, unused);
      number = saved - h;
      const double below = penalty.AddGradient(at, 0, unused);
      number = saved;
      EXPECT_NEAR(analytic, (above - below) / h, 1e-5 * (1 + std::abs(analytic)));
    };
    for (int k = 0; k < kWeights; ++k) {
      compare(gradient.weights[kCanonicalNodes - 1][k], at.weights[kCanonicalNodes - 1][k]);
    }
    if (prefilter.kind == PrefilterKind::kRecursive) {
      compare(gradient.prefilter.side, at.prefilter.side);
    }
    for (int j = 0; j <= prefilter.reach && prefilter.reach > 0; ++j) {
      compare(gradient.prefilter.taps[j], at.prefilter.taps[j]);
    }
  }
}

TEST(GainPenalty, WithAPrefilterSetsInAtTheGainOfTheProduct) {
  Resampler unused;
  const Resampler spline = SplineResampler(RecursivePrefilter(SplineSide(kMiddleSplineK)));
  EXPECT_EQ(GainPenalty(1.008).AddGradient(spline, 1, unused), 0);
  EXPECT_GT(GainPenalty(1.007).AddGradient(spline, 1, unused), 0);
}

}  // namespace
}  // namespace warplut
