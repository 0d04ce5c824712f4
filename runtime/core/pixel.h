// One channel of a pixel, to float and back: the rounding that every kernel follows.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "luts/half.h"
#include "runtime/float_bits.h"
#include "runtime/image_view.h"

namespace warplut {

// Nearest code value, halves up, limited to [0, 255]; NaN gives 0.
inline std::uint8_t RoundToCode(float value) {
  return value > 0 && !IsNan(value)
             ? static_cast<std::uint8_t>(std::min(std::floor(value + 0.5f), 255.0f))
             : 0;
}

// What the codes or values of a format's channels are divided by to lie in [0, 1].
constexpr float ChannelScale(PixelFormat format) {
  return format == PixelFormat::kRgba8 ? 255.0f : 1.0f;
}

// Channel c of a pixel; 8-bit codes as 0..255.
inline float LoadChannel(PixelFormat format, const void* pixel, int c) {
  switch (format) {
    case PixelFormat::kRgba8:
      return static_cast<const std::uint8_t*>(pixel)[c];
    case PixelFormat::kRgba16F:
      return HalfToFloat(static_cast<const std::uint16_t*>(pixel)[c]);
    case PixelFormat::kRgba32F:
    case PixelFormat::kR32F:
      return static_cast<const float*>(pixel)[c];
  }
  return 0.0f;
}

inline void StoreChannel(PixelFormat format, float value, void* pixel, int c) {
  switch (format) {
    case PixelFormat::kRgba8:
      static_cast<std::uint8_t*>(pixel)[c] = RoundToCode(value);
      break;
    case PixelFormat::kRgba16F:
      static_cast<std::uint16_t*>(pixel)[c] = FloatToHalf(value);
      break;
    case PixelFormat::kRgba32F:
    case PixelFormat::kR32F:
      static_cast<float*>(pixel)[c] = value;
      break;
  }
}

}  // namespace warplut
