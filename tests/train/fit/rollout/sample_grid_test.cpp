#include "train/fit/rollout/sample_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "datasets/jitter.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

struct GridCase {
  SampleGridOptions options;
  Vec2 jitter;
};

std::vector<GridCase> Cases() {
  std::vector<GridCase> cases;
  for (const double scale : {1.0, 1.3, 1.5, 1.7, 2.0, 3.0, 4.0}) {
    cases.push_back({{33, 21, scale, 0.7, 0.8}, JitterCycle(scale)[4]});
    cases.push_back({{16, 40, scale, 6, 3.5}, {-0.5, 0.49}});
  }
  return cases;
}

// The formulas of the header, one pixel at a time.
double ReferenceInterpolate(const GridCase& c, const SampleGrid& grid, const std::vector<float>& s,
                            int x, int y) {
  const auto axis = [&](int pixel, double jitter, int count) {
    return std::clamp((pixel + 0.5) / c.options.scale - 0.5 - jitter, 0.0, count - 1.0);
  };
  const double u = axis(x, c.jitter.x, grid.columns());
  const double v = axis(y, c.jitter.y, grid.rows());
  double sum = 0;
  for (int j = 0; j < grid.rows(); ++j) {
    for (int i = 0; i < grid.columns(); ++i) {
      sum += std::max(0.0, 1 - std::abs(u - i)) * std::max(0.0, 1 - std::abs(v - j)) *
             s[j * grid.columns() + i];
    }
  }
  return sum;
}

// R. Keys 1981, equation 15 with a = -1/2.
double CatmullRom(double t) {
  t = std::abs(t);
  if (t >= 2) return 0;
  return t <= 1 ? (1.5 * t - 2.5) * t * t + 1 : ((-0.5 * t + 2.5) * t - 4) * t + 2;
}

double ReferenceRead(const SampleGrid& grid, const BorderedPlane& image, int i, int j) {
  const double u = std::clamp(grid.PositionX(i) - 0.5, 0.0, image.width() - 1.0);
  const double v = std::clamp(grid.PositionY(j) - 0.5, 0.0, image.height() - 1.0);
  const int first_x = static_cast<int>(std::floor(u)), first_y = static_cast<int>(std::floor(v));
  double sum = 0;
  for (int y = -1; y <= 2; ++y) {
    for (int x = -1; x <= 2; ++x) {
      const int column = std::clamp(first_x + x, 0, image.width() - 1);
      const int row = std::clamp(first_y + y, 0, image.height() - 1);
      sum += CatmullRom(u - first_x - x) * CatmullRom(v - first_y - y) * image.row(row)[column];
    }
  }
  return sum;
}

double ReferenceShare(const GridCase& c, const SampleGrid& grid, int x, int y) {
  double nearest = 1e9;
  for (int j = 0; j < grid.rows(); ++j) {
    for (int i = 0; i < grid.columns(); ++i) {
      nearest = std::min(nearest,
                         std::hypot(grid.PositionX(i) - (x + 0.5), grid.PositionY(j) - (y + 0.5)) /
                             c.options.scale);
    }
  }
  return std::min(1.0, c.options.blend_a * std::max(0.0, 1 - c.options.blend_b * nearest));
}

std::vector<float> RandomSamples(const SampleGrid& grid, std::uint64_t seed) {
  Random random(seed);
  std::vector<float> samples(static_cast<std::size_t>(grid.columns()) * grid.rows());
  for (float& value : samples) value = static_cast<float>(random.Uniform());
  return samples;
}

TEST(SampleGrid, EveryMapEqualsItsFormula) {
  for (const GridCase& c : Cases()) {
    const SampleGrid grid(c.options, c.jitter);
    const int width = c.options.width, height = c.options.height;
    const BorderedPlane image = ToPlane(NoiseImage(width, height, 3));
    const std::vector<float> samples = RandomSamples(grid, 8);
    BorderedPlane interpolated(width, height), refreshed(width, height);
    std::vector<float> read(samples.size()), residual(samples.size());
    grid.Interpolate(samples, interpolated);
    grid.Read(image, read);
    grid.Refresh(samples, image, refreshed);
    for (std::size_t i = 0; i < read.size(); ++i) residual[i] = samples[i] - read[i];
    for (int j = 0; j < grid.rows(); ++j) {
      for (int i = 0; i < grid.columns(); ++i) {
        ASSERT_NEAR(read[j * grid.columns() + i], ReferenceRead(grid, image, i, j), 1e-5);
      }
    }
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        ASSERT_NEAR(interpolated.row(y)[x], ReferenceInterpolate(c, grid, samples, x, y), 1e-5);
        ASSERT_NEAR(grid.Share(x, y), ReferenceShare(c, grid, x, y), 1e-5);
        const double expected =
            image.row(y)[x] + grid.Share(x, y) * ReferenceInterpolate(c, grid, residual, x, y);
        ASSERT_NEAR(refreshed.row(y)[x], expected, 1e-5);
      }
    }
  }
}

TEST(SampleGrid, SamplesCoverTheImage) {
  for (const GridCase& c : Cases()) {
    const SampleGrid grid(c.options, c.jitter);
    EXPECT_GE(grid.columns() * c.options.scale, c.options.width);
    EXPECT_LT((grid.columns() - 1) * c.options.scale, c.options.width);
    EXPECT_GE(grid.rows() * c.options.scale, c.options.height);
  }
}

TEST(SampleGrid, WhatTheHistoryPredictsChangesNothing) {
  for (const GridCase& c : Cases()) {
    const SampleGrid grid(c.options, c.jitter);
    const BorderedPlane image = ToPlane(NoiseImage(c.options.width, c.options.height, 3));
    std::vector<float> samples(static_cast<std::size_t>(grid.columns()) * grid.rows());
    grid.Read(image, samples);
    BorderedPlane out(c.options.width, c.options.height);
    grid.Refresh(samples, image, out);
    for (int y = 0; y < c.options.height; ++y) {
      for (int x = 0; x < c.options.width; ++x) ASSERT_EQ(out.row(y)[x], image.row(y)[x]);
    }
  }
}

// <A u, v> = <u, A' v> with A u = Refresh(0, u).
TEST(SampleGrid, AdjointIsTheTranspose) {
  for (const GridCase& c : Cases()) {
    const SampleGrid grid(c.options, c.jitter);
    const int width = c.options.width, height = c.options.height;
    const BorderedPlane u = ToPlane(NoiseImage(width, height, 3));
    const BorderedPlane v = ToPlane(NoiseImage(width, height, 9));
    BorderedPlane forward(width, height);
    const std::vector<float> zero(static_cast<std::size_t>(grid.columns()) * grid.rows(), 0.0f);
    grid.Refresh(zero, u, forward);
    BorderedPlane backward = v;
    grid.AdjointRefresh(backward);
    double left = 0, right = 0, size = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        left += forward.row(y)[x] * v.row(y)[x];
        right += u.row(y)[x] * backward.row(y)[x];
        size += std::abs(u.row(y)[x] * backward.row(y)[x]);
      }
    }
    EXPECT_NEAR(left, right, 1e-5 * size);
  }
}

}  // namespace
}  // namespace warplut
