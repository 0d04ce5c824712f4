// A warp alone on a GPU against the processor: every filter, odd sizes, broken motion, and
// Catmull-Rom in fewer fetches.
#include "runtime/gpu/gpu_warp.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "luts/baked/warplut_iir_x2.h"
#include "luts/baked/warplut_t24_x2.h"
#include "luts/baked/warplut_x2.h"
#include "runtime/prefilter.h"
#include "tests/runtime/gpu/gpu_fixture.h"

namespace warplut {
namespace {

class GpuWarpTest : public GpuTest {
 protected:
  static GpuWarpOptions Options(int width, int height, const WarpOptions& warp,
                                PixelFormat format = PixelFormat::kRgba32F) {
    return {.width = width, .height = height, .format = format, .warp = warp};
  }

  // A random image and motion, some of it whole, far or no number.
  void Fill(int width, int height) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> color(0, 1), moved(-5, 5);
    image_ = ImageBuffer(width, height, PixelFormat::kRgba32F);
    motion_ = MotionBuffer(width, height);
    for (int i = 0; i < width * height; ++i) {
      // Halves hold every 1 / 1024 up to 1.
      for (int c = 0; c < 4; ++c)
        image_.view().Row<float>(i / width)[4 * (i % width) + c] =
            std::round(color(random) * 1024) / 1024;
      float* m = motion_.view().Row(i / width) + 2 * (i % width);
      m[0] = i % 7 == 0 ? 2 : moved(random);
      m[1] = i % 14 == 0 ? -1 : moved(random);
      if (i % 31 == 0) m[i % 2] = kNaN;
      if (i % 37 == 0) m[i % 2] = -kInfinity;
      if (i % 41 == 0) m[i % 2] = 1e30f;
    }
  }

  ImageBuffer Expected(const WarpOptions& warp) const {
    const ImageView image = image_.view();
    ImageBuffer out(image.width, image.height, PixelFormat::kRgba32F);
    const Prefilter prefilter = PrefilterOf(warp);
    if (!HasPrefilter(prefilter)) {
      WarpReference(image, motion_.view(), warp, out.view());
      return out;
    }
    ImageBuffer coefficients(image.width, image.height, PixelFormat::kRgba32F);
    PrefilterPass::Reference(prefilter, image, coefficients.view());
    WarpReference(PrefilteredImage{image, std::as_const(coefficients).view()}, motion_.view(), warp,
                  out.view());
    return out;
  }

  ImageBuffer Found(const GpuWarpOptions& options) const {
    std::string why;
    EXPECT_TRUE(options.IsValid(&why)) << why;
    ImageBuffer out(options.width, options.height, PixelFormat::kRgba32F);
    GpuWarp warp(device(), options);
    warp.Apply(image_.view(), motion_.view(), out.view());
    return out;
  }

  const Table iir_{baked::kWarplutIirX2}, plain_{baked::kWarplutX2}, wide_{baked::kWarplutT24X2};
  ImageBuffer image_;
  MotionBuffer motion_;
};

TEST_F(GpuWarpTest, EveryFilterAgrees) {
  Fill(53, 37);
  std::vector<WarpOptions> warps;
  for (const FilterInfo& info : kFilters) {
    if (info.filter != Filter::kLut) warps.push_back({.filter = info.filter});
  }
  for (const Table* table : {&iir_, &plain_, &wide_}) {
    for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear})
      warps.push_back({.filter = Filter::kLut, .table = table, .lookup = lookup});
  }
  for (std::size_t i = 0; i < warps.size(); ++i)
    ExpectClose(Found(Options(53, 37, warps[i])), Expected(warps[i]), kGpuBound32,
                "warp " + std::to_string(i));
}

TEST_F(GpuWarpTest, HalvesAndOddSizesAgree) {
  const WarpOptions warp = {.filter = Filter::kLut, .table = &iir_};
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 5}, {1, 40}, {161, 91}}) {
    Fill(width, height);
    const std::string what = std::to_string(width) + " x " + std::to_string(height);
    ExpectClose(Found(Options(width, height, warp)), Expected(warp), kGpuBound32, what);
    ExpectClose(Found(Options(width, height, warp, PixelFormat::kRgba16F)), Expected(warp),
                kGpuBound16, what + " in halves");
  }
}

