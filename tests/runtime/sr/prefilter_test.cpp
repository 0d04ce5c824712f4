// Super resolution whose history is warped by a filter with prefilter.
#include "tests/image_difference.h"
#include "tests/runtime/sr/sr_fixture.h"
#include "tests/runtime/warp/warp_fixture.h"

namespace warplut {
namespace {

SuperResolutionOptions SplineOptions(int render_width, int render_height, int output_width,
                                     int output_height) {
  SuperResolutionOptions options =
      TestOptions(render_width, render_height, output_width, output_height);
  options.warp.filter = Filter::kSpline;
  options.warp.spline_k = static_cast<float>(1.0 / 84);
  return options;
}

TEST(SrPrefilter, FastPassesEqualTheReference) {
  struct Case {
    PixelFormat history;
    ColorEncoding encoding;
    float tolerance;
  };
  for (const Case& c : {Case{PixelFormat::kRgba32F, ColorEncoding::kDisplay, 2e-4f},
                        Case{PixelFormat::kRgba16F, ColorEncoding::kDisplay, 6e-3f},
                        Case{PixelFormat::kRgba8, ColorEncoding::kDisplay, 3.5f / 255},
                        Case{PixelFormat::kRgba32F, ColorEncoding::kLinearHdr, 6.25f * 2e-4f}}) {
    SuperResolutionOptions options = SplineOptions(41, 29, 70, 52);
    options.history_format = c.history;
    options.encoding = c.encoding;
    std::string why;
    ASSERT_TRUE(options.IsValid(&why)) << why;
    SerialExecutor executor;
    SuperResolution fast(options, executor);
    options.reference = true;
    SuperResolution plain(options, executor);
    ImageBuffer fast_out = OutputOf(options), plain_out = OutputOf(options);
    TestFrame frame(41, 29);
    for (unsigned i = 0; i < 4; ++i) {
      frame.Randomise(i, i == 2);
      fast.Process(frame.View(), fast_out.view());
      plain.Process(frame.View(), plain_out.view());
      EXPECT_LE(Compare(fast_out.view(), plain_out.view()).largest, c.tolerance)
          << Name(c.history) << ", frame " << i;
    }
  }
}

TEST(SrPrefilter, AnyExecutorGivesTheSameBits) {
  const SuperResolutionOptions options = SplineOptions(83, 61, 141, 122);
  SerialExecutor serial;
  ThreadPool pool(3);
  SuperResolution one(options, serial), many(options, pool);
  ImageBuffer one_out = OutputOf(options), many_out = OutputOf(options);
  TestFrame frame(83, 61);
  for (unsigned i = 0; i < 4; ++i) {
    frame.Randomise(i, i == 1);
    frame.cut = i == 3;
    one.Process(frame.View(), one_out.view());
    many.Process(frame.View(), many_out.view());
    ASSERT_TRUE(SameBits(one_out, many_out)) << "frame " << i;
  }
}

TEST(SrPrefilter, AStillImageSettlesAsWithAFilterOfSamples) {
  // Nothing moves, so that every pixel is a copy of a sample: the filter has no part in the image.
  SuperResolutionOptions options = SplineOptions(24, 18, 48, 36);
  SuperResolutionOptions samples = options;
  samples.warp.filter = Filter::kCatmullRom;
  SerialExecutor executor;
  SuperResolution spline(options, executor), catmull_rom(samples, executor);
  ImageBuffer a = OutputOf(options), b = OutputOf(options);
  TestFrame frame(24, 18);
  frame.Randomise(1);
  frame.SetMotion(0, 0);
  for (int i = 0; i < 12; ++i) {
    spline.Process(frame.View(), a.view());
    catmull_rom.Process(frame.View(), b.view());
    ASSERT_TRUE(SameBits(a, b)) << "frame " << i;
  }
}

TEST(SrPrefilter, TakesOneImageMoreMemory) {
  const SuperResolutionOptions options = SplineOptions(480, 270, 960, 540);
  SuperResolutionOptions samples = options;
  samples.warp.filter = Filter::kCatmullRom;
  SerialExecutor executor;
  const std::size_t more = SuperResolution(options, executor).MemoryBytes() -
                           SuperResolution(samples, executor).MemoryBytes();
  const std::size_t image = std::size_t{960} * 540 * 8;
  EXPECT_GE(more, image);
  EXPECT_LE(more, image + image / 4);  // and what a worker needs
}

TEST(SrPrefilter, ImagesSmallerThanTheReachOfTheRecursionAreFinite) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 9}, {9, 1}, {3, 2}}) {
    SuperResolutionOptions options = SplineOptions(width, height, 2 * width, 2 * height);
    SerialExecutor executor;
    SuperResolution sr(options, executor);
    ImageBuffer out = OutputOf(options);
    TestFrame frame(width, height);
    for (unsigned i = 0; i < 6; ++i) {
      frame.Randomise(i, true);
      sr.Process(frame.View(), out.view());
      for (int y = 0; y < 2 * height; ++y) {
        for (int x = 0; x < 2 * width; ++x) {
          for (int c = 0; c < 3; ++c) {
            ASSERT_TRUE(At(out, x, y, c) >= 0 && At(out, x, y, c) <= 1) << x << ", " << y;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace warplut
