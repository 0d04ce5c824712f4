// Where a motion vector points: a whole number of texels and an offset. Defined once, for every
// kernel.
#pragma once

#include <algorithm>
#include <cmath>

#include "luts/contract.h"
#include "runtime/float_bits.h"

namespace warplut {

// Whole displacements are limited to this, so that integer arithmetic cannot overflow; images are
// smaller.
inline constexpr float kFarthestTexel = 16777216.0f;

// One axis of -m: `whole` texels plus `offset` in [0, 1).
struct MotionSplit {
  int whole;
  float offset;
};

// Splits the component m of a motion vector. It depends on m alone, not on the pixel: the sampled
// position p - m has texel p + whole and the same offset everywhere, however large the coordinates.
// The offset is exact unless -1 < -m < 0, where it is off by 2^-25 at most. A NaN or infinite
// component counts as zero.
inline MotionSplit SplitMotion(float m) {
  if (!IsFinite(m)) m = 0.0f;
  float whole = std::floor(-m);
  float offset = -m - whole;
  if (offset >= 1.0f) {
    offset = 0.0f;
    whole += 1.0f;
  }
  return {static_cast<int>(std::clamp(whole, -kFarthestTexel, kFarthestTexel)), offset};
}

// The texel p + whole on an axis of `size` texels, limited to [-3, size + 1]: beyond, all taps of a
// window read the border texel, so nothing changes any more.
inline constexpr int kFirstSampledTexel = -(kFirstWindowTap + kWindowTaps - 1);
constexpr int LastSampledTexel(int size) { return size - 1 - kFirstWindowTap; }
constexpr int SampledTexel(int p, int whole, int size) {
  return std::clamp(p + whole, kFirstSampledTexel, LastSampledTexel(size));
}

// Moves a position beyond the centres of the outermost of `size` texels to them.
constexpr void MoveInside(int size, int& texel, float& offset) {
  if (texel < 0 || texel >= size - 1) offset = 0;
  texel = std::clamp(texel, 0, size - 1);
}

}  // namespace warplut
