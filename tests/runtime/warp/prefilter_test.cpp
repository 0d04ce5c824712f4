// The prefilter: what it solves, the fast pass against the reference on every instruction set, and
// what must not spread.
#include "runtime/prefilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "luts/filters.h"
#include "tests/runtime/warp/warp_fixture.h"

namespace warplut {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Size {
  int width;
  int height;
};

Prefilter Recursive(float side) { return {.kind = PrefilterKind::kRecursive, .side = side}; }

// The recursive filter of the side, cut off and closed.
Prefilter Fir(float side, int reach) {
  Prefilter fir = {.kind = PrefilterKind::kFir, .side = side, .reach = reach};
  const double z = PoleOfSide(static_cast<double>(side));
  double rest = 1;
  for (int j = 1; j <= reach; ++j) {
    fir.taps[j] = static_cast<float>((1 - z) / (1 + z) * std::pow(z, j));
    rest -= 2 * static_cast<double>(fir.taps[j]);
  }
  fir.taps[0] = static_cast<float>(rest);
  return fir;
}

const Prefilter kPrefilters[] = {Recursive(kLeastSide),
                                 Recursive(1.0f / 6),
                                 Recursive(static_cast<float>(SplineSide(kOMomsK))),
                                 Recursive(kLargestSide),
                                 Fir(0.05f, 1),
                                 Fir(1.0f / 6, 4),
                                 Fir(static_cast<float>(SplineSide(kOMomsK)), kLargestFirReach)};

void Filter(const Prefilter& prefilter, const TestImage& samples, TestImage& coefficients,
            int threads = 1) {
  ThreadPool executor(threads);
  PrefilterPass pass(prefilter, samples.width(), samples.height(), threads);
  pass.Apply(samples.view(), executor, coefficients.view());
}

TestImage Coefficients(const TestImage& samples) {
  return {samples.width(), samples.height(), CoefficientFormat(samples.format()), 16};
}

// Solves the tridiagonal system of luts/prefilter.h by elimination.
std::vector<double> Solve(double s, const std::vector<double>& x) {
  const std::size_t n = x.size();
  std::vector<std::vector<double>> rows(n, std::vector<double>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    rows[i][i] = 1 - 2 * s;
    rows[i][i > 0 ? i - 1 : i] += s;
    rows[i][i + 1 < n ? i + 1 : i] += s;
    rows[i][n] = x[i];
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i) continue;
      const double factor = rows[j][i] / rows[i][i];
      for (std::size_t k = 0; k <= n; ++k) rows[j][k] -= factor * rows[i][k];
    }
  }
  std::vector<double> c(n);
  for (std::size_t i = 0; i < n; ++i) c[i] = rows[i][n] / rows[i][i];
  return c;
}

TEST(PrefilterSolution, IsThatOfTheTridiagonalSystemInBothAxes) {
  for (const float side : {kLeastSide, 1.0f / 6, kLargestSide}) {
    for (const Size size : {Size{1, 1}, {1, 7}, {6, 1}, {3, 5}, {70, 41}}) {
      SCOPED_TRACE(std::to_string(side) + " " + std::to_string(size.width));
      TestImage samples(size.width, size.height, PixelFormat::kR32F);
      samples.Randomise(4);
      std::vector<std::vector<double>> c(size.height, std::vector<double>(size.width));
      const double s = side;
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) c[y][x] = samples.Get(x, y, 0);
        c[y] = Solve(s, c[y]);
      }
      for (int x = 0; x < size.width; ++x) {
        std::vector<double> column(size.height);
        for (int y = 0; y < size.height; ++y) column[y] = c[y][x];
        column = Solve(s, column);
        for (int y = 0; y < size.height; ++y) c[y][x] = column[y];
      }
      TestImage reference(size.width, size.height, PixelFormat::kR32F);
      PrefilterPass::Reference(Recursive(side), samples.view(), reference.view());
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          ASSERT_NEAR(reference.Get(x, y, 0), c[y][x], 1e-6 * (1 + std::abs(c[y][x])));
        }
      }
    }
  }
}

