// SSIM by direct sums: the slow, obvious version, also for types that carry derivatives.
#pragma once

#include <cstddef>

#include "train/metrics/ssim.h"

namespace warplut {

// SsimReference with x of element type X, in the arithmetic of T (double, a dual number, a complex
// number of the complex-step method). Rows of x are x_stride elements apart.
template <class T, class X>
T SsimReferenceAs(const X* x, std::ptrdiff_t x_stride, const PlaneView& y) {
  const auto taps = SsimTaps();
  const int map_width = y.width - kSsimWindow + 1;
  const int map_height = y.height - kSsimWindow + 1;
  T total(0);
  for (int row = 0; row < map_height; ++row) {
    for (int column = 0; column < map_width; ++column) {
      T mx(0), xx(0), xy(0);
      double my = 0, yy = 0;
      for (int j = 0; j < kSsimWindow; ++j) {
        for (int i = 0; i < kSsimWindow; ++i) {
          const double w = taps[i] * taps[j];
          const T a(x[(row + j) * x_stride + column + i]);
          const double b = y.data[(row + j) * y.stride + column + i];
          mx += w * a;
          my += w * b;
          xx += w * a * a;
          yy += w * b * b;
          xy += w * a * b;
        }
      }
      const T a1 = 2.0 * mx * my + kSsimC1;
      const T a2 = 2.0 * (xy - mx * my) + kSsimC2;
      const T b1 = mx * mx + my * my + kSsimC1;
      const T b2 = (xx - mx * mx) + (yy - my * my) + kSsimC2;
      total += a1 * a2 / (b1 * b2);
    }
  }
  return total / (static_cast<double>(map_width) * map_height);
}

}  // namespace warplut
