// Dynamic resolution: SetRenderSize keeps the history and puts every sample where it belongs.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/image_difference.h"
#include "tests/runtime/counted_allocations.h"
#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

struct Size {
  int width, height;
};

constexpr Size kOutput = {96, 64};
constexpr Size kMost = {72, 48};

SuperResolutionOptions OptionsFor(Size render) {
  return TestOptions(render.width, render.height, kOutput.width, kOutput.height);
}

// A picture that pans: value at position (u, v) of the output.
float Picture(double u, double v) {
  return static_cast<float>(0.5 + 0.2 * std::sin(0.9 * u + 0.3 * v) + 0.2 * std::cos(0.7 * v));
}

constexpr double kPanX = 0.75, kPanY = -0.4;  // output pixels for each frame
constexpr float kJitterX[4] = {-0.25f, 0.25f, 0.25f, -0.25f};
constexpr float kJitterY[4] = {-0.25f, 0.25f, -0.25f, 0.25f};

TestFrame Render(int index, Size size) {
  TestFrame frame(size.width, size.height);
  const double scale_x = static_cast<double>(kOutput.width) / size.width;
  const double scale_y = static_cast<double>(kOutput.height) / size.height;
  frame.jitter_x = kJitterX[index % 4];
  frame.jitter_y = kJitterY[index % 4];
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const float v = Picture((x + 0.5 + frame.jitter_x) * scale_x - kPanX * index,
                              (y + 0.5 + frame.jitter_y) * scale_y - kPanY * index);
      frame.SetColor(x, y, v, v, v);
    }
  }
  frame.SetMotion(static_cast<float>(kPanX / scale_x), static_cast<float>(kPanY / scale_y));
  return frame;
}

// Mean PSNR, in dB, of frames 8 to 23 whose sizes are those of the list in turn; -1 if a pixel is
// no number.
double PsnrWith(const std::vector<Size>& sizes, int hold = 1) {
  SerialExecutor executor;
  SuperResolution sr(OptionsFor(kMost), executor);
  ImageBuffer out(kOutput.width, kOutput.height, PixelFormat::kRgba32F);
  double sum = 0;
  int count = 0;
  for (int i = 0; i < 24; ++i) {
    const Size size = sizes[static_cast<std::size_t>(i / hold) % sizes.size()];
    sr.SetRenderSize(size.width, size.height);
    sr.Process(Render(i, size).View(), out.view());
    double squares = 0, pixels = 0;
    for (int y = 8; y < kOutput.height - 8; ++y) {
      for (int x = 8; x < kOutput.width - 8; ++x, ++pixels) {
        const double error = At(out, x, y, 0) - Picture(x + 0.5 - kPanX * i, y + 0.5 - kPanY * i);
        if (!std::isfinite(error)) return -1;
        squares += error * error;
      }
    }
    if (i < 8) continue;
    sum -= 10 * std::log10(squares / pixels);
    ++count;
  }
  return sum / count;
}

TEST(RenderSize, IsToTheBitThatOfAnObjectOfThatSize) {
  for (const Size size : {Size{72, 48}, {48, 32}, {37, 29}, {24, 16}}) {
    for (const bool filters_motion : {false, true}) {
      SuperResolutionOptions most = OptionsFor(kMost), own = OptionsFor(size);
      most.motion_filter = own.motion_filter = filters_motion;
      most.reactive = own.reactive = true;
      SerialExecutor executor;
      SuperResolution changed(most, executor), made(own, executor);
      // Frames of the larger size come first; a cut ends what they left in the history.
      ImageBuffer a = OutputOf(own), b = OutputOf(own);
      TestFrame before(kMost.width, kMost.height);
      before.Randomise(9, true);
      changed.Process(before.View(), a.view());
      changed.SetRenderSize(size.width, size.height);
      TestFrame frame(size.width, size.height);
      ImageBuffer mask(size.width, size.height, PixelFormat::kR32F);
      for (unsigned i = 0; i < 5; ++i) {
        frame.Randomise(i, i == 3);
        frame.cut = i == 0;
        mask.view().Row<float>(5)[7] = 0.5f;
        RenderedFrame view = frame.View();
        view.reactive = mask.view();
        changed.Process(view, a.view());
        made.Process(view, b.view());
        ASSERT_TRUE(SameBits(a, b)) << size.width << " x " << size.height << ", frame " << i;
        changed.SetRenderSize(size.width, size.height);
      }
    }
  }
}

