#include "train/calibration/luma_plane.h"

#include "runtime/core/pixel.h"
#include "train/metrics/displayed_color.h"
#include "train/metrics/luma.h"

namespace warplut {
namespace {

template <PixelFormat kFormat>
void LumaRow(const ImageView& image, ColorEncoding encoding, int y, float* out) {
  constexpr float kScale = 1.0f / ChannelScale(kFormat);
  const auto* pixel = static_cast<const std::byte*>(image.At(0, y));
  for (int x = 0; x < image.width; ++x, pixel += BytesPerPixel(kFormat)) {
    float rgb[3];
    for (int c = 0; c < 3; ++c) rgb[c] = LoadChannel(kFormat, pixel, c) * kScale;
    ToDisplay(encoding, rgb);
    float sum = 0;
    for (int c = 0; c < 3; ++c) sum += static_cast<float>(kLumaWeights[c]) * rgb[c];
    out[x] = sum;
  }
}

}  // namespace

LumaPlane LumaOf(const ImageView& image, ColorEncoding encoding, Executor& executor) {
  LumaPlane luma{image.width, image.height,
                 std::vector<float>(static_cast<std::size_t>(image.width) * image.height)};
  executor.ForEach(image.height, [&](int y) {
    float* out = luma.values.data() + static_cast<std::size_t>(y) * image.width;
    switch (image.format) {
      case PixelFormat::kRgba8:
        return LumaRow<PixelFormat::kRgba8>(image, encoding, y, out);
      case PixelFormat::kRgba16F:
        return LumaRow<PixelFormat::kRgba16F>(image, encoding, y, out);
      default:
        return LumaRow<PixelFormat::kRgba32F>(image, encoding, y, out);
    }
  });
  return luma;
}

}  // namespace warplut
