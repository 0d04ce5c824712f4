#include "train/replay/motion_composition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "datasets/scenes/scene_renderer.h"
#include "runtime/warp.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

Image Motion(int width, int height, double x, double y) {
  Image motion(width, height, 2);
  for (std::size_t i = 0; i < motion.pixels(); ++i) {
    motion.data[2 * i] = static_cast<float>(x);
    motion.data[2 * i + 1] = static_cast<float>(y);
  }
  return motion;
}

Image Depth(int width, int height, float value) {
  Image depth(width, height, 1);
  depth.data.assign(depth.pixels(), value);
  return depth;
}

TEST(MotionComposition, OneFieldIsItself) {
  const Image motion = Motion(5, 3, 1.25, -2);
  const MotionField fields[] = {{.motion = &motion}};
  EXPECT_EQ(ComposeMotion(fields).data, motion.data);
}

TEST(MotionComposition, UniformMotionsAdd) {
  const Image a = Motion(9, 7, 1.25, -0.5), b = Motion(9, 7, 0.5, 1), c = Motion(9, 7, -3, 0.25);
  const MotionField fields[] = {{.motion = &a}, {.motion = &b}, {.motion = &c}};
  const Image composed = ComposeMotion(fields);
  for (std::size_t i = 0; i < composed.pixels(); ++i) {
    EXPECT_NEAR(composed.data[2 * i], 1.25 + 0.5 - 3, 1e-6);
    EXPECT_NEAR(composed.data[2 * i + 1], -0.5 + 1 + 0.25, 1e-6);
  }
}

// A zoom about a point moves linearly with position, so that bilinear reads are exact.
TEST(MotionComposition, AZoomIsAZoomTwice) {
  constexpr double kZoom = 1.05, kCentre = 16;
  Image motion(32, 32, 2);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      motion.at(x, y, 0) = static_cast<float>((x + 0.5 - kCentre) * (1 - 1 / kZoom));
      motion.at(x, y, 1) = static_cast<float>((y + 0.5 - kCentre) * (1 - 1 / kZoom));
    }
  }
  const MotionField fields[] = {{.motion = &motion}, {.motion = &motion}};
  const Image composed = ComposeMotion(fields);
  for (int i = 0; i < 32; ++i) {
    const double expected = (i + 0.5 - kCentre) * (1 - 1 / (kZoom * kZoom));
    EXPECT_NEAR(composed.at(i, 5, 0), expected, 1e-5);
    EXPECT_NEAR(composed.at(5, i, 1), expected, 1e-5);
  }
}

TEST(MotionComposition, ReadsOnlyTheSurfaceThatItFollows) {
  // A near object of columns 8.. moves by 3, what is behind it stands still; the frame before has
  // it at columns 5...
  Image now = Motion(16, 3, 0, 0), before = Motion(16, 3, 0, 0);
  Image depth_now = Depth(16, 3, 0.9f), depth_before = Depth(16, 3, 0.9f);
  for (int y = 0; y < 3; ++y) {
    for (int x = 5; x < 16; ++x) {
      if (x >= 8) now.at(x, y, 0) = 3.4f;
      if (x >= 8) depth_now.at(x, y) = 0.2f;
      before.at(x, y, 0) = 3;
      depth_before.at(x, y) = 0.2f;
    }
  }
  const MotionField fields[] = {{.motion = &now, .depth = &depth_now},
                                {.motion = &before, .depth = &depth_before}};
  const Image composed = ComposeMotion(fields);
  EXPECT_FLOAT_EQ(composed.at(8, 1, 0), 6.4f);  // at 4.6 only the texel of column 5 is the object
  EXPECT_FLOAT_EQ(composed.at(12, 1, 0), 6.4f);
  EXPECT_FLOAT_EQ(composed.at(2, 1, 0), 0);
  EXPECT_FLOAT_EQ(composed.at(6, 1, 0), 3) << "just revealed: what hid it is read";
}

