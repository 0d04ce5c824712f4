#include "luts/half.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace warplut {
namespace {

TEST(Half, EveryHalfSurvivesTheRoundTrip) {
  for (int bits = 0; bits < 0x10000; ++bits) {
    const auto half = static_cast<std::uint16_t>(bits);
    const float value = HalfToFloat(half);
    if (std::isnan(value)) {
      EXPECT_TRUE(std::isnan(HalfToFloat(FloatToHalf(value))));
    } else {
      ASSERT_EQ(FloatToHalf(value), half);
    }
  }
}

TEST(Half, KnownValues) {
  EXPECT_EQ(HalfToFloat(0x3C00), 1.0f);
  EXPECT_EQ(HalfToFloat(0xC000), -2.0f);
  EXPECT_EQ(HalfToFloat(0x7BFF), 65504.0f);
  EXPECT_EQ(HalfToFloat(0x0001), 0x1p-24f);
  EXPECT_EQ(HalfToFloat(0x7C00), std::numeric_limits<float>::infinity());
}

TEST(Half, RoundsToNearestEven) {
  EXPECT_EQ(FloatToHalf(1.0f + 0x1p-11f), 0x3C00);      // a tie, down to even
  EXPECT_EQ(FloatToHalf(1.0f + 3 * 0x1p-11f), 0x3C02);  // a tie, up to even
  EXPECT_EQ(FloatToHalf(std::nextafter(1.0f + 0x1p-11f, 2.0f)), 0x3C01);
  EXPECT_EQ(FloatToHalf(0x1p-25f), 0);
  EXPECT_EQ(FloatToHalf(std::nextafter(0x1p-25f, 1.0f)), 1);
  EXPECT_EQ(FloatToHalf(65519.0f), 0x7BFF);
  EXPECT_EQ(FloatToHalf(65520.0f), 0x7C00);
  EXPECT_EQ(FloatToHalf(-1e30f), 0xFC00);
}

TEST(Half, NoHalfIsNearer) {
  std::mt19937 random(3);
  for (int i = 0; i < 100000; ++i) {
    const float value = std::ldexp(std::uniform_real_distribution<float>(0.5f, 1.0f)(random),
                                   std::uniform_int_distribution<int>(-25, 15)(random));
    const std::uint16_t half = FloatToHalf(value);
    const float error = std::abs(HalfToFloat(half) - value);
    ASSERT_LE(error, std::abs(HalfToFloat(static_cast<std::uint16_t>(half + 1)) - value));
    if (half > 0) {
      ASSERT_LE(error, std::abs(HalfToFloat(static_cast<std::uint16_t>(half - 1)) - value));
    }
  }
}

}  // namespace
}  // namespace warplut