TEST(PrefilterSolution, ReachHoldsForEverySide) {
  for (float side = kLeastSide; side <= kLargestSide; side += 0.01f) {
    EXPECT_GE(PrefilterReach(Recursive(side)), 2);
    EXPECT_LT(PrefilterReach(Recursive(side)), kLargestPrefilterReach) << "not limited";
  }
  EXPECT_EQ(PrefilterReach(Fir(0.1f, 5)), 5);
}

TEST(PrefilterSolution, MirrorsPixels) {
  const int expected[] = {1, 2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 1};
  for (int i = -5; i <= 7; ++i) EXPECT_EQ(MirroredPixel(i, 3), expected[i + 5]) << i;
  for (int i = -3; i <= 3; ++i) EXPECT_EQ(MirroredPixel(i, 1), 0);
}

// The documented bound, for samples up to `largest`.
void ExpectNear(const TestImage& fast, const TestImage& reference, float largest) {
  const bool is_half = fast.format() == PixelFormat::kRgba16F;
  for (int y = 0; y < fast.height(); ++y) {
    for (int x = 0; x < fast.width(); ++x) {
      for (int c = 0; c < Channels(fast.format()); ++c) {
        const float expected = reference.Get(x, y, c);
        float bound = std::max(kPrefilterFloor, kPrefilterBound * largest);
        if (is_half) bound += 0x1p-10f * std::max(std::abs(expected), 0x1p-14f);
        ASSERT_TRUE(std::abs(fast.Get(x, y, c) - expected) <= bound)
            << "(" << x << ", " << y << ") channel " << c << ": " << fast.Get(x, y, c)
            << ", expected " << expected;
      }
    }
  }
}

class PrefilterOfFormat : public testing::TestWithParam<PixelFormat> {
 protected:
  float Unit() const { return ChannelScale(GetParam()); }
  bool IsFloat() const { return GetParam() != PixelFormat::kRgba8; }
};

TEST_P(PrefilterOfFormat, FastIsTheReferenceAtEverySize) {
  const float largest = IsFloat() ? 2.0f : 255.0f;
  for (const Size size : {Size{1, 1}, {1, 9}, {9, 1}, {3, 5}, {2, 70}, {131, 3}, {270, 75}}) {
    for (const Prefilter& prefilter : kPrefilters) {
      ASSERT_TRUE(IsValid(prefilter));
      SCOPED_TRACE(std::string(Name(prefilter.kind)) + " " + std::to_string(prefilter.side) + " " +
                   std::to_string(size.width) + " x " + std::to_string(size.height));
      TestImage samples(size.width, size.height, GetParam(), 32);
      samples.Randomise(3);
      TestImage reference = Coefficients(samples);
      PrefilterPass::Reference(prefilter, samples.view(), reference.view());
      TestImage fast = Coefficients(samples);
      Filter(prefilter, samples, fast);
      ExpectNear(fast, reference, largest);
    }
  }
}

// Also that the padding after each row is not touched.
TEST_P(PrefilterOfFormat, AnyExecutorGivesTheSameBits) {
  TestImage samples(270, 3 * kPrefilterRows + 5, GetParam());
  samples.Randomise(8);
  for (const Prefilter& prefilter : {Recursive(1.0f / 6), Fir(1.0f / 6, 4)}) {
    TestImage expected = Coefficients(samples);
    Filter(prefilter, samples, expected);
    for (const int threads : {2, 5}) {
      TestImage image = Coefficients(samples);
      Filter(prefilter, samples, image, threads);
      EXPECT_EQ(image, expected) << threads;
    }
    for (int y = 0; y < expected.height(); ++y) {
      const std::byte* end =
          expected.view().Row<std::byte>(y) + 270 * BytesPerPixel(expected.format());
      for (int i = 0; i < 16; ++i) ASSERT_EQ(end[i], std::byte{0xA5});
    }
  }
}

