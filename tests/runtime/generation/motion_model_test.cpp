#include "runtime/generation/motion/motion_model.h"

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

// Frames -1, 0 and 1 of a point whose h = (x z, z) is quadratic in time, z linear.
TEST(PerspectivePath, FollowsHomogeneousCoordinates) {
  const double z0 = 5, dz = -0.5;
  const auto depth = [&](double t) { return z0 + dz * t; };
  const auto at = [&](double t) { return (3 + 2 * t + 0.7 * t * t) / depth(t); };
  const double m1 = at(1) - at(0), m0 = at(0) - at(-1);
  for (const double time : {0.1, 0.5, 0.9, 1.25, 1.5, 1.9}) {
    const PerspectivePath<double> path{time, depth(0) / depth(1)};
    EXPECT_NEAR(path.Depth(), depth(time) / depth(1), 1e-12);
    EXPECT_NEAR(path.DepthBefore(), depth(-1) / depth(1), 1e-12);
    EXPECT_NEAR(at(1) + path.Displacement(m1, m0, 1.0), at(time), 1e-12);
  }
}

TEST(PerspectivePath, WithoutM0FollowsASteadyPoint) {
  const auto depth = [](double t) { return 4 - 0.8 * t; };
  const auto at = [&](double t) { return (1 + 3 * t) / depth(t); };
  for (const double time : {0.5, 1.5}) {
    const PerspectivePath<double> path{time, depth(0) / depth(1)};
    EXPECT_NEAR(at(1) + path.Displacement(at(1) - at(0), 99.0, 0.0), at(time), 1e-12);
  }
}

TEST(PerspectivePath, IsQuadraticAtConstantDepth) {
  for (const double alpha : {0.25, 0.5, 0.75}) {
    const PerspectivePath<double> between{alpha, 1}, after{1 + alpha, 1};
    EXPECT_NEAR(between.Displacement(4.0, 3.0, 1.0), InterpolatedDisplacement(4.0, 3.0, alpha),
                1e-12);
    EXPECT_NEAR(after.Displacement(4.0, 3.0, 1.0), ExtrapolatedDisplacement(4.0, 3.0, alpha),
                1e-12);
  }
}

}  // namespace
}  // namespace warplut::generation
