// A scene and a camera that stand still: MotionUpsampling::kStatic, and the tiles that are counted.
#include <string_view>

#include "runtime/warp.h"
#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

constexpr int kWidth = 75, kHeight = 21, kScale = 2;

SuperResolutionOptions Options(MotionUpsampling motion) {
  SuperResolutionOptions options = TestOptions(kWidth, kHeight, kScale * kWidth, kScale * kHeight);
  options.motion = motion;
  options.depth = DepthMeasure::kNone;
  return options;
}

TestFrame StillFrame(unsigned seed) {
  TestFrame frame(kWidth, kHeight);
  frame.Randomise(seed);
  frame.SetMotion(0, 0);
  return frame;
}

TEST(Static, IsWhatMotionOfZeroGives) {
  for (const HistoryForm form :
       {HistoryForm::kSample, HistoryForm::kResidual, HistoryForm::kAdaptive}) {
    for (const ColorClamp clamp : {ColorClamp::kNone, ColorClamp::kVariance}) {
      for (const PixelFormat format :
           {PixelFormat::kRgba8, PixelFormat::kRgba16F, PixelFormat::kRgba32F}) {
        SCOPED_TRACE(testing::Message() << Name(form) << " " << Name(clamp) << " " << Name(format));
        SuperResolutionOptions still = Options(MotionUpsampling::kStatic);
        SuperResolutionOptions moving = Options(MotionUpsampling::kNearest);
        for (SuperResolutionOptions* options : {&still, &moving}) {
          options->form = form;
          options->clamp = clamp;
          options->history_format = format;
        }
        SerialExecutor executor;
        SuperResolution a(still, executor), b(moving, executor);
        ImageBuffer out_a = OutputOf(still), out_b = OutputOf(moving);
        for (unsigned i = 0; i < 5; ++i) {
          TestFrame frame = StillFrame(i);
          frame.cut = i == 3;
          a.Process(frame.View(), out_a.view());
          b.Process(frame.View(), out_b.view());
          ASSERT_TRUE(SameBits(out_a, out_b)) << i;
        }
        EXPECT_LT(a.MemoryBytes(), b.MemoryBytes());
      }
    }
  }
}

TEST(Static, NeedsNeitherMotionNorDepth) {
  const SuperResolutionOptions options = Options(MotionUpsampling::kStatic);
  SerialExecutor executor;
  SuperResolution with(options, executor), without(options, executor);
  ImageBuffer out_with = OutputOf(options), out_without = OutputOf(options);
  for (unsigned i = 0; i < 3; ++i) {
    const TestFrame frame = StillFrame(i);
    RenderedFrame view = frame.View();
    with.Process(view, out_with.view());
    view.depth = {};
    view.motion = {};
    std::string why;
    ASSERT_TRUE(without.IsProcessable(view, out_without.view(), &why)) << why;
    without.Process(view, out_without.view());
    ASSERT_TRUE(SameBits(out_with, out_without)) << i;
  }
  const OutputGeometry geometry = without.Geometry();
  EXPECT_EQ(geometry.depth.Row<float>(3)[5], kFarthestDepth);
  EXPECT_EQ(geometry.motion.Row(3)[10], 0.0f);
}

constexpr std::int64_t kTiles = 3 * 3;  // of 150 x 42 pixels

// Whether the kernels are the formulas, which know no tiles of motion.
bool HasNoTiles() { return std::string_view(WarpTarget()) == "SCALAR"; }

TEST(Tiles, OfAStillSceneAreStatic) {
  if (HasNoTiles()) return;
  for (const MotionUpsampling motion : {MotionUpsampling::kStatic, MotionUpsampling::kEdgeAware}) {
    const SuperResolutionOptions options = Options(motion);
    SerialExecutor executor;
    SuperResolution sr(options, executor);
    ImageBuffer out = OutputOf(options);
    const TestFrame frame = StillFrame(1);
    sr.Process(frame.View(), out.view());
    EXPECT_EQ(sr.Tiles().total, kTiles);
    EXPECT_EQ(sr.Tiles().disoccluded, kTiles);
    EXPECT_EQ(sr.Tiles().warped[MotionKind::kStatic], 0);
    sr.Process(frame.View(), out.view());
    EXPECT_EQ(sr.Tiles().total, kTiles);
    EXPECT_EQ(sr.Tiles().disoccluded, 0);
    EXPECT_EQ(sr.Tiles().warped[MotionKind::kStatic], kTiles);
  }
}

TEST(Tiles, TellMotionAndWhereItCameFromOutside) {
  if (HasNoTiles()) return;
  const SuperResolutionOptions options = Options(MotionUpsampling::kNearest);
  for (const int threads : {1, 3}) {
    ThreadPool executor(threads);
    SuperResolution sr(options, executor);
    ImageBuffer out = OutputOf(options);
    TestFrame frame = StillFrame(1);
    sr.Process(frame.View(), out.view());
    frame.SetMotion(0.3f, 0);
    sr.Process(frame.View(), out.view());
    EXPECT_EQ(sr.Tiles().warped[MotionKind::kUniform], kTiles);
    EXPECT_EQ(sr.Tiles().disoccluded, 3);  // the left column
    frame.SetMotion(70, 10, 0.5f, 0.5f);
    sr.Process(frame.View(), out.view());
    EXPECT_EQ(sr.Tiles().warped[MotionKind::kGeneral], 1);
  }
}

}  // namespace
}  // namespace warplut
