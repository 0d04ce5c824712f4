#include "runtime/camera_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/core/strict_math.h"
#include "runtime/float_bits.h"
#include "runtime/float_environment.h"
#include "runtime/gates.h"
#include "runtime/motion/camera_rounds.h"

namespace warplut {
namespace {

// Added to the unit diagonal of the scaled normal equations: coefficients that the frame does not
// tell apart stay small.
constexpr double kRidge = 1e-10;

struct Position {
  double u, v;
};

Position PositionOf(int x, int y, int width, int height) {
  return {(2 * x + 1 - width) / static_cast<double>(width),
          (2 * y + 1 - height) / static_cast<double>(width)};
}

CameraMotion::Vector Motion(const std::array<double, kCameraUnknowns>& c, double u, double v,
                            double g) {
  const double h = c[8] * u + c[9] * v + c[10] * g;
  return {(c[0] * u + c[1] * v + c[2] + c[3] * g + u * h) / (1 + h),
          (c[4] * u + c[5] * v + c[6] + c[7] * g + v * h) / (1 + h)};
}

// The upper triangle and the right hand side of normal equations.
struct NormalEquations {
  double a[kCameraUnknowns][kCameraUnknowns] = {};
  double b[kCameraUnknowns] = {};

  // Adds the equation row . c = value, where row is zero but at `count` indices.
  void Add(const int* index, const double* row, int count, double value, double weight) {
    for (int i = 0; i < count; ++i) {
      const double weighted = weight * row[i];
      for (int j = i; j < count; ++j) a[index[i]][index[j]] += weighted * row[j];
      b[index[i]] += weighted * value;
    }
  }