TEST(MotionComposition, ReadsAtWhereTheFrameWasSampled) {
  Image ramp(16, 3, 2);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 16; ++x) ramp.at(x, y, 0) = 0.1f * static_cast<float>(x);
  }
  const Image still = Motion(16, 3, 0, 0);
  const MotionField fields[] = {{.motion = &still, .offset = {0.25, 0}},
                                {.motion = &ramp, .offset = {-0.5, 0}}};
  // Pixel 7 was sampled at 7.75, where the frame before has index 7.75.
  EXPECT_NEAR(ComposeMotion(fields).at(7, 1, 0), 0.775, 1e-6);
}

TEST(MotionComposition, WhatIsNotFiniteStaysSo) {
  Image now = Motion(8, 8, 1, 0), before = Motion(8, 8, 1, 0);
  now.at(2, 2, 1) = std::numeric_limits<float>::quiet_NaN();
  now.at(5, 5, 0) = std::numeric_limits<float>::infinity();
  before.at(5, 2, 0) = std::numeric_limits<float>::quiet_NaN();
  for (const auto& [x, y] : {std::pair{1, 5}, {2, 5}, {1, 6}, {2, 6}}) {
    before.at(x, y, 1) = std::numeric_limits<float>::quiet_NaN();
  }
  now.at(3, 5, 0) = 1.5f;
  now.at(3, 5, 1) = -0.5f;
  const MotionField fields[] = {{.motion = &now}, {.motion = &before}};
  const Image composed = ComposeMotion(fields);
  EXPECT_TRUE(std::isnan(composed.at(2, 2, 0)) && std::isnan(composed.at(2, 2, 1)));
  EXPECT_TRUE(std::isnan(composed.at(5, 5, 0)));
  EXPECT_TRUE(std::isnan(composed.at(3, 5, 0))) << "all four texels before";
  EXPECT_FLOAT_EQ(composed.at(6, 2, 0), 1 + 1.0f) << "texels beside the one that is not finite";
}

// Mean squared error of the frame two before, warped by `motion`, against `now`.
double WarpError(const Image& before, const Image& motion, const Image& now) {
  const ImageBuffer history = ToBuffer(before, PixelFormat::kRgba32F);
  ImageBuffer out(before.width, before.height, PixelFormat::kRgba32F);
  const MotionBuffer vectors = ToMotionBuffer(motion);
  Warp(history.view(), vectors.view(), {.filter = Filter::kBilinear}, out.view());
  const Image warped = ToImage(ImageView(out.view()));
  double sum = 0;
  for (std::size_t i = 0; i < warped.data.size(); ++i) {
    const double e = static_cast<double>(warped.data[i]) - now.data[i];
    sum += e * e;
  }
  return sum / static_cast<double>(warped.data.size());
}

TEST(MotionComposition, FollowsABuiltInSceneOverTwoFrames) {
  RenderOptions options;
  options.width = 192;
  options.height = 108;
  options.frames = 4;
  options.samples = 16;
  options.inputs = false;
  for (const char* scene : {"courtyard", "street"}) {
    const SceneRenderer renderer(scene, options);
    const Frame before = renderer.Render(1), between = renderer.Render(2), now = renderer.Render(3);
    const MotionField fields[] = {
        {.motion = &now.reference_motion, .depth = &now.reference_depth},
        {.motion = &between.reference_motion, .depth = &between.reference_depth}};
    Image twice = now.reference_motion;
    for (float& m : twice.data) m *= 2;
    const double composed = WarpError(before.reference, ComposeMotion(fields), now.reference);
    const double zero = WarpError(before.reference, Motion(192, 108, 0, 0), now.reference);
    EXPECT_LT(composed, 0.6 * zero) << scene;
    EXPECT_LT(composed, WarpError(before.reference, twice, now.reference)) << scene;
  }
}

}  // namespace
}  // namespace warplut
