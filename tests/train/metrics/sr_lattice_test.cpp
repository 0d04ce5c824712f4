// Light that changes: the share of coherent residuals of super resolution against lattices of dots.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "datasets/jitter.h"
#include "runtime/image_buffer.h"
#include "runtime/super_resolution.h"
#include "train/metrics/jitter_error.h"

namespace warplut {
namespace {

constexpr int kWidth = 96, kHeight = 64, kScale = 2;

// A soft shadow that travels over a smooth wall, at a position of the output.
float LightAt(double x, double y, int frame) {
  const double distance = std::abs(x + 0.4 * y - 1.5 * frame);
  const double shade = std::clamp((distance - 4) / 20, 0.0, 1.0);
  return static_cast<float>(0.3 + 0.4 * shade * shade * (3 - 2 * shade));
}

// Mean lattice energy of the last cycle.
double LatticeOf(float coherent_share) {
  SuperResolutionOptions options;
  options.render_width = kWidth / kScale;
  options.render_height = kHeight / kScale;
  options.output_width = kWidth;
  options.output_height = kHeight;
  options.motion = MotionUpsampling::kStatic;
  options.coherent_share = coherent_share;
  options.history_format = PixelFormat::kRgba32F;
  SerialExecutor executor;
  SuperResolution sr(options, executor);
  ImageBuffer out(kWidth, kHeight, PixelFormat::kRgba32F);
  ImageBuffer color(options.render_width, options.render_height, PixelFormat::kRgba32F);
  const auto jitter = JitterCycle(kScale);
  ErrorEnergy energy;
  for (int frame = 0; frame < 60; ++frame) {
    const Vec2 offset = jitter[static_cast<std::size_t>(frame) % jitter.size()];
    for (int y = 0; y < options.render_height; ++y) {
      for (int x = 0; x < options.render_width; ++x) {
        const float light =
            LightAt(kScale * (x + 0.5 + offset.x), kScale * (y + 0.5 + offset.y), frame);
        std::fill_n(color.view().Row<float>(y) + 4 * x, 4, light);
      }
    }
    sr.Process({.color = color.view(),
                .depth = {},
                .motion = {},
                .jitter_x = static_cast<float>(offset.x),
                .jitter_y = static_cast<float>(offset.y)},
               out.view());
    if (frame < 28) continue;
    Image error(kWidth, kHeight, 1);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        error.at(x, y) = out.view().Row<float>(y)[4 * x + 1] - LightAt(x + 0.5, y + 0.5, frame);
      }
    }
    energy += LatticeEnergy(error, kScale, kScale, 5);
  }
  return energy.Mean();
}

TEST(SrLattice, TakesTheLatticeFromMovingShadows) {
  const double without = LatticeOf(0), with = LatticeOf(0.7f);
  EXPECT_GT(without, 1e-6);
  EXPECT_LT(with, without / 4);
}

}  // namespace
}  // namespace warplut
