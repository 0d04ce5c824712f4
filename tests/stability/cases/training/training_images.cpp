#include "tests/stability/cases/training/training_images.h"

#include <algorithm>
#include <cmath>

#include "train/fit/random.h"

namespace warplut {

Image ConstantImage(int side, float value) {
  Image image(side, side, 1);
  std::fill(image.data.begin(), image.data.end(), value);
  return image;
}

Image ImpulseImage(int side) {
  Image image(side, side, 1);
  image.at(side / 2, side / 2) = 1;
  return image;
}

Image CheckerboardImage(int side) {
  Image image(side, side, 1);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) image.at(x, y) = static_cast<float>((x + y) % 2);
  }
  return image;
}

Image WhiteNoiseImage(int side, std::uint64_t seed) {
  Image image(side, side, 1);
  Random random(seed);
  for (float& value : image.data) value = static_cast<float>(random.Uniform());
  return image;
}

Image HdrImage(int side, std::uint64_t seed) {
  Image image(side, side, 1);
  Random random(seed);
  for (float& value : image.data) {
    value = static_cast<float>(std::pow(10.0, 8 * random.Uniform() - 4));
  }
  return image;
}

}  // namespace warplut
