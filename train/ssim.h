// SSIM of single-channel float images: 11 x 11 Gaussian window of sigma 1.5, valid region, C1 = 0.01^2, C2 = 0.03^2
// for values in [0, 1]. Source: Wang et al. 2004; window as in Mob-FGSR's evaluation (SPEC: luma, means).
//
// A pixel of the SSIM map needs the whole window inside the image: the map of a W x H image is (W - 10) x (H - 10).
#pragma once

#include <cstddef>
#include <vector>

namespace warplut {

inline constexpr int kSsimWindow = 11;
inline constexpr double kSsimSigma = 1.5;
inline constexpr float kSsimC1 = 0.01f * 0.01f;
inline constexpr float kSsimC2 = 0.03f * 0.03f;

// A plane of floats: row y starts at data + y * stride, stride in floats, stride >= width.
struct PlaneView {
  const float* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;
};

// Mean SSIM of x against y over the valid region; both at least kSsimWindow in each axis and of the same size
// (not checked). Double precision, direct sums: the slow, obvious version.
double SsimReference(const PlaneView& x, const PlaneView& y);

// Fast SSIM against a fixed reference image, with the gradient. One object serves one thread.
class Ssim {
 public:
  // Takes what it needs of y; y need not outlive the call.
  explicit Ssim(const PlaneView& y);

  // Mean SSIM of x, of y's size. Accuracy against SsimReference: 2e-6 for values in [0, 1].
  double Mean(const PlaneView& x);

  // The same, and adds scale * d(mean SSIM)/dx to `gradient` (stride in floats).
  double MeanAndGradient(const PlaneView& x, float scale, float* gradient,
                         std::ptrdiff_t gradient_stride);

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<float> mean_y_, var_y_;  // over the valid region
  std::vector<float> y_;
  std::vector<float> scratch_;
};

}  // namespace warplut
