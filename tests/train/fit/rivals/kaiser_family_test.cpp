#include "train/fit/rivals/kaiser_family.h"

#include <gtest/gtest.h>

#include <cmath>

#include "luts/wide_kernel.h"
#include "train/fit/rivals/spline_family.h"

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

TEST(KaiserFamily, TheBaseIsTheWideKernel) {
  for (const Footprint footprint : {Footprint::k24, Footprint::k36}) {
    const Resampler base = WideBase(footprint, 4.5);
    EXPECT_EQ(base.footprint, footprint);
    for (int c = 0; c < kCanonicalNodes; ++c) {
      const auto [i, j] = CanonicalPosition(c);
      const Weights<double> kernel = WideWeights(footprint, 4.5, NodeOffset(i), NodeOffset(j));
      for (int k = 0; k < kWeights; ++k) EXPECT_NEAR(base.weights[c][k], kernel[k], 1e-15);
    }
  }
}

TEST(KaiserFamily, TheBestParameterKeepsTheLimitOnGain) {
  const auto nearest_to = [](double wanted) {
    return [wanted](double b) { return std::abs(b - wanted); };
  };
  for (const Footprint footprint : {Footprint::k24, Footprint::k36}) {
    EXPECT_NEAR(*BestKaiser(nearest_to(4.7), footprint, 1.01), 4.7, kKaiserWidth);
    const double sharpest = *BestKaiser(nearest_to(0), footprint, 1.01);
    EXPECT_LE(LargestNodeGain(WideBase(footprint, sharpest)), 1.01);
    EXPECT_GT(LargestNodeGain(WideBase(footprint, sharpest - 2 * kKaiserWidth)), 1.01);
    EXPECT_FALSE(BestKaiser(nearest_to(4.7), footprint, 1).has_value());
  }
}

}  // namespace
}  // namespace warplut
