#include "train/fit/rivals/golden_section.h"

#include <gtest/gtest.h>

namespace warplut {
namespace {

TEST(GoldenSection, FindsTheMaximumWithTheCountItTells) {
  for (const double peak : {-1.0, -0.93, -0.6, -0.31, -0.3}) {
    int evaluations = 0;
    const Maximum best = GoldenSection(
        [&](double a) {
          ++evaluations;
          return 2 - (a - peak) * (a - peak);
        },
        -1, -0.3, 0.01);
    EXPECT_NEAR(best.at, peak, 0.01);
    EXPECT_NEAR(best.value, 2, 1e-4);
    EXPECT_EQ(evaluations, GoldenSectionEvaluations(-1, -0.3, 0.01));
  }
}

TEST(GoldenSection, AWideGoalTakesTwoEvaluations) {
  EXPECT_EQ(GoldenSectionEvaluations(0, 1, 2), 2);
}

}  // namespace
}  // namespace warplut
