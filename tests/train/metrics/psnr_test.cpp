#include "train/metrics/psnr.h"

#include <gtest/gtest.h>

#include <cmath>

namespace warplut {
namespace {

TEST(Psnr, IsTenTimesTheLogarithm) {
  EXPECT_DOUBLE_EQ(Psnr(0.01), 20);
  EXPECT_TRUE(std::isinf(Psnr(0)) && Psnr(0) > 0);
}

TEST(MeanSquaredError, IsOverPixelsAndChannelsInsideTheBorder) {
  Image a(4, 3, 2);
  const Image b(4, 3, 2);
  a.at(1, 1, 1) = 0.5f;
  EXPECT_DOUBLE_EQ(MeanSquaredError(a, b), 0.25 / 24);
  EXPECT_DOUBLE_EQ(MeanSquaredError(a, b, 1), 0.25 / 4);
}

}  // namespace
}  // namespace warplut
