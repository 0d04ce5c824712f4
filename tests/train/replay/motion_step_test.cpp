#include "train/replay/motion_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/image_buffer.h"

namespace warplut {
namespace {

// Motion of a camera that turns and travels, in steps of `step` pixels (0: as it is).
MotionBuffer CameraMotion(float step) {
  MotionBuffer motion(160, 90);
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 160; ++x) {
      float* m = motion.view().Row(y) + 2 * x;
      m[0] = 6.0f * std::sin(0.013f * static_cast<float>(x) + 0.003f * static_cast<float>(y));
      m[1] = 0.05f * static_cast<float>(y) - 0.001f * static_cast<float>(x);
      for (int c = 0; c < 2 && step > 0; ++c) m[c] = step * std::round(m[c] / step);
    }
  }
  return motion;
}

double StepOf(const MotionBuffer& motion) { return MotionStep(motion.view()); }

TEST(MotionStep, IsThatOfTheQuantisation) {
  for (const float step : {0.5f, 0.25f, 1.0f / 16}) {
    EXPECT_NEAR(StepOf(CameraMotion(step)), step, 1e-4) << step;
  }
}

TEST(MotionStep, OfExactMotionIsSmall) { EXPECT_LT(StepOf(CameraMotion(0)), kQuantisedStep / 8); }

TEST(MotionStep, FewValuesTellNothing) {
  MotionBuffer motion(64, 64);
  EXPECT_EQ(StepOf(motion), 0);  // all zero
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      motion.view().Row(y)[2 * x] = x < 20 ? 1.37f : -4.2f;
      motion.view().Row(y)[2 * x + 1] = y < 30 ? 0.5f : 2.9f;
    }
  }
  EXPECT_EQ(StepOf(motion), 0);
}

TEST(MotionStep, ValuesThatAreNotFiniteDoNotCount) {
  MotionBuffer motion = CameraMotion(0.25f);
  motion.view().Row(3)[8] = std::numeric_limits<float>::quiet_NaN();
  motion.view().Row(4)[9] = std::numeric_limits<float>::infinity();
  EXPECT_NEAR(StepOf(motion), 0.25, 1e-4);
}

}  // namespace
}  // namespace warplut
