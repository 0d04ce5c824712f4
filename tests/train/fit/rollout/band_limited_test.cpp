#include "train/fit/rollout/band_limited.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

TEST(BandLimited, PixelCentresGiveThePixels) {
  const BorderedPlane image = ToPlane(NoiseImage(37, 23, 4));
  const std::vector<double> xs = {0.5, 7.5, 36.5}, ys = {0.5, 22.5};
  std::vector<float> values(xs.size() * ys.size());
  SampleBandLimited(image, xs, ys, values);
  for (std::size_t j = 0; j < ys.size(); ++j) {
    for (std::size_t i = 0; i < xs.size(); ++i) {
      EXPECT_NEAR(values[j * xs.size() + i],
                  image.row(static_cast<int>(ys[j]))[static_cast<int>(xs[i])], 1e-7);
    }
  }
}

// A wave of 0.35 cycles per pixel, which a cubic kernel would damp by a tenth at half a pixel.
TEST(BandLimited, FineWavesKeepTheirAmplitudeBetweenPixels) {
  BorderedPlane image(64, 64);
  const auto wave = [](double x, double y) {
    return 0.5 + 0.2 * std::sin(2.2 * x + 0.3) * std::cos(1.9 * y);
  };
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) image.row(y)[x] = static_cast<float>(wave(x + 0.5, y + 0.5));
  }
  std::vector<double> at;
  for (double position = 14; position < 50; position += 0.37) at.push_back(position);
  std::vector<float> values(at.size() * at.size());
  SampleBandLimited(image, at, at, values);
  for (std::size_t j = 0; j < at.size(); ++j) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      ASSERT_NEAR(values[j * at.size() + i], wave(at[i], at[j]), 2e-3);
    }
  }
}

TEST(BandLimited, ConstantsStayAndValuesKeepTheirRange) {
  BorderedPlane image(20, 20);
  for (int y = 0; y < 20; ++y) std::fill_n(image.row(y), 20, 0.3f);
  const std::vector<double> at = {-40.2, -0.7, 0.1, 9.77, 19.9, 33.3};
  std::vector<float> values(at.size() * at.size());
  SampleBandLimited(image, at, at, values);
  for (const float value : values) EXPECT_NEAR(value, 0.3f, 1e-6);
  for (int y = 0; y < 20; ++y) std::fill_n(image.row(y) + 10, 10, 1.0f);
  for (int y = 0; y < 20; ++y) std::fill_n(image.row(y), 10, 0.0f);
  SampleBandLimited(image, at, at, values);
  for (const float value : values) {
    EXPECT_GE(value, 0);
    EXPECT_LE(value, 1);
  }
}

}  // namespace
}  // namespace warplut
