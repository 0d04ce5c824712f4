#include "train/metrics/temporal_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "train/replay/image_views.h"

namespace warplut {
namespace {

constexpr int kWidth = 12, kHeight = 8;

// One frame: uniform motion and depth.
struct Surface {
  Surface(float mx, float my, float depth_value)
      : depth(kWidth, kHeight, PixelFormat::kR32F), motion(kWidth, kHeight) {
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        Depth(x, y) = depth_value;
        motion.view().Row(y)[2 * x] = mx;
        motion.view().Row(y)[2 * x + 1] = my;
      }
    }
  }
  float& Depth(int x, int y) { return depth.view().Row<float>(y)[x]; }
  FrameGeometry Geometry() const { return {.depth = depth.view(), .motion = motion.view()}; }

  ImageBuffer depth;
  MotionBuffer motion;
};

Image Constant(float value) {
  Image image(kWidth, kHeight, 3);
  image.data.assign(image.data.size(), value);
  return image;
}

TEST(TemporalError, AConstantErrorIsNoneAndFlickerIsAll) {
  const Surface still(0, 0, 0.5f);
  const Image up = Constant(0.125f), down = Constant(-0.125f);
  const auto same = TemporalError(up, still.Geometry(), up, still.Geometry(), 0);
  EXPECT_EQ(same.values, 3 * kWidth * kHeight);
  EXPECT_EQ(same.Rms(), 0);
  EXPECT_DOUBLE_EQ(TemporalError(up, still.Geometry(), down, still.Geometry(), 0).Rms(), 0.25);
}

TEST(TemporalError, FollowsTheMotion) {
  // An error that moves by (2, 1) with its surface, read where it was.
  Image before(kWidth, kHeight, 1), now(kWidth, kHeight, 1);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      before.at(x, y) = static_cast<float>(0.01 * x * x - 0.02 * y);
      now.at(x, y) = static_cast<float>(0.01 * (x - 2) * (x - 2) - 0.02 * (y - 1));
    }
  }
  const Surface moving(2, 1, 0.5f), still(0, 0, 0.5f);
  const auto followed = TemporalError(now, moving.Geometry(), before, moving.Geometry(), 0);
  EXPECT_LT(followed.Rms(), 1e-6);
  EXPECT_EQ(followed.values, (kWidth - 2) * (kHeight - 1)) << "positions inside the image";
  EXPECT_GT(TemporalError(now, still.Geometry(), before, still.Geometry(), 0).Rms(), 0.05);
}

TEST(TemporalError, ReadsBetweenPixels) {
  Image before(kWidth, kHeight, 1), now(kWidth, kHeight, 1);
  before.at(4, 3) = 1;
  const Surface half(0.5f, 0.25f, 0.5f);
  // Read at (x - 0.5, y - 0.25): weights 0.5 0.75, 0.5 0.25 on both sides of the one texel.
  const auto sum = TemporalError(now, half.Geometry(), before, half.Geometry(), 1);
  EXPECT_NEAR(sum.squares, 2 * (0.375 * 0.375 + 0.125 * 0.125), 1e-9);
  EXPECT_EQ(sum.values, (kWidth - 2) * (kHeight - 2));
}

TEST(TemporalError, LeavesOutWhatWasNotVisibleBefore) {
  const Surface still(0, 0, 0.5f);
  Surface before(0, 0, 0.5f);
  before.Depth(5, 4) = 0.4f;   // an object that went away
  before.Depth(6, 4) = 0.54f;  // the same surface
  before.Depth(7, 4) = NAN;    // the background
  EXPECT_FALSE(WasVisible(still.Geometry(), before.Geometry(), 5, 4));
  EXPECT_TRUE(WasVisible(still.Geometry(), before.Geometry(), 6, 4));
  EXPECT_FALSE(WasVisible(still.Geometry(), before.Geometry(), 7, 4));
  const auto sum = TemporalError(Constant(1), still.Geometry(), Constant(0), before.Geometry(), 3);
  EXPECT_EQ(sum.values, 3 * (6 * 2 - 2));
  EXPECT_DOUBLE_EQ(sum.Rms(), 1);
}

TEST(TemporalError, OfNothingIsNotANumber) {
  const Surface away(100, 0, 0.5f), lost(NAN, 0, 0.5f);
  const Image error = Constant(1);
  EXPECT_TRUE(std::isnan(TemporalError(error, away.Geometry(), error, away.Geometry(), 0).Rms()));
  EXPECT_TRUE(std::isnan(TemporalError(error, lost.Geometry(), error, lost.Geometry(), 0).Rms()));
  EXPECT_TRUE(std::isnan(TemporalErrorSum{}.Rms()));
}

}  // namespace
}  // namespace warplut
