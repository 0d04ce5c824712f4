// The 8 symmetries of the square, acting on offsets and on the taps of the window.
//
// A resampling filter must not care how the image is turned: if g maps offset d to g(d), the
// weights must satisfy w(g(d))[g(k)] = w(d)[k]. Flip x maps dx to 1 - dx and tap x to 1 - x;
// transpose swaps the axes. Every footprint is its own image.
#pragma once

#include "luts/contract.h"

namespace warplut {

inline constexpr int kSymmetries = 8;

// Bit 0: flip x, bit 1: flip y, bit 2: transpose, applied in the order flips, then transpose.
template <class T>
constexpr std::array<T, 2> MapOffset(int g, T dx, T dy, T one = T(1)) {
  const T x = (g & 1) ? one - dx : dx;
  const T y = (g & 2) ? one - dy : dy;
  return (g & 4) ? std::array<T, 2>{y, x} : std::array<T, 2>{x, y};
}

// The index that weight k of offset d has at offset MapOffset(g, d).
constexpr int MapWeight(int g, int k) {
  const auto [x, y] = MapOffset<int>(g, TapX(k), TapY(k));
  return TapWeight(x, y);
}

}  // namespace warplut
