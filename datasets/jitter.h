// The jitter of rendered frames: where in its pixel a frame takes its samples.
#pragma once

#include <vector>

#include "datasets/frame.h"

namespace warplut {

// Element `index` >= 1 of the radical inverse in `base` >= 2, in (0, 1). Source: Halton 1960.
inline double Halton(int index, int base) {
  double value = 0, digit = 1;
  for (; index > 0; index /= base) {
    digit /= base;
    value += digit * (index % base);
  }
  return value;
}

// One jitter cycle for the upscale factor `scale` >= 1, in pixels of the render grid: Halton (2, 3)
// minus 1/2, floor(8 scale^2) offsets, the rule of FSR 2. Frame f uses offset f modulo the length.
inline std::vector<Vec2> JitterCycle(double scale) {
  const int count = static_cast<int>(8 * scale * scale);
  std::vector<Vec2> offsets;
  offsets.reserve(count);
  for (int i = 1; i <= count; ++i) offsets.push_back({Halton(i, 2) - 0.5, Halton(i, 3) - 0.5});
  return offsets;
}

}  // namespace warplut