  // Cholesky decomposition of the equations scaled to a unit diagonal.
  std::array<double, kCameraUnknowns> Solution() const {
    double scale[kCameraUnknowns];
    double l[kCameraUnknowns][kCameraUnknowns];
    std::array<double, kCameraUnknowns> x{};
    for (int i = 0; i < kCameraUnknowns; ++i) scale[i] = a[i][i] > 0 ? 1 / std::sqrt(a[i][i]) : 0;
    for (int i = 0; i < kCameraUnknowns; ++i) {
      for (int j = 0; j <= i; ++j) {
        double sum = i == j ? 1 + kRidge : a[j][i] * scale[i] * scale[j];
        for (int k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
        l[i][j] = i == j ? std::sqrt(std::max(sum, kRidge)) : sum / l[j][j];
      }
      double sum = b[i] * scale[i];
      for (int k = 0; k < i; ++k) sum -= l[i][k] * x[k];
      x[i] = sum / l[i][i];
    }
    for (int i = kCameraUnknowns - 1; i >= 0; --i) {
      for (int k = i + 1; k < kCameraUnknowns; ++k) x[i] -= l[k][i] * x[k];
      x[i] /= l[i][i];
    }
    for (int i = 0; i < kCameraUnknowns; ++i) x[i] *= scale[i];
    return x;
  }
};

double Median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

float InverseDepth(float depth) {
  return depth >= 0 && depth < kFarthestDepth ? 1 / std::max(depth, kLeastDepth) : 0;
}

CameraMotion::Vector CameraMotion::At(int x, int y, float inverse_depth, int width,
                                      int height) const {
  const auto [u, v] = PositionOf(x, y, width, height);
  const Vector m = Motion(c, u, v, inverse_depth);
  return {m.x * width / 2, m.y * width / 2};
}

CameraFit::CameraFit(int width, int height) : step_(CameraSampleStep(width, height)) {
  samples_.reserve(kCameraSamples);
  sorted_.reserve(kCameraSamples);
}

std::size_t CameraFit::MemoryBytes() const {
  return samples_.capacity() * sizeof(Sample) + sorted_.capacity() * sizeof(double);
}

void CameraFit::Gather(const ImageView& depth, const MotionView& motion) {
  samples_.clear();
  sorted_.clear();
  const double units = 2.0 / motion.width;
  for (int y = (step_ - 1) / 2; y < motion.height; y += step_) {
    const float* z = depth.Row<float>(y);
    const float* m = motion.Row(y);
    for (int x = (step_ - 1) / 2; x < motion.width; x += step_) {
      if (!IsFinite(m[2 * x]) || !IsFinite(m[2 * x + 1])) continue;
      const auto [u, v] = PositionOf(x, y, motion.width, motion.height);
      const double g = InverseDepth(z[x]);
      samples_.push_back({u, v, g, m[2 * x] * units, m[2 * x + 1] * units, 0});
      if (g > 0) sorted_.push_back(g);
    }
  }
  const double middle = sorted_.empty() ? 1 : Median(sorted_);
  for (Sample& sample : samples_) {
    const double nearness = sample.g / (kNearMedians * middle);
    sample.weight = 1 / (1 + nearness * nearness);
  }
}

// The equations are linear in c once multiplied by 1 + h: m = c . (u, v, 1, g) + ((u, v) - m) h.
// They are weighted by the last 1 / (1 + h)^2, so that residuals are those of the motion.
void CameraFit::Solve(double cut_x, double cut_y, CameraMotion& camera) const {
  constexpr int kIndexX[] = {0, 1, 2, 3, 8, 9, 10};
  constexpr int kIndexY[] = {4, 5, 6, 7, 8, 9, 10};
  NormalEquations equations;
  for (const Sample& s : samples_) {
    const auto [mx, my] = Motion(camera.c, s.u, s.v, s.g);
    if (!(std::abs(mx - s.mx) <= cut_x && std::abs(my - s.my) <= cut_y)) continue;
    const double divisor = 1 + camera.c[8] * s.u + camera.c[9] * s.v + camera.c[10] * s.g;
    const double weight = s.weight / (divisor * divisor);
    const double px = s.u - s.mx;
    const double py = s.v - s.my;
    const double row_x[] = {s.u, s.v, 1, s.g, px * s.u, px * s.v, px * s.g};
    const double row_y[] = {s.u, s.v, 1, s.g, py * s.u, py * s.v, py * s.g};
    equations.Add(kIndexX, row_x, 7, s.mx, weight);
    equations.Add(kIndexY, row_y, 7, s.my, weight);
  }
  camera.c = equations.Solution();
}

void CameraFit::MeasureNoise(CameraMotion& camera) {
  // A residual that is not a number, as where 1 + h is 0, is a large one.
  const auto median = [&](auto residual) {
    sorted_.clear();
    for (const Sample& s : samples_) {
      const double r = std::abs(residual(s, Motion(camera.c, s.u, s.v, s.g)));
      sorted_.push_back(r <= kFarthestDepth ? r : kFarthestDepth);
    }
    return Median(sorted_);
  };
  camera.noise_x =
      median([](const Sample& s, const CameraMotion::Vector& m) { return s.mx - m.x; });
  camera.noise_y =
      median([](const Sample& s, const CameraMotion::Vector& m) { return s.my - m.y; });
}

CameraMotion CameraFit::Fit(const ImageView& depth, const MotionView& motion) {
  const FloatEnvironment environment;
  CameraMotion camera;
  Gather(depth, motion);
  if (samples_.size() < kLeastSamples) return camera;
  const double pixels = motion.width / 2.0;
  double cut_x = std::numeric_limits<double>::infinity();
  double cut_y = cut_x;
  for (int round = 0; round < kCameraRounds; ++round) {
    Solve(cut_x, cut_y, camera);
    MeasureNoise(camera);
    const double cut = round < kHalvingRounds ? 1 : kNoiseToLimit;
    cut_x = std::max(cut * camera.noise_x, kLeastCut / pixels);
    cut_y = std::max(cut * camera.noise_y, kLeastCut / pixels);
  }
  camera.noise_x *= pixels;
  camera.noise_y *= pixels;
  return camera;
}

}  // namespace warplut
