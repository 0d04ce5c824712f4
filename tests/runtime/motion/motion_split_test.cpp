#include "runtime/motion/motion_split.h"

#include <gtest/gtest.h>

#include <random>

namespace warplut {
namespace {

TEST(MotionSplit, AddsUpToMinusTheMotion) {
  std::mt19937 random(1);
  for (int i = 0; i < 100000; ++i) {
    const float m = std::uniform_real_distribution<float>(-100, 100)(random);
    const MotionSplit split = SplitMotion(m);
    ASSERT_GE(split.offset, 0.0f);
    ASSERT_LT(split.offset, 1.0f);
    ASSERT_NEAR(static_cast<double>(split.whole) + split.offset, -static_cast<double>(m), 0x1p-25);
  }
}

TEST(MotionSplit, WholeMotionHasNoOffset) {
  for (int m = -4096; m <= 4096; ++m) {
    const MotionSplit split = SplitMotion(static_cast<float>(m));
    EXPECT_EQ(split.whole, -m);
    EXPECT_EQ(split.offset, 0.0f);
  }
}

TEST(MotionSplit, OffsetStaysBelowOneForTinyMotion) {
  const MotionSplit split = SplitMotion(1e-30f);
  EXPECT_EQ(split.whole, 0);
  EXPECT_EQ(split.offset, 0.0f);
}

TEST(MotionSplit, NotANumberAndInfinityCountAsZero) {
  for (const float m :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(SplitMotion(m).whole, 0);
    EXPECT_EQ(SplitMotion(m).offset, 0.0f);
  }
}

TEST(MotionSplit, FarMotionStaysInRange) {
  for (const float m : {1e6f, 1e30f, std::numeric_limits<float>::max()}) {
    EXPECT_EQ(SampledTexel(10, SplitMotion(m).whole, 100), -3);
    EXPECT_EQ(SampledTexel(10, SplitMotion(-m).whole, 100), 101);
  }
}

}  // namespace
}  // namespace warplut
