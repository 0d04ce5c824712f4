#include "train/ssim_reference.h"

#include <cmath>

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
  return SsimReferenceAs<double>(x.data, x.stride, y);
}

}  // namespace warplut
