#include "luts/quantize/quantize.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "luts/fit/symmetry.h"
#include "tests/luts/quantization_error.h"
#include "tests/luts/test_fits.h"

namespace warplut {
namespace {

using testing::HasSubstr;

// A fit whose weights stay in [-2, 2).
constexpr double kSmall = 0.2;

class QuantizeTest : public testing::TestWithParam<TableFormat> {
 protected:
  const RealTable real_ = SampleFit(MakeFit(kSmall, 11), kNodes);
};

INSTANTIATE_TEST_SUITE_P(Formats, QuantizeTest,
                         testing::Values(TableFormat::kI16, TableFormat::kF16, TableFormat::kI8,
                                         TableFormat::kF32),
                         [](const auto& test) { return std::string(Name(test.param)); });

TEST_P(QuantizeTest, KeepsTheContract) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const RealTable real = SampleFit(MakeFit(seed == 0 ? 0 : kSmall, seed), kNodes);
    const BakedTable table = Quantize(real, GetParam());
    EXPECT_EQ(table.format(), GetParam());
    EXPECT_EQ(SentenceOf([&] { CheckTable(table.view(), "table"); }), "");
  }
}

TEST_P(QuantizeTest, ZeroOffsetIsExactlyTheIdentity) {
  const BakedTable table = Quantize(real_, GetParam());
  IntegerRow identity{};
  identity[kIdentityWeight] = 1 << FractionBits(GetParam());
  EXPECT_EQ(TableIntegers(table.view(), "table")[0], identity);
}

TEST_P(QuantizeTest, KeepsTheSymmetriesExactly) {
  const std::vector<IntegerRow> rows = RoundTable(real_, GetParam());
  for (int jy = 0; jy <= kNodes; ++jy) {
    for (int ix = 0; ix <= kNodes; ++ix) {
      for (int g = 0; g < kSymmetries; ++g) {
        const auto [gx, gy] = MapOffset<int>(g, ix, jy, kNodes);
        for (int k = 0; k < kWeights; ++k) {
          ASSERT_EQ(rows[real_.RowAt(gx, gy)][MapWeight(g, k)], rows[real_.RowAt(ix, jy)][k]);
        }
      }
    }
  }
}

TEST_P(QuantizeTest, ErrorIsAtMostOneUnitPerWeight) {
  const BakedTable table = Quantize(real_, GetParam());
  const double unit = std::ldexp(1.0, -FractionBits(GetParam()));
  const double error = QuantizationError(real_, table.view());
  EXPECT_LT(error, 0.5 * TapCount(Footprint::k16) * unit);
  EXPECT_GT(error, 0);
}

TEST_P(QuantizeTest, RoundsAnAsymmetricTableNodeForNode) {
  RealTable real = real_;
  real.rows[real.RowAt(3, 5)][TapWeight(0, 0)] += 0.25;
  real.rows[real.RowAt(3, 5)][TapWeight(1, 0)] -= 0.25;
  const BakedTable table = Quantize(real, GetParam());
  EXPECT_EQ(SentenceOf([&] { CheckTable(table.view(), "table"); }), "");
  EXPECT_LT(QuantizationError(real, table.view()),
            TapCount(Footprint::k16) * std::ldexp(0.5, -FractionBits(GetParam())));
}

TEST_P(QuantizeTest, RefusesWhatItCannotHold) {
  const auto sentence = [&](double value) {
    RealTable real = real_;
    real.rows[real.RowAt(3, 5)][TapWeight(1, 0)] = value;
    return SentenceOf([&] { Quantize(real, GetParam()); });
  };
  EXPECT_THAT(sentence(2.5),
              HasSubstr("test_fit: weight 6 of node (3, 5) is 2.5, expected a weight in [-2, 2)"));
  EXPECT_THAT(sentence(-2.5), HasSubstr("expected a weight in [-2, 2)"));
  EXPECT_THAT(sentence(std::numeric_limits<double>::quiet_NaN()),
              HasSubstr("is nan, expected a finite number"));
  EXPECT_THAT(sentence(1.5), HasSubstr("test_fit: the weights of node (3, 5) sum to"));
  RealTable real = real_;
  real.rows[real.RowAt(0, 5)][TapWeight(1, 0)] = 0.5;
  EXPECT_THAT(
      SentenceOf([&] { Quantize(real, GetParam()); }),
      HasSubstr("weight 6 of node (0, 5) is 0.5, expected 0, as this offset is on the border"));
}

