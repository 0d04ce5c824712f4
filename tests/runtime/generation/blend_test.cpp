#include "runtime/generation/blend.h"

#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

TEST(LeastDepthAround, IsOfThePixelsInTheImage) {
  TestImage depth(3, 2, PixelFormat::kR32F, 8);
  depth.Fill(0.5f);
  depth.Set(2, 0, 0, 0.25f);
  const ImageView view = depth.history();
  EXPECT_EQ(LeastDepthAround(view, 0, 0), 0.5f);
  EXPECT_EQ(LeastDepthAround(view, 1, 1), 0.25f);
  EXPECT_EQ(LeastDepthAround(view, 2, 1), 0.25f);
}

TEST(LeastDepthAround, TakesOddDepthsForTheFarthest) {
  TestImage depth(3, 3, PixelFormat::kR32F, 8);
  for (const float odd : {std::numeric_limits<float>::quiet_NaN(), -1.0f,
                          std::numeric_limits<float>::infinity(), 3e38f}) {
    depth.Fill(odd);
    EXPECT_EQ(LeastDepthAround(depth.history(), 1, 1), kFarthestDepth) << odd;
    depth.Set(0, 2, 0, 7);
    EXPECT_EQ(LeastDepthAround(depth.history(), 1, 1), 7) << odd;
  }
  depth.Set(2, 0, 0, -0.0f);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(LeastDepthAround(depth.history(), 1, 1)), 0U);
}

// A near square passes over a grey background that stands still. The pixels beside it hold some of
// its colour, as in a frame with antialiasing; the other frame shows the background there.
TEST(Blend, LeavesOutTheRimOfTheForeground) {
  constexpr int kWidth = 64, kHeight = 24, kStart0 = 8, kStart1 = 40, kSide = 8;
  const auto frame_at = [&](int start) {
    TestFrame frame(kWidth, kHeight, PixelFormat::kRgba8);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const bool square = x >= start && x < start + kSide && y >= 8 && y < 8 + kSide;
        const bool beside = x >= start - 1 && x <= start + kSide && y >= 7 && y <= 8 + kSide;
        for (int c = 0; c < 3; ++c) frame.color.Set(x, y, c, square ? 250 : beside ? 150 : 100);
        frame.motion.Set(x, y, square ? kStart1 - kStart0 : 0, 0);
        if (square) frame.depth.Set(x, y, 0, 0.1f);
      }
    }
    return frame;
  };
  const TestFrame frame0 = frame_at(kStart0), frame1 = frame_at(kStart1);
  for (const bool reference : {true, false}) {
    FrameGenerationOptions options = OptionsFor(frame0);
    options.reference = reference;
    const TestImage out =
        Generate(options, frame0.view(), frame1.view(), 0.5f, true, PixelFormat::kRgba8);
    for (int y = 0; y < kHeight; ++y) {
      for (const int start : {kStart0, kStart1}) {
        for (int x = start - 1; x <= start + kSide; ++x) EXPECT_EQ(out.Get(x, y, 0), 100);
      }
    }
  }
}

}  // namespace
}  // namespace warplut::generation
