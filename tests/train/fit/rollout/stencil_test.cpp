#include "train/fit/rollout/stencil.h"

#include <gtest/gtest.h>

#include "luts/filters.h"
#include "luts/wide_kernel.h"
#include "runtime/core/instruction_sets.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

Weights<float> RandomWeights(Footprint footprint, Random& random) {
  Weights<float> weights{};
  float sum = 0;
  for (const int k : TapsOf(footprint)) {
    sum += weights[k] = static_cast<float>(random.Uniform() - 0.3);
  }
  for (float& w : weights) w /= sum;
  return weights;
}

Weights<float> KnownWeights(Footprint footprint, double dx, double dy) {
  const Weights<double> w =
      footprint == Footprint::k16 ? KeysWeights(-0.6, dx, dy) : WideWeights(footprint, 4.5, dx, dy);
  Weights<float> weights{};
  std::copy(w.begin(), w.end(), weights.begin());
  return weights;
}

float Direct(const Stencil& s, const BorderedPlane& in, int x, int y) {
  std::array<float, kWeights> texels{};
  for (const int k : TapsOf(s.footprint)) {
    const int tx = std::clamp(x + s.cell_x + TapX(k), 0, in.width() - 1);
    const int ty = std::clamp(y + s.cell_y + TapY(k), 0, in.height() - 1);
    texels[k] = in.row(ty)[tx];
  }
  return std::clamp(ApplyWeights(s.footprint, s.weights, texels), 0.0f, 1.0f);
}

class StencilOf : public testing::TestWithParam<Footprint> {};
INSTANTIATE_TEST_SUITE_P(Taps, StencilOf, testing::ValuesIn(kFootprints),
                         [](const auto& test) { return std::to_string(TapCount(test.param)); });

TEST_P(StencilOf, EqualsTheDirectSumWithClampedBorders) {
  Random random(4);
  for (const auto& [width, height] : {std::pair{16, 16}, {31, 9}, {1, 1}, {48, 3}}) {
    const BorderedPlane in = ToPlane(NoiseImage(width, height, 2));
    BorderedPlane out(width, height);
    for (const int cell_x : {-1, 0}) {
      for (const int cell_y : {-1, 0}) {
        const Stencil stencil{cell_x, cell_y, RandomWeights(GetParam(), random), GetParam()};
        ApplyStencil(stencil, in, out);
        for (int y = 0; y < height; ++y) {
          for (int x = 0; x < width; ++x) {
            ASSERT_NEAR(out.row(y)[x], Direct(stencil, in, x, y), 2e-6);
          }
        }
        EXPECT_EQ(out.row(-3)[-3], out.row(0)[0]);
        EXPECT_EQ(out.row(height + 2)[width + 2], out.row(height - 1)[width - 1]);
      }
    }
  }
}

// <A u, v> = <u, A^T v> for the linear part, and the weights' gradient against differences.
TEST_P(StencilOf, AdjointIsTheTransposeAndTheWeightGradientIsRight) {
  const int width = 29;
  const int height = 18;
  Random random(11);
  const BorderedPlane in = ToPlane(NoiseImage(width, height, 5));
  for (const int cell : {-1, 0}) {
    Stencil stencil{cell, -1 - cell, KnownWeights(GetParam(), 0.3, 0.8), GetParam()};
    BorderedPlane out(width, height), gradient(width, height), in_gradient(width, height);
    ApplyStencil(stencil, in, out);
    gradient.Clear();
    double loss = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        gradient.row(y)[x] = static_cast<float>(random.Uniform() - 0.5);
        loss += gradient.row(y)[x] * out.row(y)[x];
      }
    }
    const BorderedPlane factors = gradient;
    Weights<double> weight_gradient{};
    AdjointStencil(stencil, in, out, gradient, in_gradient, weight_gradient);
    double transposed = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) transposed += in_gradient.row(y)[x] * in.row(y)[x];
    }
    EXPECT_NEAR(transposed, loss, 1e-3);  // nothing is clamped in this image
    double along = 0;
    for (int k = 0; k < kWeights; ++k) along += weight_gradient[k] * stencil.weights[k];
    EXPECT_NEAR(along, loss, 1e-3);
    for (const int k : TapsOf(GetParam())) {
      Stencil moved = stencil;
      moved.weights[k] += 1e-2f;
      ApplyStencil(moved, in, out);
      double above = 0;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) above += factors.row(y)[x] * out.row(y)[x];
      }
      EXPECT_NEAR((above - loss) / 1e-2, weight_gradient[k], 2e-2);
    }
    for (int i = 1; i <= BorderedPlane::kBorder; ++i) {
      EXPECT_EQ(in_gradient.row(3)[-i], 0);
      EXPECT_EQ(in_gradient.row(3)[width - 1 + i], 0);
      EXPECT_EQ(in_gradient.row(-i)[3], 0);
    }
  }
}

TEST(Stencil, ClampedPixelsPassNoGradient) {
  BorderedPlane in = ToPlane(NoiseImage(16, 16, 1));
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) in.row(y)[x] *= 10;
  }
  FillBorder(in);
  BorderedPlane out(16, 16), gradient(16, 16), in_gradient(16, 16);
  const Stencil stencil{0, 0, KeysWeights(-0.5f, 0.5f, 0.5f)};
  ApplyStencil(stencil, in, out);
  gradient.Clear();
  for (int y = 0; y < 16; ++y) std::fill_n(gradient.row(y), 16, 1.0f);
  Weights<double> weight_gradient{};
  AdjointStencil(stencil, in, out, gradient, in_gradient, weight_gradient);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      EXPECT_EQ(gradient.row(y)[x], out.row(y)[x] > 0 && out.row(y)[x] < 1 ? 1.0f : 0.0f);
    }
  }
}

}  // namespace
}  // namespace warplut
