#include "runtime/hud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "runtime/core/pixel.h"
#include "runtime/image_buffer.h"

namespace warplut {
namespace {

constexpr int kWidth = 37, kHeight = 35;

// Values to 1.5, and some that are no numbers where the format has them; half of the pixels are 0.
ImageBuffer RandomLayer(PixelFormat format, unsigned seed, bool broken) {
  ImageBuffer image(kWidth, kHeight, format);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(0.0f, 1.5f);
  const float odd[4] = {std::nanf(""), std::numeric_limits<float>::infinity(), -1.0f, 7e4f};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (random() % 2 == 0) continue;
      for (int c = 0; c < 4; ++c) {
        const float v = broken && random() % 8 == 0 ? odd[random() % 4] : value(random);
        StoreChannel(format, v * ChannelScale(format), image.view().At(x, y), c);
      }
    }
  }
  return image;
}

double Limited(double value, double most) {
  return std::isnan(value) ? 0 : std::fmin(std::fmax(value, 0), most);
}

TEST(Hud, IsTheFormulaInEveryFormatAndEncoding) {
  ThreadPool executor(3);
  for (const ColorEncoding encoding : {ColorEncoding::kDisplay, ColorEncoding::kLinearHdr}) {
    const double most = encoding == ColorEncoding::kDisplay ? 1.0 : double{kLargestHdr};
    for (const PixelFormat layer_format : kColorFormats) {
      for (const PixelFormat format : kColorFormats) {
        const ImageBuffer hud = RandomLayer(layer_format, 1, true);
        const ImageBuffer before = RandomLayer(format, 2, false);
        ImageBuffer image = RandomLayer(format, 2, false);
        DrawHud(hud, encoding, executor, image);
        const auto load = [](const ImageView& view, int x, int y, int c) {
          return double{LoadChannel(view.format, view.At(x, y), c)} / ChannelScale(view.format);
        };
        for (int y = 0; y < kHeight; ++y) {
          for (int x = 0; x < kWidth; ++x) {
            const double alpha = Limited(load(hud, x, y, 3), 1);
            bool empty = alpha == 0;
            for (int c = 0; c < 3; ++c) empty = empty && Limited(load(hud, x, y, c), most) == 0;
            for (int c = 0; c < 3; ++c) {
              const double behind = load(before, x, y, c);
              const double drawn =
                  Limited(load(hud, x, y, c), most) + (1 - alpha) * Limited(behind, most);
              const double expected = empty ? behind : std::fmin(drawn, most);
              const double unit = format == PixelFormat::kRgba8     ? 0.51 / 255
                                  : format == PixelFormat::kRgba16F ? 0.0006 * (1 + expected)
                                                                    : 1e-6 * (1 + expected);
              const double shown =
                  format == PixelFormat::kRgba8 ? std::fmin(expected, 1) : expected;
              ASSERT_NEAR(load(image, x, y, c), shown, unit)
                  << Name(layer_format) << " over " << Name(format) << ", " << x << ", " << y;
            }
            ASSERT_EQ(load(image, x, y, 3), load(before, x, y, 3));
          }
        }
      }
    }
  }
}

TEST(Hud, AnEmptyOneKeepsTheBits) {
  SerialExecutor executor;
  const ImageBuffer hud(kWidth, kHeight, PixelFormat::kRgba8);
  const ImageBuffer before = RandomLayer(PixelFormat::kRgba32F, 3, true);
  ImageBuffer image = RandomLayer(PixelFormat::kRgba32F, 3, true);
  DrawHud(hud, ColorEncoding::kDisplay, executor, image);
  EXPECT_EQ(std::memcmp(image.view().data, before.view().data, before.bytes()), 0);
}

TEST(Hud, IsChecked) {
  const ImageBuffer hud(kWidth, kHeight, PixelFormat::kRgba8);
  ImageBuffer image(kWidth, kHeight, PixelFormat::kRgba16F), other(kWidth, 3, PixelFormat::kRgba8);
  std::string why;
  EXPECT_TRUE(IsDrawable(hud, image, &why)) << why;
  EXPECT_FALSE(IsDrawable(hud, other, &why));
  EXPECT_EQ(why, "The HUD is 37 x 35; expected 37 x 3.");
  ImageBuffer depth(kWidth, kHeight, PixelFormat::kR32F);
  EXPECT_FALSE(IsDrawable(depth, image, &why));
  EXPECT_EQ(why, "The HUD has the format r32f; expected rgba8, rgba16f or rgba32f.");
}

}  // namespace
}  // namespace warplut
