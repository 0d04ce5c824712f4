#include "runtime/motion_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "runtime/gates.h"
#include "tests/image_difference.h"
#include "tests/runtime/motion/camera_frame.h"

namespace warplut {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

MotionBuffer Filtered(CameraFrame& frame, const MotionFilterOptions& options = {},
                      int threads = 1) {
  MotionBuffer out(frame.width, frame.height);
  MotionFilter filter(frame.width, frame.height, options);
  ThreadPool pool(threads);
  filter.Apply(frame.depth.view(), frame.motion.view(), pool, out.view());
  return out;
}

bool SameBits(const MotionView& a, const MotionView& b) {
  for (int y = 0; y < a.height; ++y) {
    if (std::memcmp(a.Row(y), b.Row(y), sizeof(float) * 2 * static_cast<std::size_t>(a.width)) !=
        0) {
      return false;
    }
  }
  return true;
}

TEST(MotionFilter, LeavesExactMotionAsItIs) {
  CameraFrame frame = CameraFrame::UnderCamera(160, 90);
  EXPECT_LT(Compare(Filtered(frame).view(), frame.truth.view()).largest, 1e-4);
}

TEST(MotionFilter, LeavesMotionLinearInInverseDepthAsItIs) {
  CameraFrame frame = CameraFrame::UnderCamera(96, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 96; ++x) {
      const float g = InverseDepth(frame.Depth(x, y));
      frame.Set(x, y, 0.05f * g + 1.5f, -0.02f * g + 0.25f);
    }
  }
  frame.CopyToTruth();
  EXPECT_LT(Compare(Filtered(frame).view(), frame.truth.view()).largest, 1e-4);
}

TEST(MotionFilter, RecoversQuantisedMotion) {
  for (const float step : {0.25f, 1.0f}) {
    CameraFrame frame = CameraFrame::UnderCamera(320, 180);
    frame.Quantise(step);
    const double before = Compare(frame.motion.view(), frame.truth.view()).rms;
    const double after = Compare(Filtered(frame).view(), frame.truth.view()).rms;
    EXPECT_NEAR(before, step / std::sqrt(12.0), 0.02 * step);
    EXPECT_LT(after, 0.08 * before) << step;
  }
}

TEST(MotionFilter, LeavesMovingObjectsToTheBit) {
  CameraFrame frame = CameraFrame::UnderCamera(320, 180);
  frame.Quantise(0.5f);
  const auto on_object = [](int x, int y) { return x >= 60 && x < 260 && y >= 30 && y < 130; };
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 320; ++x) {
      if (on_object(x, y)) frame.Set(x, y, 20.5f, -7.0f);
    }
  }
  const MotionBuffer out = Filtered(frame);
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 320; ++x) {
      const float* m = out.view().Row(y) + 2 * x;
      if (on_object(x, y)) {
        EXPECT_EQ(m[0], 20.5f);
        EXPECT_EQ(m[1], -7.0f);
      } else {
        EXPECT_NEAR(m[0], frame.truth.view().Row(y)[2 * x], 0.1f);
      }
    }
  }
}

TEST(MotionFilter, IsNotLedByNearPixelsThatMoveWithTheCamera) {
  CameraFrame frame = CameraFrame::UnderCamera(320, 180);
  frame.Quantise(0.5f);
  for (int y = 130; y < 180; ++y) {
    for (int x = 200; x < 300; ++x) {
      frame.Depth(x, y) = 0.0005f;
      frame.Set(x, y, 0, 0);
      frame.truth.view().Row(y)[2 * x] = 0;
      frame.truth.view().Row(y)[2 * x + 1] = 0;
    }
  }
  EXPECT_LT(Compare(Filtered(frame).view(), frame.truth.view()).rms, 0.05);
}

TEST(MotionFilter, ChangesByNoMoreThanTheLimit) {
  CameraFrame frame = CameraFrame::UnderCamera(160, 90);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(-3, 3);
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 160; ++x) frame.Set(x, y, noise(random), noise(random));
  }
  for (const float limit : {0.125f, 1.0f}) {
    const Difference change =
        Compare(Filtered(frame, {.limit = limit}).view(), frame.motion.view());
    EXPECT_LE(change.largest, limit * (1 + 1e-6));
    EXPECT_GT(change.largest, 0.5 * limit);
  }
}

TEST(MotionFilter, CopiesWhatIsNotFiniteAndDoesNotFitIt) {
  CameraFrame frame = CameraFrame::UnderCamera(160, 90);
  frame.Quantise(0.5f);
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 160; x += 3) {
      frame.Set(x, y, x % 2 ? kNan : 1.0f, x % 2 ? 2.0f : -kInfinity);
    }
  }
  const MotionBuffer out = Filtered(frame);
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 160; ++x) {
      const float* m = out.view().Row(y) + 2 * x;
      if (x % 3 == 0) {
        EXPECT_EQ(std::memcmp(m, frame.motion.view().Row(y) + 2 * x, 2 * sizeof(float)), 0);
      } else {
        EXPECT_NEAR(m[0], frame.truth.view().Row(y)[2 * x], 0.1f);
      }
    }
  }
}

