#include "train/fit/rollout/plane_prefilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runtime/core/instruction_sets.h"
#include "train/fit/rivals/spline_family.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

std::vector<RealPrefilter> Prefilters() {
  return {RecursivePrefilter(0.03), RecursivePrefilter(1.0 / 6),
          RecursivePrefilter(0.22), FirPrefilter(0.12, 1),
          FirPrefilter(1.0 / 6, 4), FirPrefilter(0.2, kLargestFirReach)};
}

std::vector<double> Values(const BorderedPlane& plane) {
  std::vector<double> values;
  for (int y = 0; y < plane.height(); ++y) {
    for (int x = 0; x < plane.width(); ++x) values.push_back(plane.row(y)[x]);
  }
  return values;
}

BorderedPlane RandomPlane(int width, int height, std::uint64_t seed) {
  BorderedPlane plane(width, height);
  Random random(seed);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) plane.row(y)[x] = static_cast<float>(random.Uniform() - 0.5);
  }
  return plane;
}

double Dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

TEST(PlanePrefilter, EqualsTheReferenceForAnySize) {
  for (const auto& [width, height] :
       {std::pair{1, 1}, {2, 1}, {3, 7}, {31, 9}, {48, 3}, {33, 70}, {128, 128}}) {
    const BorderedPlane in = RandomPlane(width, height, 4);
    for (const RealPrefilter& prefilter : Prefilters()) {
      PlanePrefilter pass(width, height);
      pass.Set(prefilter);
      BorderedPlane out(width, height);
      pass.Apply(in, out);
      const auto expected = PlanePrefilter::Reference(prefilter, width, height, Values(in));
      double largest = 0;
      for (const double value : expected) largest = std::max(largest, std::abs(value));
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          ASSERT_NEAR(out.row(y)[x], expected[static_cast<std::size_t>(y) * width + x],
                      2e-6 * largest)
              << width << " x " << height << ", " << x << " " << y << " side " << prefilter.side;
        }
      }
      EXPECT_EQ(out.row(-1)[-1], out.row(0)[0]);
      EXPECT_EQ(out.row(height + 1)[-2], out.row(std::max(height - 2, 0))[std::min(1, width - 1)]);
    }
  }
}

// The whole offset of the reference's result is the image again.
TEST(PlanePrefilter, ReferenceOfRecursiveInvertsTheWholeOffset) {
  constexpr int kWidth = 11;
  const RealPrefilter prefilter = RecursivePrefilter(0.19);
  std::vector<double> samples(kWidth);
  for (int i = 0; i < kWidth; ++i) samples[i] = std::sin(3.0 * i * i);
  const auto c = PlanePrefilter::Reference(prefilter, kWidth, 1, samples);
  const auto at = [&](int i) { return c[ContinuedPixel(i, kWidth, Border::kMirrored)]; };
  const double s = prefilter.side;
  for (int i = 0; i < kWidth; ++i) {
    EXPECT_NEAR(s * at(i - 1) + (1 - 2 * s) * at(i) + s * at(i + 1), samples[i], 1e-13);
  }
}

TEST(PlanePrefilter, IsItsOwnAdjointAndKeepsConstants) {
  const BorderedPlane x = RandomPlane(37, 22, 1), y = RandomPlane(37, 22, 2);
  BorderedPlane flat(37, 22);
  for (int row = 0; row < 22; ++row) std::fill_n(flat.row(row), 37, 0.7f);
  for (const RealPrefilter& prefilter : Prefilters()) {
    PlanePrefilter pass(37, 22);
    pass.Set(prefilter);
    BorderedPlane px(37, 22), constant(37, 22), adjoint = y;
    pass.Apply(x, px);
    RealPrefilter unused;
    pass.Adjoint(x, px, adjoint, unused);
    EXPECT_NEAR(Dot(Values(px), Values(y)), Dot(Values(x), Values(adjoint)), 1e-4);
    pass.Apply(flat, constant);
    for (const double value : Values(constant)) EXPECT_NEAR(value, 0.7, 3e-6);
    for (int i = 1; i <= BorderedPlane::kBorder; ++i) {
      EXPECT_EQ(adjoint.row(3)[-i], 0);
      EXPECT_EQ(adjoint.row(-i)[3], 0);
      EXPECT_EQ(adjoint.row(21 + i)[36 + i], 0);
    }
  }
}

// Against central differences of the reference, in double.
TEST(PlanePrefilter, GradientOfSideAndTapsIsRight) {
  constexpr int kWidth = 29, kHeight = 34;
  const BorderedPlane x = RandomPlane(kWidth, kHeight, 1), g = RandomPlane(kWidth, kHeight, 2);
  const auto value = [&](const RealPrefilter& prefilter) {
    return Dot(Values(g), PlanePrefilter::Reference(prefilter, kWidth, kHeight, Values(x)));
  };
  for (const RealPrefilter& prefilter : Prefilters()) {
    PlanePrefilter pass(kWidth, kHeight);
    pass.Set(prefilter);
    BorderedPlane c(kWidth, kHeight), adjoint = g;
    pass.Apply(x, c);
    RealPrefilter gradient;
    pass.Adjoint(x, c, adjoint, gradient);
    const auto compare = [&](double analytic, double RealPrefilter::*side, int tap) {
      constexpr double kStep = 1e-5;
      RealPrefilter above = prefilter, below = prefilter;
      (side != nullptr ? above.*side : above.taps[tap]) += kStep;
      (side != nullptr ? below.*side : below.taps[tap]) -= kStep;
      const double expected = (value(above) - value(below)) / (2 * kStep);
      EXPECT_NEAR(analytic, expected, 1e-4 * (1 + std::abs(expected))) << tap;
    };
    if (prefilter.kind == PrefilterKind::kRecursive) {
      compare(gradient.side, &RealPrefilter::side, 0);
    } else {
      for (int j = 0; j <= prefilter.reach; ++j) compare(gradient.taps[j], nullptr, j);
      EXPECT_EQ(gradient.side, 0);
    }
  }
}

}  // namespace
}  // namespace warplut
