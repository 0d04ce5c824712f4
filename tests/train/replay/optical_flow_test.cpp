#include "train/replay/optical_flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "runtime/image_buffer.h"

namespace warplut {
namespace {

// A texture of many sizes that was moved by (dx, dy).
ImageBuffer Moved(int width, int height, float dx, float dy) {
  ImageBuffer image(width, height, PixelFormat::kRgba32F);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float u = static_cast<float>(x) - dx, v = static_cast<float>(y) - dy;
      const float value = 0.5f + 0.2f * std::sin(0.31f * u + 0.12f * v) * std::cos(0.23f * v) +
                          0.2f * std::sin(0.11f * u - 0.4f * v);
      for (int c = 0; c < 4; ++c) image.view().Row<float>(y)[4 * x + c] = value;
    }
  }
  return image;
}

TEST(OpticalFlow, FindsThePan) {
  const ImageBuffer before = Moved(96, 64, 0, 0), now = Moved(96, 64, 2.5f, -1.25f);
  MotionBuffer motion(96, 64);
  OpticalFlow flow(96, 64, ColorEncoding::kDisplay);
  flow.Find(before.view(), now.view(), motion.view());
  double x_error = 0, y_error = 0;
  for (int y = 16; y < 48; ++y) {
    for (int x = 16; x < 80; ++x) {
      x_error += std::abs(motion.view().Row(y)[2 * x] - 2.5) / (32 * 64);
      y_error += std::abs(motion.view().Row(y)[2 * x + 1] + 1.25) / (32 * 64);
    }
  }
  EXPECT_LT(x_error, 0.25);
  EXPECT_LT(y_error, 0.25);
}

TEST(OpticalFlow, IsFiniteForAnyColors) {
  ImageBuffer before = Moved(40, 40, 0, 0), now = Moved(40, 40, 1, 0);
  const float odd[] = {std::numeric_limits<float>::quiet_NaN(),
                       std::numeric_limits<float>::infinity(), -1e30f, 1e30f};
  for (int i = 0; i < 160; ++i) {
    now.view().Row<float>(i % 40)[i] = odd[i % 4];
    before.view().Row<float>(39 - i % 40)[i] = odd[i % 4];
  }
  MotionBuffer motion(40, 40);
  for (const ColorEncoding encoding : {ColorEncoding::kDisplay, ColorEncoding::kLinearHdr}) {
    OpticalFlow(40, 40, encoding)
        .Find(std::as_const(before).view(), std::as_const(now).view(), motion.view());
    for (int y = 0; y < 40; ++y) {
      for (int i = 0; i < 80; ++i) ASSERT_TRUE(std::isfinite(motion.view().Row(y)[i]));
    }
  }
}

TEST(OpticalFlow, SmallImagesStandStill) {
  for (const int size : {1, 7, kLeastFlowSize - 1, kLeastFlowSize, kLeastFlowSize + 1}) {
    const ImageBuffer before = Moved(size, 40, 0, 0), now = Moved(size, 40, 1, 0);
    MotionBuffer motion(size, 40);
    OpticalFlow(size, 40, ColorEncoding::kDisplay).Find(before.view(), now.view(), motion.view());
    if (size >= kLeastFlowSize) continue;
    for (int y = 0; y < 40; ++y) {
      for (int i = 0; i < 2 * size; ++i) ASSERT_EQ(motion.view().Row(y)[i], 0);
    }
  }
}

}  // namespace
}  // namespace warplut
