#include "runtime/color_encoding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "luts/half.h"

namespace warplut {
namespace {

template <class Check>
void ForHdrValues(const Check& check) {
  for (float x = 1e-6f; x < kLargestHdr; x *= 1.03f) check(x);
}

TEST(HdrCode, RisesFromZeroToOne) {
  EXPECT_EQ(HdrCode(0), 0);
  EXPECT_FLOAT_EQ(HdrCode(kLargestHdr), 1);
  EXPECT_EQ(HdrValue(0), 0);
  EXPECT_FLOAT_EQ(HdrValue(1), kLargestHdr);
  EXPECT_LE(HdrValue(1), kLargestHdr);
  float before = 0;
  ForHdrValues([&](float x) {
    EXPECT_GT(HdrCode(x), before);
    before = HdrCode(x);
  });
}

TEST(HdrCode, IsALogarithmAboveALinearFoot) {
  ForHdrValues([](float x) {
    EXPECT_NEAR(kHdrOctaves * HdrCode(x), std::log2(1 + kHdrGain * x), 0.01) << x;
  });
}

TEST(HdrCode, HasAContinuousSlope) {
  const auto slope = [](double x, double to) {
    return (HdrCode(static_cast<float>(to)) - HdrCode(static_cast<float>(x))) / (to - x);
  };
  for (int k = 1; k < kHdrOctaves; ++k) {
    const double x = (std::exp2(k) - 1) / kHdrGain;
    EXPECT_NEAR(slope(0.98 * x, x) / slope(x, 1.02 * x), 1, 0.03) << k;
  }
}

TEST(HdrCode, IsReversible) {
  ForHdrValues(
      [](float x) { EXPECT_NEAR(HdrValue(HdrCode(x)), x, 2e-6f * (x + 1 / kHdrGain)) << x; });
}

// Unlike a half that holds x / (1 + x), which cannot tell 1000 from 800.
TEST(HdrCode, SurvivesAHalf) {
  ForHdrValues([](float x) {
    const float half = HalfToFloat(FloatToHalf(HdrCode(x)));
    const float bound = (half < 0.5f ? 0.002f : 0.0041f) * (x + 1 / kHdrGain);
    EXPECT_NEAR(HdrValue(half), x, bound) << x;
  });
}

TEST(HdrCode, OvershootIsAMultiple) {
  ForHdrValues([](float x) {
    const float code = std::min(1.05f * HdrCode(x), 1.0f);
    EXPECT_LT(HdrValue(code), 2.2f * x) << x;
  });
}

TEST(LimitHdr, TakesWhatIsNoLinearColour) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(LimitHdr(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(LimitHdr(-kInfinity), 0);
  EXPECT_EQ(LimitHdr(-1), 0);
  EXPECT_EQ(LimitHdr(3), 3);
  EXPECT_EQ(LimitHdr(1e9f), kLargestHdr);
  EXPECT_EQ(LimitHdr(kInfinity), kLargestHdr);
}

}  // namespace
}  // namespace warplut
