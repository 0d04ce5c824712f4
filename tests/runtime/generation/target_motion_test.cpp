#include "runtime/generation/motion/target_motion.h"

#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

// A frame whose arrivals a test sets one by one. Every pixel of frame 1 has the motion
// (x / 4, y / 8) and the displacement (-x / 8, y / 16), so that a motion tells its source.
class Arrived {
 public:
  explicit Arrived(int width, int height)
      : frame_(width, height, PixelFormat::kRgba8),
        options_(OptionsFor(frame_)),
        forward_(static_cast<std::size_t>(2 * width * height)),
        keys_(static_cast<std::size_t>(width * height), kNoSplat) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
        frame_.motion.Set(x, y, fx / 4, fy / 8);
        forward_[static_cast<std::size_t>(2 * (y * width + x))] = -fx / 8;
        forward_[static_cast<std::size_t>(2 * (y * width + x) + 1)] = fy / 16;
      }
    }
  }

  // The pixel of frame 1 at the same place arrives.
  void Set(int x, int y, float depth) {
    const int i = y * options_.width + x;
    keys_[static_cast<std::size_t>(i)] = MakeSplatKey(depth, static_cast<std::uint32_t>(i));
  }
  void SetAll(float depth) {
    for (int y = 0; y < options_.height; ++y) {
      for (int x = 0; x < options_.width; ++x) Set(x, y, depth);
    }
  }
  void Clear(int x, int y) { keys_[static_cast<std::size_t>(y * options_.width + x)] = kNoSplat; }

  TargetMotion At(int x, int y, bool interpolates = true) {
    const GenerationJob job{options_,
                            interpolates,
                            0.5f,
                            true,
                            frame_.depth.view(),
                            frame_.depth.view(),
                            frame_.motion.view(),
                            frame_.motion.view()};
    const Arrivals arrivals{
        {forward_.data(), options_.width, options_.height, std::ptrdiff_t{8} * options_.width},
        {keys_.data(), options_.width}};
    return TargetMotionAt(job, arrivals, x, y);
  }

  FrameGenerationOptions& options() { return options_; }

 private:
  TestFrame frame_;
  FrameGenerationOptions options_;
  std::vector<float> forward_;
  std::vector<SplatKey> keys_;
};

TEST(TargetMotion, IsThatOfWhatArrived) {
  Arrived arrived(8, 8);
  arrived.SetAll(0.5f);
  const TargetMotion motion = arrived.At(4, 6);
  EXPECT_EQ(motion.from1.x, -0.5f);
  EXPECT_EQ(motion.from1.y, 0.375f);
  EXPECT_EQ(motion.from0.x, 0.5f);
  EXPECT_EQ(motion.from0.y, 1.125f);
}

TEST(TargetMotion, LineWithoutArrivalsIsAGap) {
  Arrived arrived(9, 9);
  arrived.SetAll(0.5f);
  for (int y = 0; y < 9; ++y) arrived.Clear(4, y);
  // The mean of the six neighbours is the motion that (4, 4) would have.
  EXPECT_FLOAT_EQ(arrived.At(4, 4).from1.x, -0.5f);
  EXPECT_FLOAT_EQ(arrived.At(4, 4).from1.y, 0.25f);
  EXPECT_FLOAT_EQ(arrived.At(4, 4).from0.x, 0.5f);
}

TEST(TargetMotion, BackgroundBehindACrackIsAGap) {
  Arrived arrived(9, 9);
  arrived.SetAll(0.1f);
  arrived.Set(4, 4, 0.9f);
  arrived.Set(3, 3, 0.9f);
  // Seven neighbours are foreground.
  const float sum = 3 + 3 + 4 + 4 + 5 + 5 + 5;
  EXPECT_FLOAT_EQ(arrived.At(4, 4).from1.x, -sum / 7 / 8);
  arrived.options().refine = false;
  EXPECT_FLOAT_EQ(arrived.At(4, 4).from1.x, -0.5f);
}

TEST(TargetMotion, ThinForegroundStays) {
  Arrived arrived(9, 9);
  arrived.SetAll(0.9f);
  for (int y = 0; y < 9; ++y) arrived.Set(4, y, 0.1f);
  EXPECT_EQ(arrived.At(4, 4).from1.x, -0.5f);
  EXPECT_EQ(arrived.At(3, 4).from1.x, -0.375f);
}

TEST(TargetMotion, CornerOfAnObjectStays) {
  Arrived arrived(9, 9);
  arrived.SetAll(0.9f);
  for (int y = 4; y < 9; ++y) {
    for (int x = 4; x < 9; ++x) arrived.Set(x, y, 0.1f);
  }
  EXPECT_EQ(arrived.At(4, 4).from1.x, -0.5f);
  EXPECT_EQ(arrived.At(3, 3).from1.x, -0.375f);
}

// A wide hole between a near and a far side.
Arrived Disoccluded() {
  Arrived arrived(24, 9);
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 8; ++x) arrived.Set(x, y, 0.9f);
    for (int x = 16; x < 24; ++x) arrived.Set(x, y, 0.1f);
  }
  return arrived;
}

TEST(TargetMotion, DisocclusionTakesTheBackgroundWhenInterpolating) {
  Arrived arrived = Disoccluded();
  const TargetMotion motion = arrived.At(12, 4);
  EXPECT_EQ(motion.from1.x, -7.0f / 8);
  EXPECT_EQ(motion.from0.x, 7.0f / 8);
}

TEST(TargetMotion, DisocclusionIsFilledAsAsked) {
  Arrived arrived = Disoccluded();
  arrived.options().fill = DisocclusionFill::kOwnMotion;
  EXPECT_EQ(arrived.At(12, 4, false).from1.x, -12.0f / 8);
  arrived.options().fill = DisocclusionFill::kBackground;
  EXPECT_EQ(arrived.At(12, 4, false).from1.x, -7.0f / 8);
  arrived.options().fill = DisocclusionFill::kNone;
  EXPECT_EQ(arrived.At(12, 4, false).from1.x, 0);
}

TEST(TargetMotion, IsZeroWhereNothingArrivedAtAll) {
  Arrived arrived(9, 9);
  EXPECT_EQ(arrived.At(4, 4).from0.x, 0);
  EXPECT_EQ(arrived.At(4, 4).from1.y, 0);
}

TEST(DepthTolerance, IsTheThresholdOfTheDifference) {
  for (const DepthMeasure measure :
       {DepthMeasure::kNone, DepthMeasure::kAbsolute, DepthMeasure::kRelative}) {
    Arrived arrived(1, 1);
    arrived.options().depth = measure;
    const GenerationJob job{arrived.options(), true, 0.5f, true, {}, {}, {}, {}};
    const DepthTolerance tolerance(job);
    const float depths[] = {0, 0.1f, 0.2f, 0.25f, 0.6f, 1.0f, kFarthestDepth};
    for (const float a : depths) {
      for (const float b : depths) {
        EXPECT_EQ(tolerance.Alike(a, b),
                  std::abs(DepthDifference(measure, a, b)) <= job.depth_threshold())
            << Name(measure) << " " << a << " " << b;
      }
      EXPECT_FALSE(tolerance.Alike(a, kNoArrivalDepth));
    }
    EXPECT_TRUE(tolerance.Alike(kNoArrivalDepth, kNoArrivalDepth));
  }
}

}  // namespace
}  // namespace warplut::generation
