#include "train/fit/kaiser_family.h"

#include <gtest/gtest.h>

#include <cmath>

#include "luts/wide_kernel.h"
#include "train/fit/spline_family.h"

namespace warplut {
namespace {

TEST(KaiserFamily, TheRivalIsTheKernelItself) {
  const Resampler kaiser = KaiserResampler(4.5);
  EXPECT_EQ(kaiser.footprint, Footprint::k36);
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    EXPECT_EQ(kaiser.weights[c], WideWeights(Footprint::k36, 4.5, NodeOffset(i), NodeOffset(j)));
  }
}

TEST(KaiserFamily, TheBaseMovesARampByItsOffset) {
  for (const Footprint footprint : {Footprint::k24, Footprint::k36}) {
    const Resampler base = WideBase(footprint, 4.5);
    for (int c = 0; c < kCanonicalNodes; ++c) {
      const auto [i, j] = CanonicalPosition(c);
      double sum = 0, x = 0, y = 0;
      for (int k = 0; k < kWeights; ++k) {
        sum += base.weights[c][k];
        x += base.weights[c][k] * TapX(k);
        y += base.weights[c][k] * TapY(k);
      }
      EXPECT_NEAR(sum, 1, 1e-14);
      EXPECT_NEAR(x, NodeOffset(i), 1e-14);
      EXPECT_NEAR(y, NodeOffset(j), 1e-14);
    }
  }
}

TEST(KaiserFamily, TheLeastParameterKeepsTheLimitAndNoSmallerDoes) {
  for (const Footprint footprint : {Footprint::k24, Footprint::k36}) {
    const double least = LeastKaiser(footprint, 1.01);
    ASSERT_GT(least, kFirstKaiser);
    EXPECT_LE(LargestNodeGain(WideBase(footprint, least)), 1.01);
    EXPECT_GT(LargestNodeGain(WideBase(footprint, least - 0.01)), 1.01);
    for (const double b : {least + 0.5, least + 2, kLastKaiser}) {
      EXPECT_LE(LargestNodeGain(WideBase(footprint, b)), 1.01) << b;
    }
    EXPECT_EQ(LeastKaiser(footprint, 2), kFirstKaiser);
  }
}

TEST(KaiserFamily, TheBestParameterIsFound) {
  EXPECT_NEAR(BestKaiser([](double b) { return std::abs(b - 4.7); }, 3), 4.7, kKaiserWidth);
  EXPECT_NEAR(BestKaiser([](double b) { return b; }, 3), 3, kKaiserWidth);
}

}  // namespace
}  // namespace warplut
