// The meaning of colour values, and the code in which linear HDR is warped and blended.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "luts/visibility.h"
#include "runtime/float_bits.h"

namespace WARPLUT_PUBLIC warplut {

// kDisplay: values of the display, in [0, 1]. kLinearHdr: scene-linear light, >= 0, unbounded;
// histories, warps and blends then work on the HdrCode of each channel.
enum class ColorEncoding : std::uint8_t { kDisplay, kLinearHdr };

constexpr const char* Name(ColorEncoding encoding) {
  return encoding == ColorEncoding::kDisplay ? "display" : "linear HDR";
}

// The largest linear channel, that of a half. Larger values and infinity count as this, negative
// ones and NaN as 0.
inline constexpr float kLargestHdr = 65504.0f;
inline float LimitHdr(float x) { return x > 0.0f && !IsNan(x) ? std::min(x, kLargestHdr) : 0.0f; }

// The code of x in [0, kLargestHdr], in [0, 1]: log2(1 + kHdrGain x) / kHdrOctaves, with an
// approximate logarithm. Within each octave, from 2^k to 2^(k+1), it is k + f (4 - f) / 3 with
// 1 + f the mantissa. It has a continuous slope and an exact inverse, and is within 0.01 of the
// logarithm.
//
// The code is linear below about 1 / 64 and logarithmic above, so that an overshoot of resampling
// is a multiple at most. A code that is off by e means a value that is off by at most 16.5 e
// (x + 1 / kHdrGain): in half floats 0.2 % for x up to about 30 and 0.4 % above.
inline constexpr int kHdrOctaves = 22;
inline constexpr float kHdrGain = (static_cast<float>(1 << kHdrOctaves) - 1) / kLargestHdr;
// The number of mantissa bits of a float, and the bits of 1.
inline constexpr int kMantissaBits = 23;
inline constexpr std::int32_t kOneBits = 127 << kMantissaBits;

inline float HdrCode(float x) {
  const auto bits = std::bit_cast<std::int32_t>(kHdrGain * x + 1) - kOneBits;
  const auto octave = static_cast<float>(bits >> kMantissaBits);
  const float f = std::bit_cast<float>((bits & ((1 << kMantissaBits) - 1)) | kOneBits) - 1;
  return (octave + f * (4 - f) * (1.0f / 3)) * (1.0f / kHdrOctaves);
}

// The value of a code in [0, 1], in [0, kLargestHdr].
inline float HdrValue(float code) {
  const float logarithm = code * kHdrOctaves;
  const auto octave = static_cast<std::int32_t>(logarithm);
  const float f = 2 - std::sqrt(4 - 3 * (logarithm - static_cast<float>(octave)));
  const auto bits = std::bit_cast<std::int32_t>(1 + f) + (octave << kMantissaBits);
  return std::min((std::bit_cast<float>(bits) - 1) * (1 / kHdrGain), kLargestHdr);
}

// Resampling may exceed the brightest resampled value only up to the code of this. Brighter codes
// would be fireflies, as an overshoot of a code stands for a multiple of the value.
inline constexpr float kUnlimitedHdr = 1.0f;

// The difference of codes, about, that a difference of 1 of displayed values makes. Thresholds of
// differences are those of displayed values times this.
constexpr float CodeContrast(ColorEncoding encoding) {
  return encoding == ColorEncoding::kDisplay ? 1.0f : 0.28f;
}

}  // namespace warplut
