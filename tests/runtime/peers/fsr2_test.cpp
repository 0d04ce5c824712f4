// Locks and limits of fsr2.
#include "runtime/peers/sr/fsr2.h"

#include "runtime/method.h"
#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

// Whether the middle of 5 x 5 grey samples is a thin feature.
bool IsThin(const float (&luma)[5][5], float ratio) {
  SuperResolutionOptions options = TestOptions(5, 5, 5, 5);
  const AxisMap axis(5, 5);
  RenderPlanes planes(5, 5);
  for (Plane& plane : planes.color) {
    for (int y = 0; y < 5; ++y) {
      std::copy_n(luma[y], 5, plane.Row(y));
      plane.ExtendRow(y);
    }
  }
  const Plane none;
  const AliasingMap aliasing;
  const SrJob job{options, axis,  axis, planes, none, none, none,  {},
                  {},      false, {},   {},     {},   {},   &none, &aliasing};
  return peers::IsThinFeature(job, 2, 2, ratio);
}

TEST(Fsr2, FindsThinFeatures) {
  constexpr float o = 0.2f, l = 0.3f;
  EXPECT_TRUE(IsThin(
      {{o, o, l, o, o}, {o, o, l, o, o}, {o, o, l, o, o}, {o, o, l, o, o}, {o, o, l, o, o}}, 1.05f))
      << "a line";
  EXPECT_TRUE(IsThin(
      {{o, o, o, o, o}, {o, l, o, o, o}, {o, o, l, o, o}, {o, o, o, l, o}, {o, o, o, o, o}}, 1.05f))
      << "a diagonal";
  EXPECT_TRUE(IsThin(
      {{l, l, l, l, l}, {l, l, l, l, l}, {l, l, o, l, l}, {l, l, l, l, l}, {l, l, l, l, l}}, 1.05f))
      << "a dark point";
  EXPECT_FALSE(IsThin(
      {{o, o, l, l, o}, {o, o, l, l, o}, {o, o, l, l, o}, {o, o, l, l, o}, {o, o, l, l, o}}, 1.05f))
      << "a line of two samples";
  EXPECT_FALSE(IsThin(
      {{o, o, l, l, l}, {o, o, l, l, l}, {o, o, l, l, l}, {o, o, l, l, l}, {o, o, l, l, l}}, 1.05f))
      << "an edge";
  EXPECT_FALSE(IsThin(
      {{o, o, o, o, o}, {o, o, o, o, o}, {o, o, o, o, o}, {o, o, o, o, o}, {o, o, o, o, o}}, 1.05f))
      << "nothing";
  EXPECT_FALSE(IsThin(
      {{o, o, l, o, o}, {o, o, l, o, o}, {o, o, l, o, o}, {o, o, l, o, o}, {o, o, l, o, o}}, 1.6f))
      << "all are alike";
}

// The mean of a line of one output pixel in the last of many frames, at factor 2: one in two frames
// has samples of it.
float LineBrightness(float lock_ratio) {
  SerialExecutor executor;
  SuperResolutionOptions options = TestOptions(24, 16, 48, 32);
  FindMethod("fsr2")->configure_super_resolution(options);
  options.parameters.fsr2_lock_ratio = lock_ratio;
  SuperResolution sr(options, executor);
  ImageBuffer out = OutputOf(options);
  TestFrame frame(24, 16);
  for (int i = 0; i < 42; ++i) {
    frame.jitter_x = i % 2 == 0 ? -0.25f : 0.25f;
    frame.jitter_y = i / 2 % 2 == 0 ? -0.25f : 0.25f;
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 24; ++x) {
        const float u = (static_cast<float>(x) + 0.5f + frame.jitter_x) * 2;
        const float v = static_cast<int>(u) == 20 ? 0.5f : 0.3f;
        frame.SetColor(x, y, v, v, v);
      }
    }
    sr.Process(frame.View(), out.view());
  }
  float sum = 0;
  for (int y = 8; y < 24; ++y) sum += At(out, 20, y, 0) / 16;
  return sum;
}

TEST(Fsr2, ALockHoldsALineThatOneFrameInTwoShows) {
  const float locked = LineBrightness(1.05f), free = LineBrightness(2.0f);
  EXPECT_GT(locked, free + 0.02f);
  EXPECT_GT(locked, 0.36f);
}

TEST(Fsr2, AHistoryIsLimitedToTheTexelsAroundItsSource) {
  SuperResolutionOptions options = TestOptions(6, 4, 6, 4);
  ImageBuffer history(6, 4, PixelFormat::kRgba32F), next(6, 4, PixelFormat::kRgba32F);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 6; ++x) {
      for (int c = 0; c < 4; ++c) {
        history.view().Row<float>(y)[4 * x + c] = static_cast<float>(x + 10 * y);
        next.view().Row<float>(y)[4 * x + c] = 100;
      }
    }
  }
  MotionBuffer motion(6, 4);
  const auto limited = [&](float mx, float my) {
    motion.view().Row(1)[4] = mx;
    motion.view().Row(1)[5] = my;
    next.view().Row<float>(1)[8] = 100;
    const AxisMap x(6, 6), y(4, 4);
    const RenderPlanes planes;
    const Plane none;
    const AliasingMap aliasing;
    const SrJob job{options,
                    x,
                    y,
                    planes,
                    none,
                    none,
                    none,
                    {},
                    {},
                    true,
                    std::as_const(history).view(),
                    {},
                    next.view(),
                    {},
                    &none,
                    &aliasing};
    peers::LimitToTexels(job, std::as_const(motion).view(), 2, 1);
    return next.view().Row<float>(1)[8];
  };
  EXPECT_EQ(limited(0, 0), 23);          // pixels 2 and 3 of rows 1 and 2
  EXPECT_EQ(limited(0.5f, 0.5f), 12);    // 1 and 2 of rows 0 and 1
  EXPECT_EQ(limited(-0.5f, 0.25f), 13);  // 2 and 3 of rows 0 and 1
  EXPECT_EQ(limited(100, -100), 30);     // the nearest corner
}

}  // namespace
}  // namespace warplut
