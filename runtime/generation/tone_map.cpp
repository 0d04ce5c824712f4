#include "runtime/generation/tone_map.h"

#include <limits>

#include "runtime/color_encoding.h"
#include "runtime/generation/blend.h"
#include "runtime/pixel.h"

namespace warplut::generation {

void ToneMapRows(const ImageView& linear, int first, int last, const MutableImageView& to) {
  const float scale = 1.0f / ChannelScale(linear.format);
  for (int y = first; y < last; ++y) {
    float* out = to.Row<float>(y);
    for (int x = 0; x < linear.width; ++x, out += 4) {
      const void* pixel = linear.At(x, y);
      for (int i = 0; i < 3; ++i) {
        const float value = LoadChannel(linear.format, pixel, i) * scale;
        out[i] = value > 0.0f && value <= std::numeric_limits<float>::max() ? value : 0.0f;
      }
      ToneMap(out);
      out[3] = 1.0f;
    }
  }
}

void InverseToneMapRows(const ImageView& mapped, int first, int last, const MutableImageView& to) {
  for (int y = first; y < last; ++y) {
    for (int x = 0; x < mapped.width; ++x) {
      Rgb color = LoadRgb(mapped.format, mapped.At(x, y));
      InverseToneMap(color.c);
      StoreRgb(color, to.format, to.At(x, y));
    }
  }
}

}  // namespace warplut::generation