TEST(Quantize, LargeParametersOverflow) {
  EXPECT_THAT(SentenceOf([] { Quantize(SampleFit(MakeFit(1000), kNodes), TableFormat::kI16); }),
              HasSubstr("expected a weight in [-2, 2)"));
}

TEST(BakedTable, CheckNamesTheNode) {
  std::vector<IntegerRow> rows = RoundTable(SampleFit(MakeFit(kSmall), kNodes), TableFormat::kI16);
  const RealTable grid{"", kNodes, {}};
  std::vector<IntegerRow> stored(kRows);
  for (int jy = 0; jy < kNodes; ++jy) {
    for (int ix = 0; ix < kNodes; ++ix) stored[RowIndex(ix, jy)] = rows[grid.RowAt(ix, jy)];
  }
  const auto sentence = [&](int ix, int jy, int from, int to) {
    std::vector<IntegerRow> changed = stored;
    const FootprintTaps& taps = TapsOf(Footprint::k16);
    changed[RowIndex(ix, jy)][taps[from]] -= 1;
    if (to >= 0) changed[RowIndex(ix, jy)][taps[to]] += 1;
    const BakedTable table(TableFormat::kI16, changed);
    return SentenceOf([&] { CheckTable(table.view(), "t.json"); });
  };
  EXPECT_EQ(sentence(3, 5, 4, 6), "");
  EXPECT_EQ(sentence(3, 5, 4, -1),
            "t.json: the weights of node (3, 5) sum to 16383 / 16384, expected 16384 / 16384");
  EXPECT_THAT(sentence(0, 5, 5, 6),
              HasSubstr("t.json: weight 6 of node (0, 5) is 1 / 16384, expected 0"));
  EXPECT_THAT(sentence(0, 0, 5, 9), HasSubstr("weight 9 of node (0, 0) is 1 / 16384, expected 0"));
}

TEST(BakedTable, RefusesFloatsOffTheGrid) {
  std::vector<float> floats(kTableValues);
  floats[16] = 0.1f;
  EXPECT_THAT(
      SentenceOf([&] {
        TableIntegers({TableFormat::kF32, floats.data()}, "t");
      }),
      HasSubstr("t: weight 0 of node (1, 0) is 0.1, expected a multiple of 2^-22 in [-2, 2)"));
  std::vector<std::uint16_t> halves(kTableValues);
  halves[3] = 0x7C00;  // infinity
  EXPECT_THAT(SentenceOf([&] {
                TableIntegers({TableFormat::kF16, halves.data()}, "t");
              }),
              HasSubstr("t: weight 3 of node (0, 0) is inf"));
}

TEST(BakedTable, HalfHoldsOnlyEvenIntegersAboveOne) {
  EXPECT_TRUE(CanStore(TableFormat::kF16, 2047));
  EXPECT_TRUE(CanStore(TableFormat::kF16, -2048));
  EXPECT_FALSE(CanStore(TableFormat::kF16, 2049));
  EXPECT_TRUE(CanStore(TableFormat::kF16, 2050));
  EXPECT_FALSE(CanStore(TableFormat::kF16, 4096));
  EXPECT_TRUE(CanStore(TableFormat::kI8, -128));
  EXPECT_FALSE(CanStore(TableFormat::kI8, 128));
}

}  // namespace
}  // namespace warplut