// The sampler rounds the place of a fetch, which is within the bound of halves.
TEST_F(GpuWarpTest, NineFetchesAreCatmullRom) {
  Fill(53, 37);
  const WarpOptions warp = {.filter = Filter::kCatmullRom};
  GpuWarpOptions options = Options(53, 37, warp, PixelFormat::kRgba16F);
  options.fetches = 9;
  ExpectClose(Found(options), Expected(warp), kGpuBound16, "nine fetches");
}

// The value of a channel by five fetches: 12 taps, without the corners of the 4 x 4.
double FiveFetches(const ImageBuffer& image, int texel_x, int texel_y, double dx, double dy,
                   int channel) {
  const auto taps = [](double d) {
    return std::array{-0.5 * d * (1 - d) * (1 - d), (1.5 * d - 2.5) * d * d + 1,
                      (1.5 * (1 - d) - 2.5) * (1 - d) * (1 - d) + 1, -0.5 * (1 - d) * d * d};
  };
  const std::array wx = taps(dx), wy = taps(dy);
  double sum = 0, total = 0;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      if ((i == 0 || i == 3) && (j == 0 || j == 3)) continue;
      const int x = std::clamp(texel_x + i - 1, 0, image.view().width - 1);
      const int y = std::clamp(texel_y + j - 1, 0, image.view().height - 1);
      sum += wx[i] * wy[j] * static_cast<double>(image.view().Row<float>(y)[4 * x + channel]);
      total += wx[i] * wy[j];
    }
  }
  return sum / total;
}

TEST_F(GpuWarpTest, FiveFetchesLeaveTheCornersOut) {
  constexpr int kSide = 24;
  Fill(kSide, kSide);
  ImageBuffer expected(kSide, kSide, PixelFormat::kRgba32F);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      // In the middle between texels, where the corners count most.
      const double dx = (3 + x % 3) / 8.0, dy = (4 + y % 3) / 10.0;
      motion_.view().Row(y)[2 * x] = static_cast<float>(-1 - dx);
      motion_.view().Row(y)[2 * x + 1] = static_cast<float>(2 - dy);
      for (int c = 0; c < 3; ++c)
        expected.view().Row<float>(y)[4 * x + c] =
            static_cast<float>(FiveFetches(image_, x + 1, y - 2, dx, dy, c));
    }
  }
  const WarpOptions warp = {.filter = Filter::kCatmullRom};
  GpuWarpOptions options = Options(kSide, kSide, warp, PixelFormat::kRgba16F);
  options.fetches = 5;
  const ImageBuffer found = Found(options);
  ExpectClose(found, expected, kGpuBound16, "five fetches");
  // The corners count.
  EXPECT_GT(Difference(found, Expected(warp), kGpuBound16.worst).mean, kGpuBound16.mean);
}

TEST(GpuWarpOptions, RefusesWhatItLacks) {
  const auto reason = [](GpuWarpOptions options) {
    std::string why;
    EXPECT_FALSE(options.IsValid(&why));
    return why;
  };
  const GpuWarpOptions valid = {.width = 8, .height = 8, .warp = {.filter = Filter::kCatmullRom}};
  EXPECT_TRUE(valid.IsValid());
  GpuWarpOptions options = valid;
  options.height = 0;
  EXPECT_EQ(reason(options), "the image is 8 x 0; expected sides of 1 to 16384");
  options = valid;
  options.format = PixelFormat::kRgba8;
  EXPECT_EQ(reason(options), "the format is rgba8; the GPU takes rgba16f or rgba32f");
  options = valid;
  options.fetches = 4;
  EXPECT_EQ(reason(options), "the warp has 4 fetches; expected 16, 9 or 5");
  options.fetches = 9;
  options.format = PixelFormat::kRgba32F;
  EXPECT_EQ(reason(options),
            "a warp in 9 fetches is that of Catmull-Rom in rgba16f; the options have another "
            "filter or format");
  options = valid;
  options.warp.filter = Filter::kLut;
  EXPECT_FALSE(reason(options).empty());
}

}  // namespace
}  // namespace warplut
