// A HUD belongs to a displayed frame and is drawn over what is generated.
#include "runtime/hud.h"

#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

constexpr int kWidth = 70, kHeight = 33;

// Opaque in every fifth column, half transparent in a bar, elsewhere nothing.
ImageBuffer MakeHud(float value) {
  ImageBuffer hud(kWidth, kHeight, PixelFormat::kRgba32F);
  for (int y = 8; y < 16; ++y) {
    for (int x = 10; x < 50; ++x) {
      float* pixel = hud.view().Row<float>(y) + 4 * x;
      const bool opaque = x % 5 == 0;
      std::fill_n(pixel, 3, opaque ? value : 0.0f);
      pixel[3] = opaque ? 1.0f : 0.5f;
    }
  }
  return hud;
}

bool SameBits(const TestImage& a, const TestImage& b) {
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (int c = 0; c < 4; ++c) {
        if (a.Get(x, y, c) != b.Get(x, y, c)) return false;
      }
    }
  }
  return true;
}

TEST(HudOfAFrame, IsDrawnOverWhatIsGeneratedWithoutIt) {
  SerialExecutor executor;
  const ImageBuffer hud0 = MakeHud(0.25f), hud1 = MakeHud(1);
  for (const ColorEncoding encoding : {ColorEncoding::kDisplay, ColorEncoding::kLinearHdr}) {
    for (const PixelFormat format : kColorFormats) {
      const TestFrame a = RandomFrame(kWidth, kHeight, format, 1, false);
      const TestFrame b = RandomFrame(kWidth, kHeight, format, 2, false);
      FrameGenerationOptions options = OptionsFor(a);
      options.encoding = encoding;
      for (const bool cut : {false, true}) {
        for (const float alpha : {0.25f, 0.5f}) {
          for (const bool interpolates : {true, false}) {
            DisplayedFrame frame0 = a.view(), frame1 = b.view(cut);
            TestImage expected = Generate(options, frame0, frame1, alpha, interpolates, format);
            const ImageBuffer& nearer = interpolates && alpha < 0.5f ? hud0 : hud1;
            DrawHud(nearer, encoding, executor, expected.view());
            frame0.hud = hud0.view();
            frame1.hud = hud1.view();
            ASSERT_TRUE(
                SameBits(Generate(options, frame0, frame1, alpha, interpolates, format), expected))
                << Name(encoding) << ", " << Name(format) << ", cut " << cut << ", " << alpha;
          }
        }
      }
    }
  }
}

TEST(HudOfAFrame, IsCheckedInBothFrames) {
  const TestFrame frame(kWidth, kHeight, PixelFormat::kRgba8);
  const ImageBuffer small(kWidth, kHeight - 1, PixelFormat::kRgba8);
  const ImageBuffer depth(kWidth, kHeight, PixelFormat::kR32F);
  SerialExecutor executor;
  const FrameGeneration generation(OptionsFor(frame), executor);
  TestImage out(kWidth, kHeight, PixelFormat::kRgba8);
  DisplayedFrame frame0 = frame.view(), frame1 = frame.view();
  std::string why;
  frame0.hud = small.view();
  EXPECT_FALSE(generation.IsGenerable(frame0, frame1, 0.5f, out.view(), &why));
  EXPECT_EQ(why, "The HUD of frame 0 is 70 x 32; expected 70 x 33.");
  frame0.hud = {};
  frame1.hud = depth.view();
  EXPECT_FALSE(generation.IsGenerable(frame0, frame1, 0.5f, out.view(), &why));
  EXPECT_EQ(why, "The HUD of frame 1 has the format r32f; expected rgba8, rgba16f or rgba32f.");
}

}  // namespace
}  // namespace warplut::generation
