// SSIM of single-channel float images: 11 x 11 Gaussian window of sigma 1.5, valid region,
// C1 = 0.01^2, C2 = 0.03^2 for values in [0, 1]. Source: Wang, Bovik, Sheikh, Simoncelli 2004.
//
// A pixel of the SSIM map needs the whole window inside the image: the map of a W x H image is
// (W - 10) x (H - 10).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace warplut {

inline constexpr int kSsimWindow = 11;
inline constexpr double kSsimSigma = 1.5;
inline constexpr double kSsimC1 = 0.01 * 0.01;
inline constexpr double kSsimC2 = 0.03 * 0.03;

// The largest difference between Ssim and SsimReference for values in [0, 1]: float sums against
// double ones.
inline constexpr double kSsimAccuracy = 2e-6;

// The window in one axis; sums to 1.
std::array<double, kSsimWindow> SsimTaps();

// A plane of floats: row y starts at data + y * stride, stride in floats, stride >= width.
struct PlaneView {
  const float* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;
};

// Mean SSIM of x against y over the valid region; both of one size, at least kSsimWindow in each
// axis (not checked). Double precision, direct sums: the slow, obvious version.
double SsimReference(const PlaneView& x, const PlaneView& y);

struct SsimRows;

// Fast SSIM against a fixed reference image, with the gradient. Immutable: it serves any number of
// threads.
class Ssim {
 public:
  // Copies what it needs of y.
  explicit Ssim(const PlaneView& y);

  // Mean SSIM of x, of y's size (not checked). Accuracy: kSsimAccuracy.
  double Mean(const PlaneView& x) const;

  // The same, and adds scale * d(mean SSIM)/dx to `gradient` (row stride in floats, y's size).
  double MeanAndGradient(const PlaneView& x, float scale, float* gradient,
                         std::ptrdiff_t gradient_stride) const;

 private:
  SsimRows Rows(float* scratch) const;
  double MapSize() const;

  int width_ = 0;
  int height_ = 0;
  std::ptrdiff_t stride_ = 0;  // of every plane and row below, in floats
  std::array<float, kSsimWindow> taps_{};
  std::vector<float> y_;       // height_ rows
  std::vector<float> mean_y_;  // window means of y, per pixel of the map
  std::vector<float> var_y_;   // window variances of y
};

}  // namespace warplut
