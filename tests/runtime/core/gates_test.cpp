#include "runtime/gates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace warplut {
namespace {

template <class T>
class Gates : public ::testing::Test {
 protected:
  static constexpr T kNan = std::numeric_limits<T>::quiet_NaN();
  static constexpr T kInfinity = std::numeric_limits<T>::infinity();
};
using Floats = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Gates, Floats);

TYPED_TEST(Gates, HardGateIncludesTheThreshold) {
  using T = TypeParam;
  const T threshold = T(0.25);
  EXPECT_EQ(Gate(threshold, threshold, T(0)), 1);
  EXPECT_EQ(Gate(std::nextafter(threshold, T(1)), threshold, T(0)), 0);
  EXPECT_EQ(Gate(-this->kInfinity, threshold, T(0)), 1);
  EXPECT_EQ(Gate(this->kInfinity, threshold, T(0)), 0);
  EXPECT_EQ(Gate(T(0), T(0), T(0)), 1);
}

TYPED_TEST(Gates, NanIsBeyond) {
  using T = TypeParam;
  for (const T width : {T(0), T(0.5), T(1)}) EXPECT_EQ(Gate(this->kNan, T(0.25), width), 0);
}

TYPED_TEST(Gates, ZeroThresholdIsHardAtAnyWidth) {
  using T = TypeParam;
  for (const T width : {T(0), T(0.5), T(1)}) {
    EXPECT_EQ(Gate(T(0), T(0), width), 1);
    EXPECT_EQ(Gate(T(1e-6), T(0), width), 0);
  }
}

TYPED_TEST(Gates, SoftGateIsARampAcrossTheThreshold) {
  using T = TypeParam;
  const T threshold = T(0.5);
  for (const T width : {T(0.125), T(0.5), T(1)}) {
    EXPECT_EQ(Gate(threshold * (1 - width), threshold, width), 1);
    EXPECT_EQ(Gate(threshold * (1 + width), threshold, width), 0);
    EXPECT_NEAR(Gate(threshold, threshold, width), T(0.5), 1e-6);
    EXPECT_NEAR(Gate(threshold * (1 + width / 2), threshold, width), T(0.25), 1e-6);
    T before = 1;
    for (T x = -1; x < 2; x += T(0.01)) {
      const T gate = Gate(x, threshold, width);
      EXPECT_LE(gate, before);
      EXPECT_GE(gate, 0);
      before = gate;
    }
  }
}

TYPED_TEST(Gates, SoftGateConvergesToTheHardOne) {
  using T = TypeParam;
  const T threshold = T(0.1);
  for (const T x : {T(-1), T(0), T(0.09), T(0.0999), T(0.1001), T(0.11), T(3)}) {
    EXPECT_EQ(Gate(x, threshold, T(1e-4)), Gate(x, threshold, T(0))) << x;
  }
}

TYPED_TEST(Gates, DepthDifference) {
  using T = TypeParam;
  EXPECT_EQ(DepthDifference(DepthMeasure::kNone, T(3), T(1)), 0);
  EXPECT_EQ(DepthDifference(DepthMeasure::kAbsolute, T(3), T(1)), 2);
  EXPECT_NEAR(DepthDifference(DepthMeasure::kRelative, T(0.5), T(0.25)), 1, 1e-6);
  for (const DepthMeasure measure : {DepthMeasure::kAbsolute, DepthMeasure::kRelative}) {
    for (const T a : {T(0), T(1e-3), T(0.5), T(kFarthestDepth)}) {
      EXPECT_EQ(DepthDifference(measure, a, a), 0);
      for (const T b : {T(0), T(0.1), T(kFarthestDepth)}) {
        const T difference = DepthDifference(measure, a, b);
        EXPECT_EQ(difference, -DepthDifference(measure, b, a));
        EXPECT_FALSE(std::isnan(difference));
      }
    }
  }
}

TYPED_TEST(Gates, SampleWeightIsACone) {
  using T = TypeParam;
  EXPECT_EQ(SampleWeight(T(2), T(0)), 1);
  EXPECT_EQ(SampleWeight(T(2), T(0.25)), T(0.5));
  EXPECT_EQ(SampleWeight(T(2), T(0.75)), 0);
  EXPECT_EQ(SampleWeight(T(0), T(5)), 1);
}

TYPED_TEST(Gates, BlendShareIsAtMostOne) {
  using T = TypeParam;
  EXPECT_EQ(BlendShare(T(0.5), T(0.5)), T(0.25));
  EXPECT_EQ(BlendShare(T(6), T(0.5)), 1);
}

// Equation 1 of the paper, as printed.
template <class T>
T Equation1(T depth, T brightness, T alpha, T depth_threshold, T brightness_threshold) {
  if (depth > depth_threshold) return 0;
  if (depth < -depth_threshold) return 1;
  if (std::abs(brightness) <= brightness_threshold) return alpha >= T(0.5) ? 1 : 0;
  return alpha;
}

TYPED_TEST(Gates, HardInterpolationShareIsEquation1) {
  using T = TypeParam;
  for (const T depth : {T(-1), T(-0.11), T(-0.09), T(0), T(0.09), T(0.11), T(1)}) {
    for (const T brightness : {T(-0.3), T(-0.04), T(0), T(0.04), T(0.06)}) {
      for (const T alpha : {T(0.1), T(0.5), T(0.75)}) {
        EXPECT_EQ(InterpolationShare(depth, brightness, alpha, T(0.1), T(0.05), T(0)),
                  Equation1(depth, brightness, alpha, T(0.1), T(0.05)))
            << depth << " " << brightness << " " << alpha;
      }
    }
  }
}

TYPED_TEST(Gates, InterpolationShareIsInZeroToOne) {
  using T = TypeParam;
  for (T depth = -1; depth <= 1; depth += T(0.03)) {
    for (T brightness = -1; brightness <= 1; brightness += T(0.07)) {
      for (const T alpha : {T(0.01), T(0.49), T(0.5), T(0.99)}) {
        for (const T width : {T(0), T(0.3), T(1)}) {
          const T share = InterpolationShare(depth, brightness, alpha, T(0.2), T(0.1), width);
          EXPECT_GE(share, T(-1e-6));
          EXPECT_LE(share, T(1 + 1e-6));
        }
      }
    }
  }
}

TEST(DepthMeasures, HaveNames) {
  EXPECT_EQ(std::string(Name(DepthMeasure::kNone)), "none");
  EXPECT_EQ(std::string(Name(DepthMeasure::kAbsolute)), "absolute");
  EXPECT_EQ(std::string(Name(DepthMeasure::kRelative)), "relative");
}

}  // namespace
}  // namespace warplut
