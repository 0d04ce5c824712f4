// Small images on disk.
#pragma once

#include <cmath>
#include <filesystem>
#include <string>

#include "datasets/images/image_io.h"

namespace warplut {

// Waves in two directions and a step: something that a filter can get wrong.
inline Image WavyImage(int width, int height, int channels = 3) {
  Image image(width, height, channels);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < channels; ++c) {
        const double wave =
            0.2 * std::sin(0.9 * x + c) * std::cos(0.6 * y) + (x > width / 2 ? 0.2 : 0.0);
        image.at(x, y, c) = static_cast<float>(0.4 + wave);
      }
    }
  }
  return image;
}

inline std::string WriteWavyImage(const std::filesystem::path& path, int width, int height) {
  WriteImage(path, WavyImage(width, height), PixelType::kUint8);
  return path.string();
}

}  // namespace warplut
