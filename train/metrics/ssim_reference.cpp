#include "train/metrics/ssim_reference.h"

#include <cmath>

namespace warplut {

std::array<double, kSsimWindow> SsimTaps() {
  constexpr int kCentre = kSsimWindow / 2;
  std::array<double, kSsimWindow> taps{};
  double sum = 0;
  for (int i = 0; i < kSsimWindow; ++i) {
    const double t = (i - kCentre) / kSsimSigma;
    taps[i] = std::exp(-0.5 * t * t);
    sum += taps[i];
  }
  for (double& tap : taps) tap /= sum;
  return taps;
}

double SsimReference(const PlaneView& x, const PlaneView& y) {
  return SsimReferenceAs<double>(x.data, x.stride, y);
}

}  // namespace warplut