TEST_P(PrefilterOfFormat, ConstantsStay) {
  for (const float value : {0.0f, 0.3f, 1.0f, -0.7f, 1e-7f}) {
    if (!IsFloat() && value < 0) continue;
    TestImage samples(270, 70, GetParam());
    samples.Fill(value * Unit());
    for (const Prefilter& prefilter : kPrefilters) {
      TestImage fast = Coefficients(samples);
      Filter(prefilter, samples, fast);
      for (int y = 0; y < 70; ++y) {
        for (int x = 0; x < 270; ++x) ASSERT_EQ(fast.Get(x, y, 0), samples.Get(x, y, 0)) << value;
      }
    }
  }
}

// The coefficients are those of an image with zeros there.
TEST_P(PrefilterOfFormat, WhatIsNotFiniteCountsAsZero) {
  if (!IsFloat()) GTEST_SKIP() << "codes are finite";
  TestImage samples(270, 70, GetParam());
  samples.Randomise(5);
  TestImage zeros = samples;
  const std::pair<int, float> odd[] = {{0, kNan}, {3, kInfinity}, {77, -kInfinity}, {269, kNan}};
  for (const auto& [x, value] : odd) {
    for (const int y : {0, 33, 69}) {
      samples.Set(x, y, 0, value);
      zeros.Set(x, y, 0, 0);
    }
  }
  for (const Prefilter& prefilter : kPrefilters) {
    TestImage reference = Coefficients(samples);
    TestImage expected = Coefficients(samples);
    PrefilterPass::Reference(prefilter, samples.view(), reference.view());
    PrefilterPass::Reference(prefilter, zeros.view(), expected.view());
    EXPECT_EQ(reference, expected);
    Filter(prefilter, samples, reference);
    Filter(prefilter, zeros, expected);
    EXPECT_EQ(reference, expected);
  }
}

// Signs that alternate are what the prefilter amplifies most.
TEST_P(PrefilterOfFormat, TinyAndHugeSamplesGiveFiniteCoefficients) {
  if (!IsFloat()) GTEST_SKIP() << "codes are neither";
  const float huge = GetParam() == PixelFormat::kRgba16F ? 65504 : kLargestPrefiltered;
  const float tiny = GetParam() == PixelFormat::kRgba16F ? 0x1p-24f : 0x1p-149f;
  for (const float value : {huge, tiny}) {
    TestImage samples(40, 30, GetParam());
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) samples.Set(x, y, 0, (x + y) % 2 == 0 ? value : -value);
    }
    for (const Prefilter& prefilter : kPrefilters) {
      TestImage reference = Coefficients(samples);
      PrefilterPass::Reference(prefilter, samples.view(), reference.view());
      TestImage fast = Coefficients(samples);
      Filter(prefilter, samples, fast);
      for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
          const float c = fast.Get(x, y, 0);
          ASSERT_TRUE(std::isfinite(c));
          ASSERT_NEAR(c, reference.Get(x, y, 0),
                      std::max(kPrefilterFloor, value * 0x1p-10f + tiny));
        }
      }
    }
  }
}

// A sample beyond what is filtered does not spread.
TEST(PrefilterLimits, SamplesTooLargeCountAsZero) {
  for (const PixelFormat format : {PixelFormat::kRgba32F, PixelFormat::kR32F}) {
    TestImage samples(20, 20, format);
    samples.Fill(0);
    samples.Set(10, 10, 0, std::numeric_limits<float>::max());
    for (const Prefilter& prefilter : kPrefilters) {
      TestImage fast = Coefficients(samples);
      Filter(prefilter, samples, fast);
      for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 20; ++x) ASSERT_EQ(fast.Get(x, y, 0), 0);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, PrefilterOfFormat, testing::ValuesIn(kPixelFormats),
                         [](const auto& test) { return std::string(Name(test.param)); });

}  // namespace
}  // namespace warplut
