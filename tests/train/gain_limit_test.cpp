#include "train/gain_limit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "luts/certificate.h"
#include "train/mlp_objective.h"
#include "train/train_options.h"

namespace warplut {
namespace {

double LargestNodeGain(const std::vector<double>& parameters) {
  HeadBatch head;
  double largest = 0;
  for (const Weights<double>& node : head.Forward(parameters.data())) {
    largest = std::max(largest, MaxGain(node).gain);
  }
  return largest;
}

TEST(GainLimit, TakesAwayNoMoreThanItMust) {
  HeadBatch head;
  for (const double size : {1.0, 10.0, 1000.0}) {
    for (const double limit : {1.001, 1.01, 1.1}) {
      std::vector<double> parameters = RandomParameters(3);
      for (double& p : parameters) p *= size;
      const double before = LargestNodeGain(parameters);
      const double share = LimitGain(limit, head, parameters);
      const double after = LargestNodeGain(parameters);
      EXPECT_LE(after, limit + 1e-12);
      EXPECT_EQ(share<1, before> limit);
      if (share < 1) {
        EXPECT_GT(after, 1 + 0.99 * (limit - 1) - 2e-3 * (before - 1));
      }
    }
  }
}

TEST(GainLimit, LeavesWhatKeepsItAlone) {
  HeadBatch head;
  std::vector<double> parameters = RandomParameters(3);
  for (double& p : parameters) p *= 1e-3;
  const std::vector<double> before = parameters;
  EXPECT_EQ(LimitGain(1.01, head, parameters), 1);
  EXPECT_EQ(parameters, before);
}

TEST(GainLimit, OfTheDefaultBoundAllowsTheHorizon) {
  for (const int horizon : {2, 6, 64}) {
    const double limit = LargestGain(DefaultGainBound(horizon));
    EXPECT_EQ(SafeWarps(limit * (1 - 1e-12)).value(), horizon);
  }
  EXPECT_GT(LargestGain(1), 1);
}

}  // namespace
}  // namespace warplut
