// The transfer curve of sRGB displays.
#pragma once

#include <cmath>

namespace warplut {

// Light in [0, 1] to display values in [0, 1]. Source: IEC 61966-2-1.
inline float SrgbCurve(float light) {
  return light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f;
}

}  // namespace warplut
