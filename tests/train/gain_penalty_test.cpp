#include "train/gain_penalty.h"

#include <gtest/gtest.h>

#include "train/keys_search.h"

namespace warplut {
namespace {

// The largest gain of a = -0.65 is 1.024, that of a = -0.70 is 1.040.
TEST(GainPenalty, SetsInAtTheGainOfAKeysKernel) {
  CanonicalWeights<double> unused{};
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
  CanonicalWeights<double> gradient{};
  EXPECT_EQ(GainPenalty(1.01).AddGradient(KeysCanonicalWeights(-0.5), 1, gradient), 0);
  for (const auto& node : gradient) {
    for (const double g : node) EXPECT_EQ(g, 0);
  }
  EXPECT_GT(GainPenalty(1.01).AddGradient(KeysCanonicalWeights(-0.65), 1, gradient), 0);
}

TEST(GainPenalty, GradientEqualsDifferences) {
  const GainPenalty penalty(1.005);
  CanonicalWeights<double> weights = KeysCanonicalWeights(-0.75);
  CanonicalWeights<double> gradient{}, unused{};
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
      EXPECT_NEAR(gradient[c][k], (above - below) / h, 1e-5 * (1 + std::abs(gradient[c][k])));
    }
  }
}

}  // namespace
}  // namespace warplut