TEST(MotionFilter, TakesAnyDepth) {
  CameraFrame frame = CameraFrame::UnderCamera(160, 90);
  frame.Quantise(0.5f);
  const float odd[] = {kNan, kInfinity, -1.0f, 0.0f, -0.0f, 1e-30f, 2e30f};
  for (int i = 0; i < 7; ++i) frame.Depth(10 + i, 33) = odd[i];
  const MotionBuffer out = Filtered(frame);
  const Difference change = Compare(out.view(), frame.motion.view());
  EXPECT_LE(change.largest, 1.0);
  EXPECT_TRUE(std::isfinite(change.rms));
}

TEST(MotionFilter, MatchesTheReferenceAtAnySize) {
  const int sizes[][2] = {{1, 1},  {1, 40},  {40, 1},   {3, 3},
                          {17, 5}, {33, 31}, {321, 97}, {130, 70}};
  for (const auto& [width, height] : sizes) {
    CameraFrame frame = CameraFrame::UnderCamera(width, height);
    frame.Quantise(0.5f);
    MotionBuffer reference(width, height);
    MotionFilter::Reference(frame.depth.view(), frame.motion.view(), {}, reference.view());
    const MotionBuffer out = Filtered(frame);
    // On the limit, one may replace what the other keeps.
    EXPECT_LE(Compare(out.view(), reference.view(), 1e-4).share, 0.001) << width << " x " << height;
  }
}

TEST(MotionFilter, GivesTheSameBitsForAnyThreadsAndInPlace) {
  CameraFrame frame = CameraFrame::UnderCamera(203, 117);
  frame.Quantise(0.5f);
  const MotionBuffer one = Filtered(frame);
  for (const int threads : {2, 3, 8}) {
    EXPECT_TRUE(SameBits(Filtered(frame, {}, threads).view(), one.view())) << threads;
  }
  SerialExecutor executor;
  MotionFilter filter(frame.width, frame.height, {});
  filter.Apply(frame.depth.view(), frame.motion.view(), executor, frame.motion.view());
  EXPECT_TRUE(SameBits(std::as_const(frame.motion).view(), one.view()));
}

TEST(MotionFilter, KeepsNoStateBetweenFrames) {
  CameraFrame first = CameraFrame::UnderCamera(96, 64, 1);
  CameraFrame second = CameraFrame::UnderCamera(96, 64, 2);
  first.Quantise(0.5f);
  second.Quantise(0.25f);
  const MotionBuffer alone = Filtered(second);
  MotionFilter filter(96, 64, {});
  SerialExecutor executor;
  MotionBuffer out(96, 64);
  const std::size_t bytes = filter.MemoryBytes();
  filter.Apply(first.depth.view(), first.motion.view(), executor, out.view());
  filter.Apply(second.depth.view(), second.motion.view(), executor, out.view());
  EXPECT_TRUE(SameBits(std::as_const(out).view(), alone.view()));
  EXPECT_EQ(filter.MemoryBytes(), bytes);
}

TEST(MotionFilterOptions, NamesTheLimit) {
  for (const float limit : {0.0f, -1.0f, 17.0f, kNan}) {
    std::string why;
    EXPECT_FALSE(MotionFilterOptions{.limit = limit}.IsValid(&why));
    EXPECT_NE(why.find("limit"), std::string::npos);
    EXPECT_FALSE(MotionFilterOptions{.limit = limit}.IsValid());
  }
  EXPECT_TRUE(MotionFilterOptions{}.IsValid());
}

TEST(CameraFit, MeasuresTheNoise) {
  CameraFrame frame = CameraFrame::UnderCamera(320, 180);
  EXPECT_LT(CameraFit(320, 180).Fit(frame.depth.view(), frame.motion.view()).noise_x, 1e-4);
  frame.Quantise(0.5f);
  const CameraMotion camera = CameraFit(320, 180).Fit(frame.depth.view(), frame.motion.view());
  EXPECT_NEAR(camera.noise_x, 0.125, 0.01);
  EXPECT_NEAR(camera.noise_y, 0.125, 0.01);
}

TEST(CameraFit, TakesOneDepthAndOneMotion) {
  CameraFrame frame(64, 48);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      frame.Depth(x, y) = 0.5f;
      frame.Set(x, y, 3.25f, -1.5f);
    }
  }
  const CameraMotion camera = CameraFit(64, 48).Fit(frame.depth.view(), frame.motion.view());
  const auto [mx, my] = camera.At(63, 0, 2.0f, 64, 48);
  EXPECT_NEAR(mx, 3.25, 1e-5);
  EXPECT_NEAR(my, -1.5, 1e-5);
}

TEST(CameraFit, NeedsEnoughPixels) {
  CameraFrame frame = CameraFrame::UnderCamera(6, 6);
  const CameraMotion camera = CameraFit(6, 6).Fit(frame.depth.view(), frame.motion.view());
  for (const double c : camera.c) EXPECT_EQ(c, 0);
  EXPECT_EQ(camera.noise_x, 0);
}

}  // namespace
}  // namespace warplut
