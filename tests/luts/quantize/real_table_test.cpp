#include "luts/quantize/real_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "luts/filters.h"
#include "tests/luts/test_fits.h"

namespace warplut {
namespace {

RealTable Keys(double a, int intervals) {
  return SampleWeights("keys", intervals,
                       [a](double dx, double dy) { return KeysWeights(a, dx, dy); });
}

double WorstDifference(const RealTable& a, const RealTable& b) {
  double worst = 0;
  for (std::size_t r = 0; r < a.rows.size(); ++r) {
    for (int k = 0; k < kWeights; ++k)
      worst = std::max(worst, std::abs(a.rows[r][k] - b.rows[r][k]));
  }
  return worst;
}

TEST(RealTable, SamplesBothEnds) {
  const RealTable table = Keys(-0.5, 31);
  ASSERT_EQ(table.rows.size(), 32u * 32u);
  EXPECT_EQ(table.Row(0, 0)[TapWeight(0, 0)], 1);
  EXPECT_EQ(table.Row(31, 31)[TapWeight(1, 1)], 1);
  EXPECT_EQ(table.Row(31, 0)[TapWeight(1, 0)], 1);
}

TEST(RealTable, ResamplingIsExactForKeysKernels) {
  EXPECT_LT(WorstDifference(Resample(Keys(-0.65, 31), 32), Keys(-0.65, 32)), 1e-14);
}

TEST(RealTable, ResamplingAFitIsCloseAndClosed) {
  const Fit fit = MakeFit(0.2);
  const RealTable resampled = Resample(SampleFit(fit, 31), 32);
  EXPECT_LT(WorstDifference(resampled, SampleFit(fit, 32)), 1e-5);
  for (const Weights<double>& row : resampled.rows) {
    EXPECT_NEAR(std::accumulate(row.begin(), row.end(), 0.0), 1, 1e-14);
  }
}

TEST(RealTable, ContractZerosAreTheBorderOfTheCell) {
  const RealTable table = SampleFit(MakeFit(0.2), 32);
  for (int jy = 0; jy <= 32; ++jy) {
    for (int ix = 0; ix <= 32; ++ix) {
      for (const int k : TapsOf(Footprint::k16)) {
        EXPECT_EQ(IsContractZero(false, 32, ix, jy, k), table.Row(ix, jy)[k] == 0)
            << ix << " " << jy << " " << k;
      }
    }
  }
}

TEST(RealTable, ContractZerosAndMirrorsWithAPrefilter) {
  const RealTable table = SampleFit(WithPrefilter(MakeFit(0.2)), 32);
  for (int jy = 0; jy <= 32; ++jy) {
    for (int ix = 0; ix <= 32; ++ix) {
      for (const int k : TapsOf(Footprint::k16)) {
        EXPECT_EQ(IsContractZero(true, 32, ix, jy, k), table.Row(ix, jy)[k] == 0)
            << ix << " " << jy << " " << k;
        const int mirror =
            TapWeight(MirroredTap(true, 32, ix, TapX(k)), MirroredTap(true, 32, jy, TapY(k)));
        EXPECT_NEAR(table.Row(ix, jy)[k], table.Row(ix, jy)[mirror], 1e-14);
      }
    }
  }
}

TEST(RealTable, AsymmetryIsZeroForAHeadAndSeenElsewhere) {
  RealTable table = SampleFit(MakeFit(0.2), 32);
  EXPECT_LT(Asymmetry(table), 1e-14);
  table.rows[table.RowAt(3, 5)][6] += 0.25;
  EXPECT_NEAR(Asymmetry(table), 0.25, 1e-14);
}

TEST(RealTable, CloseSumSpreadsTheRestBilinearly) {
  Weights<double> w{};
  CloseSum(&w, 0.25, 0.75);
  EXPECT_EQ(w, BilinearWeights(0.25, 0.75));
}

}  // namespace
}  // namespace warplut
