#include "train/metrics/ssim.h"

#include <gtest/gtest.h>

#include <numeric>

#include "runtime/core/instruction_sets.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

PlaneView View(const Image& image) {
  return {image.data.data(), image.width, image.height, image.width};
}

Image Disturbed(const Image& image, float amount, std::uint64_t seed) {
  Image out = image;
  Random random(seed);
  for (float& value : out.data) value += amount * static_cast<float>(random.Uniform() - 0.5);
  return out;
}

TEST(Ssim, TapsAreANormalisedGaussian) {
  const auto taps = SsimTaps();
  EXPECT_NEAR(std::accumulate(taps.begin(), taps.end(), 0.0), 1, 1e-15);
  EXPECT_NEAR(taps[5] / taps[4], std::exp(0.5 / (1.5 * 1.5)), 1e-12);
  EXPECT_EQ(taps[0], taps[10]);
}

TEST(Ssim, OneForEqualImages) {
  const Image image = NoiseImage(40, 30, 1);
  EXPECT_NEAR(Ssim(View(image)).Mean(View(image)), 1, kSsimAccuracy);
  EXPECT_NEAR(SsimReference(View(image), View(image)), 1, 1e-12);
}

TEST(Ssim, OfTwoConstantsIsTheLuminanceTerm) {
  Image a(20, 20, 1), b(20, 20, 1);
  std::fill(a.data.begin(), a.data.end(), 0.25f);
  std::fill(b.data.begin(), b.data.end(), 0.75f);
  const double expected = (2 * 0.25 * 0.75 + kSsimC1) / (0.25 * 0.25 + 0.75 * 0.75 + kSsimC1);
  EXPECT_NEAR(SsimReference(View(a), View(b)), expected, 1e-9);
  EXPECT_NEAR(Ssim(View(b)).Mean(View(a)), expected, kSsimAccuracy);
}

TEST(Ssim, FastEqualsReferenceForEverySize) {
  for (const int width : {11, 12, 26, 27, 43, 70}) {
    for (const int height : {11, 13, 29}) {
      const Image y = NoiseImage(width, height, width + height);
      for (const float amount : {0.02f, 0.5f}) {
        const Image x = Disturbed(y, amount, 3);
        EXPECT_NEAR(Ssim(View(y)).Mean(View(x)), SsimReference(View(x), View(y)), kSsimAccuracy)
            << width << " x " << height;
      }
    }
  }
}

TEST(Ssim, GradientEqualsDifferencesOfTheReference) {
  const Image y = NoiseImage(37, 24, 8);
  Image x = Disturbed(y, 0.2f, 9);
  const int stride = 50;
  std::vector<float> gradient(stride * 24, 1.0f);
  const double value = Ssim(View(y)).MeanAndGradient(View(x), 1000.0f, gradient.data(), stride);
  EXPECT_NEAR(value, SsimReference(View(x), View(y)), kSsimAccuracy);
  for (const auto& [px, py] : {std::pair{0, 0}, {36, 23}, {18, 12}, {5, 20}, {30, 3}, {33, 11}}) {
    const float saved = x.at(px, py);
    const float h = 1e-3f;
    x.at(px, py) = saved + h;
    const double above = SsimReference(View(x), View(y));
    x.at(px, py) = saved - h;
    const double below = SsimReference(View(x), View(y));
    x.at(px, py) = saved;
    const double expected = 1000 * (above - below) / (2 * h);
    EXPECT_NEAR(gradient[py * stride + px] - 1, expected, 2e-3 * std::abs(expected) + 2e-4)
        << px << " " << py;
  }
}

// Flat places, where variances are nothing but rounding, next to the exact image.
TEST(Ssim, FlatImagesLoseOnlyWhatTheyDifferBy) {
  for (const float value : {0.0f, 1e-4f, 0.3f, 0.5f, 1.0f}) {
    Image y(30, 20, 1);
    std::fill(y.data.begin(), y.data.end(), value);
    const Image x = Disturbed(y, 1e-6f, 4);
    const double loss = 1 - Ssim(View(y)).Mean(View(x));
    EXPECT_GE(loss, 0) << value;
    EXPECT_NEAR(loss, 1 - SsimReference(View(x), View(y)), 1e-10) << value;
    EXPECT_EQ(Ssim(View(y)).Mean(View(y)), 1) << value;
  }
}

TEST(Ssim, EqualImagesHaveNoGradient) {
  const Image image = NoiseImage(37, 24, 8);
  std::vector<float> gradient(image.data.size(), 0.0f);
  Ssim(View(image)).MeanAndGradient(View(image), 1.0f, gradient.data(), image.width);
  for (const float g : gradient) EXPECT_EQ(g, 0);
}

TEST(Ssim, GradientLeavesWhatIsBesideTheImageAlone) {
  const Image y = NoiseImage(13, 12, 1);
  const int stride = 32;
  std::vector<float> gradient(stride * 12, 7.0f);
  Ssim(View(y)).MeanAndGradient(View(Disturbed(y, 0.3f, 2)), 1.0f, gradient.data(), stride);
  for (int row = 0; row < 12; ++row) {
    for (int i = 13; i < stride; ++i) EXPECT_EQ(gradient[row * stride + i], 7.0f);
  }
}

}  // namespace
}  // namespace warplut
