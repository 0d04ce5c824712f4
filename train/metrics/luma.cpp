#include "train/metrics/luma.h"

#include <fmt/format.h>

#include "datasets/error.h"

namespace warplut {

Image Luma(const Image& image) {
  if (image.channels == 1) return image;
  if (image.channels != 3 && image.channels != 4) {
    throw Error(
        fmt::format("luma of an image with {} channels; expected 1, 3 or 4", image.channels));
  }
  Image luma(image.width, image.height, 1);
  const std::size_t pixels = image.pixels();
  const std::size_t step = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* p = image.data.data() + i * step;
    luma.data[i] =
        static_cast<float>(kLumaWeights[0] * double{p[0]} + kLumaWeights[1] * double{p[1]} +
                           kLumaWeights[2] * double{p[2]});
  }
  return luma;
}

}  // namespace warplut
