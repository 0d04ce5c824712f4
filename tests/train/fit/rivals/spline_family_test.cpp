#include "train/fit/rivals/spline_family.h"

#include <gtest/gtest.h>

#include <cmath>

#include "luts/filters.h"
#include "train/fit/objective/prefilter_map.h"

namespace warplut {
namespace {

TEST(SplineFamily, GainsAreThoseThatAreKnown) {
  EXPECT_NEAR(LargestNodeGain(SplineResampler(RecursivePrefilter(SplineSide(0.0)))), 1, 1e-6);
  EXPECT_NEAR(LargestNodeGain(SplineResampler(RecursivePrefilter(SplineSide(kMiddleSplineK)))),
              1.0075, 1e-4);
}

TEST(SplineFamily, LargestSideKeepsTheLimitAndNoLargerOneDoes) {
  for (const int reach : {0, 4, 7}) {
    const double side = LargestSplineSide(1.01, reach);
    const RealPrefilter prefilter = SplinePrefilter(side, reach);
    EXPECT_TRUE(IsValid(Rounded(prefilter)));
    EXPECT_LE(LargestNodeGain(SplineResampler(prefilter)), 1.01);
    EXPECT_GT(LargestNodeGain(SplineResampler(SplinePrefilter(side + 1e-3, reach))), 1.01);
  }
  EXPECT_EQ(LargestSplineSide(4, 0), static_cast<double>(kLargestSide));
}

// The more taps, the nearer, and the larger the side that they can invert.
TEST(SplineFamily, FirInvertsTheWholeOffsetTheBetterTheMoreTaps) {
  double last_error = 1, last_side = 0;
  for (int reach = 1; reach <= kLargestFirReach; ++reach) {
    const RealPrefilter fir = FirPrefilter(1.0 / 6, reach);
    double sum = fir.taps[0], error = 0;
    for (int j = 1; j <= reach; ++j) sum += 2 * fir.taps[j];
    EXPECT_NEAR(sum, 1, 1e-12);
    for (int i = 0; i <= 64; ++i) {
      const double f = i * 3.14159265 / 64;
      error =
          std::max(error, std::abs(PrefilterResponse(fir, f) * WholeOffsetResponse(fir, f) - 1));
    }
    EXPECT_LT(error, 0.6 * last_error) << reach;
    last_error = error;
    const double side = LargestSplineSide(4, reach);
    EXPECT_GE(side, last_side) << reach;
    last_side = side;
  }
  EXPECT_LT(last_error, 1e-3);
}

TEST(SplineFamily, BestSideIsFoundWithinItsWidth) {
  const double best = BestSplineSide([](double s) { return (s - 0.171) * (s - 0.171); }, 0.23);
  EXPECT_NEAR(best, 0.171, kSideWidth);
}

}  // namespace
}  // namespace warplut
