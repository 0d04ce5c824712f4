#include "runtime/generation/motion_model.h"

#include <gtest/gtest.h>

namespace warplut::generation {
namespace {

// Position of a point that is uniformly accelerated: 0 at time 0, with frames at -1, 0 and 1.
double Position(double speed, double acceleration, double time) {
  return speed * time + 0.5 * acceleration * time * time;
}

TEST(MotionModel, FollowsUniformAcceleration) {
  for (const double speed : {-3.0, 0.5, 7.0}) {
    for (const double acceleration : {-2.0, 0.0, 1.25}) {
      const auto at = [&](double time) { return Position(speed, acceleration, time); };
      const double m1 = at(1) - at(0), m0 = at(0) - at(-1);
      for (const double alpha : {0.1, 0.25, 0.5, 0.9}) {
        EXPECT_NEAR(at(1) + InterpolatedDisplacement(m1, m0, alpha), at(alpha), 1e-12);
        EXPECT_NEAR(at(1) + ExtrapolatedDisplacement(m1, m0, alpha), at(1 + alpha), 1e-12);
      }
    }
  }
}

TEST(MotionModel, IsLinearForEqualMotion) {
  EXPECT_DOUBLE_EQ(InterpolatedDisplacement(4.0, 4.0, 0.25), -3.0);
  EXPECT_DOUBLE_EQ(ExtrapolatedDisplacement(4.0, 4.0, 0.25), 1.0);
}

}  // namespace
}  // namespace warplut::generation
