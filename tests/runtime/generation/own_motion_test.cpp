// Generation without splatting, and the tiles that are counted.
#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

constexpr int kWidth = 150, kHeight = 40;
constexpr std::int64_t kTiles = 3 * 3;

TestFrame Panned(unsigned seed, float mx) {
  TestFrame frame = RandomFrame(kWidth, kHeight, PixelFormat::kRgba8, seed, false);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      frame.motion.Set(x, y, mx, 0);
      frame.depth.Set(x, y, 0, 0.5f);
    }
  }
  return frame;
}

// Under one motion what arrives at a pixel has the motion of the pixel itself.
TEST(OwnMotion, IsThatOfSplattingWhereAllMovesAlike) {
  const TestFrame frame0 = Panned(1, 4), frame1 = Panned(2, 4);
  FrameGenerationOptions options = OptionsFor(frame0);
  for (const bool interpolates : {true, false}) {
    options.splat = true;
    const TestImage splatted =
        Generate(options, frame0.view(), frame1.view(), 0.5f, interpolates, PixelFormat::kRgba8);
    options.splat = false;
    const TestImage own =
        Generate(options, frame0.view(), frame1.view(), 0.5f, interpolates, PixelFormat::kRgba8);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 8; x < kWidth - 8; ++x) {
        for (int c = 0; c < 4; ++c) ASSERT_EQ(own.Get(x, y, c), splatted.Get(x, y, c)) << x;
      }
    }
  }
}

TEST(OwnMotion, StandsStillWhereMotionIsNoNumber) {
  TestFrame frame0 = Panned(1, 0), frame1 = Panned(2, 0);
  const TestImage still = [&] {
    FrameGenerationOptions options = OptionsFor(frame0);
    options.splat = false;
    return Generate(options, frame0.view(), frame1.view(), 0.5f, true, PixelFormat::kRgba8);
  }();
  for (int x = 0; x < kWidth; x += 3) frame1.motion.Set(x, 5, std::nanf(""), 2);
  FrameGenerationOptions options = OptionsFor(frame0);
  options.splat = false;
  EXPECT_TRUE(still ==
              Generate(options, frame0.view(), frame1.view(), 0.5f, true, PixelFormat::kRgba8));
}

TEST(OwnMotion, NeedsNoBuffersOfTheFrame) {
  const TestFrame frame = Panned(1, 0);
  FrameGenerationOptions options = OptionsFor(frame);
  SerialExecutor executor;
  const std::size_t with = FrameGeneration(options, executor).MemoryBytes();
  options.splat = false;
  EXPECT_GE(with, FrameGeneration(options, executor).MemoryBytes() + 16 * kWidth * kHeight);
}

FrameTiles TilesOf(const FrameGenerationOptions& options, const TestFrame& frame0,
                   const TestFrame& frame1, bool cut = false) {
  ThreadPool executor(2);
  FrameGeneration generation(options, executor);
  TestImage out(kWidth, kHeight, PixelFormat::kRgba8);
  DisplayedFrame view = frame1.view();
  view.cut = cut;
  generation.Interpolate(frame0.view(), view, 0.5f, out.view());
  return generation.Tiles();
}

TEST(GenerationTiles, AreCounted) {
  const TestFrame still = Panned(1, 0), panned = Panned(2, 3);
  const FrameGenerationOptions options = OptionsFor(still);
  const FrameTiles static_tiles = TilesOf(options, still, still);
  EXPECT_EQ(static_tiles.total, kTiles);
  EXPECT_EQ(static_tiles.warped[MotionKind::kStatic], 2 * kTiles);
  EXPECT_EQ(static_tiles.disoccluded, 0);
  const FrameTiles moving = TilesOf(options, panned, panned);
  EXPECT_EQ(moving.disoccluded, 3);  // the left column, where nothing arrives
  EXPECT_EQ(moving.warped[MotionKind::kStatic], 0);
  const FrameTiles cut = TilesOf(options, still, still, true);
  EXPECT_EQ(cut.total + cut.disoccluded + cut.warped[MotionKind::kStatic], 0);
}

TEST(GenerationTiles, InLinearHdrAreCountedOnce) {
  const TestFrame panned = Panned(2, 3);
  FrameGenerationOptions options = OptionsFor(panned);
  options.encoding = ColorEncoding::kLinearHdr;
  EXPECT_EQ(TilesOf(options, panned, panned).disoccluded, 3);
}

}  // namespace
}  // namespace warplut::generation
