// Synthetic images: band-limited noise, with detail at every scale.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "datasets/image.h"
#include "train/fit/random.h"
#include "train/fit/rollout/stencil.h"

namespace warplut {

// Sum of 40 random waves of up to 0.8 pi radians per pixel with amplitudes falling as 1 /
// frequency; in [0.05, 0.95].
inline Image NoiseImage(int width, int height, std::uint64_t seed) {
  Image image(width, height, 1);
  Random random(seed);
  for (float& value : image.data) value = 0.5f;
  for (int wave = 0; wave < 40; ++wave) {
    const double frequency = 0.05 * std::pow(50.0, random.Uniform());
    const double angle = 6.283 * random.Uniform();
    const double phase = 6.283 * random.Uniform();
    const double amplitude = 0.012 / std::sqrt(frequency);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const double t = frequency * (x * std::cos(angle) + y * std::sin(angle)) + phase;
        image.at(x, y) += static_cast<float>(amplitude * std::sin(t));
      }
    }
  }
  for (float& value : image.data) value = std::clamp(value, 0.05f, 0.95f);
  return image;
}

inline BorderedPlane ToPlane(const Image& image) {
  BorderedPlane plane(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) plane.row(y)[x] = image.at(x, y);
  }
  FillBorder(plane);
  return plane;
}

}  // namespace warplut