TEST(RenderSize, FastPassesEqualTheReference) {
  SuperResolutionOptions options = OptionsFor(kMost);
  options.history_format = PixelFormat::kRgba32F;
  SerialExecutor executor;
  SuperResolution fast(options, executor);
  options.reference = true;
  SuperResolution plain(options, executor);
  ImageBuffer a = OutputOf(options), b = OutputOf(options);
  unsigned i = 0;
  for (const Size size : {Size{72, 48}, {40, 27}, {24, 16}, {71, 47}}) {
    TestFrame frame(size.width, size.height);
    frame.Randomise(i++);
    fast.SetRenderSize(size.width, size.height);
    plain.SetRenderSize(size.width, size.height);
    fast.Process(frame.View(), a.view());
    plain.Process(frame.View(), b.view());
    ASSERT_LE(Compare(a.view(), b.view()).largest, 1e-4) << size.width;
    ASSERT_LE(Compare(fast.Geometry().motion, plain.Geometry().motion).largest, 1e-3);
  }
}

// A history made of frames of several sizes is as good as those of the sizes themselves: a shift of
// a tenth of a pixel would cost the picture 8 dB.
TEST(RenderSize, BackAndForthKeepsTheQuality) {
  const double large = PsnrWith({{72, 48}}), small = PsnrWith({{48, 32}}),
               odd = PsnrWith({{53, 37}});
  EXPECT_GT(small, 34);
  EXPECT_GT(odd, 34);
  EXPECT_GT(PsnrWith({{72, 48}, {48, 32}}), std::min(large, small) - 0.5);
  EXPECT_GT(PsnrWith({{72, 48}, {48, 32}}, 4), std::min(large, small) - 0.5);
  EXPECT_GT(PsnrWith({{48, 32}, {72, 48}, {53, 37}, {49, 33}}), std::min(odd, small) - 0.5);
}

TEST(RenderSize, IsBoundedByTheOptionsAndTheOutput) {
  SerialExecutor executor;
  const SuperResolution sr(OptionsFor(kMost), executor);
  std::string why;
  EXPECT_TRUE(sr.IsRenderSize(72, 48, &why)) << why;
  EXPECT_TRUE(sr.IsRenderSize(24, 16, &why)) << why;
  for (const Size size : {Size{73, 48}, {72, 49}, {23, 48}, {72, 15}, {0, 16}, {24, -1}}) {
    EXPECT_FALSE(sr.IsRenderSize(size.width, size.height, &why));
    EXPECT_NE(why.find("24 x 16 to 72 x 48 was expected"), std::string::npos) << why;
  }
}

TEST(RenderSize, FramesOfAnotherSizeAreRefused) {
  SerialExecutor executor;
  SuperResolution sr(OptionsFor(kMost), executor);
  ImageBuffer out(kOutput.width, kOutput.height, PixelFormat::kRgba8);
  const TestFrame large(kMost.width, kMost.height), small(48, 32);
  std::string why;
  EXPECT_TRUE(sr.IsProcessable(large.View(), out.view(), &why)) << why;
  sr.SetRenderSize(48, 32);
  EXPECT_TRUE(sr.IsProcessable(small.View(), out.view(), &why)) << why;
  EXPECT_FALSE(sr.IsProcessable(large.View(), out.view(), &why));
  EXPECT_NE(why.find("colour is 72 x 48; expected 48 x 32"), std::string::npos) << why;
}

// The geometry of a frame stays that of the frame, whatever size the next one has.
TEST(RenderSize, LeavesTheLastFramesGeometry) {
  SerialExecutor executor;
  SuperResolution changed(OptionsFor(kMost), executor), kept(OptionsFor(kMost), executor);
  ImageBuffer out(kOutput.width, kOutput.height, PixelFormat::kRgba8);
  TestFrame frame(kMost.width, kMost.height);
  frame.Randomise(3);
  changed.Process(frame.View(), out.view());
  kept.Process(frame.View(), out.view());
  changed.SetRenderSize(48, 32);
  const OutputGeometry a = changed.Geometry(), b = kept.Geometry();
  EXPECT_EQ(Compare(a.motion, b.motion).largest, 0);
  EXPECT_EQ(Compare(a.depth, b.depth).largest, 0);
}

TEST(RenderSize, AllocatesNothing) {
  SerialExecutor executor;
  SuperResolution sr(OptionsFor(kMost), executor);
  ImageBuffer out(kOutput.width, kOutput.height, PixelFormat::kRgba8);
  const TestFrame large(kMost.width, kMost.height), small(48, 32);
  sr.Process(large.View(), out.view());
  const std::size_t bytes = sr.MemoryBytes();
  const std::int64_t before = CountedAllocations();
  sr.SetRenderSize(48, 32);
  sr.Process(small.View(), out.view());
  sr.SetRenderSize(72, 48);
  sr.Process(large.View(), out.view());
  EXPECT_EQ(CountedAllocations(), before);
  EXPECT_EQ(sr.MemoryBytes(), bytes);
}

}  // namespace
}  // namespace warplut
