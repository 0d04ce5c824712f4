#include "runtime/hud.h"

#include <algorithm>

#include "runtime/core/band.h"
#include "runtime/core/image_check.h"
#include "runtime/core/pixel.h"
#include "runtime/float_environment.h"

namespace warplut {
namespace {

// A channel of the HUD or of the image as DrawHud counts it.
float Limited(float value, float most) { return value > 0 ? std::min(value, most) : 0.0f; }

void DrawRow(const ImageView& hud, float most, int y, const MutableImageView& image) {
  const float hud_unit = 1.0f / ChannelScale(hud.format);
  const float scale = ChannelScale(image.format), unit = 1.0f / scale;
  for (int x = 0; x < image.width; ++x) {
    const void* pixel = hud.At(x, y);
    float layer[4];
    for (int c = 0; c < 4; ++c) {
      layer[c] = Limited(LoadChannel(hud.format, pixel, c) * hud_unit, c < 3 ? most : 1.0f);
    }
    if (std::max(std::max(layer[0], layer[1]), std::max(layer[2], layer[3])) <= 0) continue;
    void* to = image.At(x, y);
    for (int c = 0; c < 3; ++c) {
      const float behind = Limited(LoadChannel(image.format, to, c) * unit, most);
      const float value = std::min(layer[c] + (1 - layer[3]) * behind, most);
      StoreChannel(image.format, value * scale, to, c);
    }
  }
}

}  // namespace

void DrawHud(const ImageView& hud, ColorEncoding encoding, Executor& executor,
             const MutableImageView& image) {
  if (hud.data == nullptr) return;
  const float most = encoding == ColorEncoding::kLinearHdr ? kLargestHdr : 1.0f;
  executor.ForEach(TileCount(image.height, kBandRows), [&](int band) {
    const FloatEnvironment environment;
    const int end = std::min(image.height, (band + 1) * kBandRows);
    for (int y = band * kBandRows; y < end; ++y) DrawRow(hud, most, y, image);
  });
}

bool IsDrawable(const ImageView& hud, const MutableImageView& image, std::string* why) {
  return CheckColor("The image", image, image.width, image.height, why) &&
         CheckColor("The HUD", hud, image.width, image.height, why);
}

}  // namespace warplut
