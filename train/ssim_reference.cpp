#include <cmath>

#include "train/ssim.h"

namespace warplut {

std::array<double, kSsimWindow> SsimTaps() {
  std::array<double, kSsimWindow> taps{};
  double sum = 0;
  for (int i = 0; i < kSsimWindow; ++i) {
    const double t = (i - kSsimWindow / 2) / kSsimSigma;
    taps[i] = std::exp(-0.5 * t * t);
    sum += taps[i];
  }
  for (double& tap : taps) tap /= sum;
  return taps;
}

double SsimReference(const PlaneView& x, const PlaneView& y) {
  const auto taps = SsimTaps();
  const int map_width = x.width - kSsimWindow + 1;
  const int map_height = x.height - kSsimWindow + 1;
  double total = 0;
  for (int row = 0; row < map_height; ++row) {
    for (int column = 0; column < map_width; ++column) {
      double mx = 0, my = 0, xx = 0, yy = 0, xy = 0;
      for (int j = 0; j < kSsimWindow; ++j) {
        for (int i = 0; i < kSsimWindow; ++i) {
          const double w = taps[i] * taps[j];
          const double a = x.data[(row + j) * x.stride + column + i];
          const double b = y.data[(row + j) * y.stride + column + i];
          mx += w * a;
          my += w * b;
          xx += w * a * a;
          yy += w * b * b;
          xy += w * a * b;
        }
      }
      const double a1 = 2 * mx * my + kSsimC1;
      const double a2 = 2 * (xy - mx * my) + kSsimC2;
      const double b1 = mx * mx + my * my + kSsimC1;
      const double b2 = (xx - mx * mx) + (yy - my * my) + kSsimC2;
      total += a1 * a2 / (b1 * b2);
    }
  }
  return total / (static_cast<double>(map_width) * map_height);
}

}  // namespace warplut
