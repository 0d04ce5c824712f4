// The motion that a camera gives to still surfaces, and its fit to motion vectors.
//
// A pixel at (u, v), in units of half the width from the image centre, of inverse depth g, moved by
//   m_x = (c_0 u + c_1 v + c_2 + c_3 g + u h) / (1 + h),
//   m_y = (c_4 u + c_5 v + c_6 + c_7 g + v h) / (1 + h),
//   h = c_8 u + c_9 v + c_10 g,
// in the same units: the point (u, v) - m of the frame before is a homography of (u, v) plus g
// times the epipole. It holds for any rotation, translation and change of focal length of a pinhole
// camera. Source: Hartley, Zisserman, "Multiple View Geometry", section 13.1 (plane and parallax).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "luts/visibility.h"
#include "runtime/image_view.h"

namespace WARPLUT_PUBLIC warplut {

// The inverse of a depth: 0 where depth is NaN, negative or infinite, and at most 1 / kLeastDepth.
inline constexpr float kLeastDepth = 1e-6f;
float InverseDepth(float depth);

struct CameraMotion {
  std::array<double, 11> c{};
  // The median of |motion - camera's| in each axis over the samples of the fit, pixels.
  double noise_x = 0;
  double noise_y = 0;

  // The motion, in pixels, of pixel (x, y) of an image of that size.
  struct Vector {
    double x, y;
  };
  Vector At(int x, int y, float inverse_depth, int width, int height) const;
};

// Vectors farther than this many times the noise from the camera's are not explained by it. Uniform
// quantisation noise has its maximum at twice its median; as much again is for steps that differ
// within a frame, as those of half floats do.
inline constexpr double kNoiseToLimit = 4;

// Least squares over at most kCameraSamples pixels on a regular grid; again, round after round,
// over those nearer to the camera's motion than the median; at last over all that lie within
// kNoiseToLimit times the noise. It finds the camera where moving objects that agree with each
// other cover up to about a third of the frame. A pixel much nearer than the median counts less, so
// that a few that move with the camera do not decide. Runs on the calling thread, in double, in a
// fixed order.
inline constexpr int kCameraSamples = 4096;
inline constexpr int kCameraRounds = 10;

class CameraFit {
 public:
  // Allocates for images of this size.
  CameraFit(int width, int height);

  // Pixels whose motion is not finite have no part. Fewer than kLeastSamples others: the zero
  // camera with zero noise.
  CameraMotion Fit(const ImageView& depth, const MotionView& motion);

  std::size_t MemoryBytes() const;

  static constexpr int kLeastSamples = 44;  // four for each coefficient

 private:
  struct Sample {
    double u, v, g;
    double mx, my;  // in units of half the width
    double weight;
  };
  void Gather(const ImageView& depth, const MotionView& motion);
  void Solve(double cut_x, double cut_y, CameraMotion& camera) const;
  void MeasureNoise(CameraMotion& camera);

  int step_;  // distance of samples, pixels
  std::vector<Sample> samples_;
  std::vector<double> sorted_;
};

}  // namespace warplut
