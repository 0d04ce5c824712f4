#include "luts/fit/head.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/luts/test_fits.h"

namespace warplut {
namespace {

constexpr double kSumTolerance = 1e-9;

class HeadTest : public testing::TestWithParam<double> {
 protected:
  const Fit fit_ = MakeFit(GetParam(), 7);
  Weights<double> At(double dx, double dy) const {
    return HeadWeights(fit_.parameters.data(), dx, dy);
  }
};

// From Catmull-Rom to weights of thousands, where tanh saturates.
INSTANTIATE_TEST_SUITE_P(Sizes, HeadTest, testing::Values(0.0, 0.05, 1.0, 1000.0));

TEST_P(HeadTest, WeightsSumToOne) {
  for (double dy = 0; dy <= 1; dy += 0.0625) {
    for (double dx = 0; dx <= 1; dx += 0.0625) {
      const Weights<double> w = At(dx, dy);
      EXPECT_NEAR(std::accumulate(w.begin(), w.end(), 0.0), 1, kSumTolerance) << dx << " " << dy;
    }
  }
}

TEST_P(HeadTest, HasTheSymmetriesOfTheSquare) {
  for (const auto& [dx, dy] :
       {std::pair(0.3, 0.1), {0.5, 0.25}, {0.4, 0.4}, {0.5, 0.5}, {0.0, 0.7}}) {
    const Weights<double> w = At(dx, dy);
    for (int g = 0; g < kSymmetries; ++g) {
      const auto [gx, gy] = MapOffset(g, dx, dy);
      const Weights<double> image = At(gx, gy);
      for (int k = 0; k < kWeights; ++k) {
        EXPECT_NEAR(image[MapWeight(g, k)], w[k], 1e-10 * (1 + std::abs(w[k]) + GetParam()))
            << g << " " << k;
      }
    }
  }
}

TEST_P(HeadTest, ZeroOffsetIsTheIdentity) {
  const Weights<double> w = At(0, 0);
  for (int k = 0; k < kWeights; ++k) {
    EXPECT_NEAR(w[k], k == kIdentityWeight ? 1 : 0, kSumTolerance) << k;
  }
}

TEST_P(HeadTest, NeighbouringCellsMeet) {
  for (double d = 0; d <= 1; d += 0.125) {
    const Weights<double> left = At(0, d);
    const Weights<double> right = At(1, d);
    for (int k = 0; k < kWeights; ++k) {
      if (TapX(k) != 0) {
        EXPECT_EQ(left[k], 0);
      }
      if (TapX(k) != 1) {
        EXPECT_EQ(right[k], 0);
      }
      if (TapX(k) == 0) {
        EXPECT_NEAR(left[k], right[k + 1], 1e-10 * (1 + GetParam()));
      }
    }
  }
}

TEST(Head, ZeroParametersAreCatmullRom) {
  const Fit fit = MakeFit(0);
  const Weights<double> w = HeadWeights(fit.parameters.data(), 0.3, 0.8);
  const Weights<double> keys = KeysWeights(kCatmullRomA, 0.3, 0.8);
  for (int k = 0; k < kWeights; ++k) EXPECT_EQ(w[k], keys[k]);
}

TEST(Filters, KeysKernelMatchesItsPiecewiseFormula) {
  for (const double a : {-0.5, -0.58, -0.75}) {
    for (const double d : {0.0, 0.125, 0.5, 0.9, 1.0}) {
      const auto taps = KeysTaps(a, d);
      for (int k = 0; k < kTaps; ++k) {
        const double t = std::abs(k + kFirstTap - d);
        const double expected = t <= 1  ? ((a + 2) * t - (a + 3)) * t * t + 1
                                : t < 2 ? a * (((t - 5) * t + 8) * t - 4)
                                        : 0;
        EXPECT_NEAR(taps[k], expected, 1e-15) << a << " " << d << " " << k;
      }
    }
  }
}

TEST(Filters, AppliesWeightsInOrder) {
  Weights<double> w{};
  std::array<double, kWeights> texels{};
  for (int k = 0; k < kWeights; ++k) {
    w[k] = k;
    texels[k] = std::ldexp(1.0, k);
  }
  for (const Footprint footprint : kFootprints) {
    double expected = 0;
    for (const int k : TapsOf(footprint)) expected += k * std::ldexp(1.0, k);
    EXPECT_EQ(ApplyWeights(footprint, w, texels), expected);
  }
}

TEST(Symmetry, MovesTapsAsItMovesOffsets) {
  // A tap at the position of the offset stays there: (tap + 2) / 5 is an offset in [0, 1].
  for (int g = 0; g < kSymmetries; ++g) {
    for (int k = 0; k < kWeights; ++k) {
      const auto [x, y] = MapOffset(g, (TapX(k) + 2) / 5.0, (TapY(k) + 2) / 5.0);
      EXPECT_EQ(MapWeight(g, k), TapWeight(static_cast<int>(std::lround(5 * x)) - 2,
                                           static_cast<int>(std::lround(5 * y)) - 2));
      for (const Footprint footprint : kFootprints) {
        EXPECT_EQ(HasTap(footprint, TapX(MapWeight(g, k)), TapY(MapWeight(g, k))),
                  HasTap(footprint, TapX(k), TapY(k)));
      }
    }
  }
}

}  // namespace
}  // namespace warplut
