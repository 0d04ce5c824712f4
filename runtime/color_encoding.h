// What the values of colour images mean.
#pragma once

#include <algorithm>
#include <cstdint>

namespace warplut {

// kDisplay: what the display gets, in [0, 1]. kLinearHdr: scene-linear, >= 0, unbounded; blends and histories then work on
// ToneMap of it.
enum class ColorEncoding : std::uint8_t { kDisplay, kLinearHdr };

constexpr const char* Name(ColorEncoding encoding) {
  return encoding == ColorEncoding::kDisplay ? "display" : "linear HDR";
}

// The factor that tone-maps (r, g, b) >= 0 reversibly, by its largest channel m: 1 / (1 + m). Source: Karis, "Tone mapping",
// 2013.
template <class T>
T ToneMapFactor(T largest) {
  return T(1) / (T(1) + largest);
}

// The factor back, for the largest tone-mapped channel: 1 / (1 - m). Resampling can reach m >= 1: it is limited so that the
// result stays below kLargestHdr.
inline constexpr float kLargestHdr = 65504.0f;
template <class T>
T InverseToneMapFactor(T largest) {
  constexpr T kLimit = T(kLargestHdr) / (T(1) + T(kLargestHdr));
  const T limited = largest < kLimit ? largest : kLimit;
  return T(1) / (T(1) - limited);
}

// The colour (r, g, b) >= 0 tone-mapped, and back.
inline void ToneMap(float* rgb) {
  const float factor = ToneMapFactor(std::max({rgb[0], rgb[1], rgb[2]}));
  for (int c = 0; c < 3; ++c) rgb[c] *= factor;
}
inline void InverseToneMap(float* rgb) {
  const float factor = InverseToneMapFactor(std::max({rgb[0], rgb[1], rgb[2]}));
  for (int c = 0; c < 3; ++c) rgb[c] *= factor;
}

}  // namespace warplut
