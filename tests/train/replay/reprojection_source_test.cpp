#include "train/replay/reprojection_source.h"

#include <gtest/gtest.h>

#include "tests/runtime/peers/test_camera.h"

namespace warplut {
namespace {

constexpr int kWidth = 48, kHeight = 32;

CameraMatrices CameraOfFrame(int frame) {
  // Faster from frame to frame.
  return LookingCamera({0.1 * frame * frame, 0, 0}, 0, kWidth, kHeight);
}

// Frames of a wall before a camera that moves; an object of 4 x 4 pixels moves by itself.
Clip WallClip(int frames, int every) {
  Clip clip;
  clip.render = clip.output = {kWidth, kHeight};
  clip.depth_unit = 10;
  for (int f = 0; f < frames; ++f) {
    ClipFrame frame;
    frame.number = f;
    frame.cut = f == 0;
    frame.camera = CameraOfFrame(f);
    frame.color = ImageBuffer(kWidth, kHeight, PixelFormat::kRgba8);
    frame.depth = ImageBuffer(kWidth, kHeight, PixelFormat::kR32F);
    frame.motion = MotionBuffer(kWidth, kHeight);
    const auto carrier = *PointCarrier::Of(
        KnownCameras(CameraOfFrame(std::max(f - every, 0)), CameraOfFrame(f)), kWidth, kHeight);
    const float mx = carrier.forward.Apply(20, 16, 2).x - 20;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const bool object = x >= 8 + 4 * f && x < 12 + 4 * f && y >= 10 && y < 14;
        frame.depth.view().Row<float>(y)[x] = 0.5f;
        frame.motion.view().Row(y)[2 * x] = mx + (object ? 4 : 0);
        frame.motion.view().Row(y)[2 * x + 1] = 0;
        frame.color.view().Row<std::uint8_t>(y)[4 * x] = static_cast<std::uint8_t>(10 * f);
      }
    }
    clip.frames.push_back(std::move(frame));
  }
  return clip;
}

double PlaceX(const CameraMatrices& camera) { return -camera.view[3]; }

TEST(ReprojectionSource, CamerasFollowTheSchedule) {
  const Clip clip = WallClip(5, 2);
  ASSERT_TRUE(HasCameras(clip));
  const auto at = [&](CameraSchedule schedule, double time) {
    return PlaceX(CameraAt(clip, schedule, 2, time));
  };
  EXPECT_NEAR(at(CameraSchedule::kOfFrame, 3), 0.9, 1e-12);
  EXPECT_NEAR(at(CameraSchedule::kOfFrame, 2.5), 0.65, 1e-12);
  EXPECT_NEAR(at(CameraSchedule::kBetween, 3), 1.0, 1e-12);  // of 0.4 and 1.6
  EXPECT_NEAR(at(CameraSchedule::kBetween, 4), 1.6, 1e-12);
  EXPECT_NEAR(at(CameraSchedule::kBetween, 5), 2.2, 1e-12);  // the last two go on
}

TEST(ReprojectionSource, WhatTheCamerasDoNotExplainMoves) {
  const Clip clip = WallClip(5, 2);
  ReprojectionSource source(clip, CameraSchedule::kOfFrame, 2, false);
  const Reprojection& known = source.At(2, 3);
  EXPECT_EQ(known.depth_unit, 10);
  ASSERT_NE(known.moving.data, nullptr);
  ASSERT_NE(known.drawn.data, nullptr);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool rows = y >= 9 && y < 15;
      EXPECT_EQ(known.moving.Row<float>(y)[x] != 0, rows && x >= 15 && x < 21) << x << " " << y;
      const std::uint8_t* drawn = known.drawn.Row<std::uint8_t>(y) + 4 * x;
      EXPECT_EQ(drawn[3], rows && x >= 19 && x < 25 ? 255 : 0) << x << " " << y;
      EXPECT_EQ(drawn[0], 30);
    }
  }
  EXPECT_EQ(source.At(2, 2.5).drawn.data, nullptr);
}

TEST(ReprojectionSource, BeforeACutTheCameraStays) {
  Clip clip = WallClip(5, 2);
  clip.frames[3].cut = true;
  ReprojectionSource source(clip, CameraSchedule::kOfFrame, 2, false);
  const Reprojection& known = source.At(2, 3);
  EXPECT_EQ(PlaceX(known.generated), PlaceX(known.source));
  EXPECT_EQ(known.drawn.data, nullptr);
}

TEST(ReprojectionSource, AClipWithoutACameraHasNone) {
  Clip clip = WallClip(5, 2);
  clip.frames[1].camera.reset();
  EXPECT_FALSE(HasCameras(clip));
}

}  // namespace
}  // namespace warplut
