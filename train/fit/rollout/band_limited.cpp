#include "train/fit/rollout/band_limited.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace warplut {
namespace {

constexpr int kSincTaps = 2 * kSincLobes;

double Sinc(double t) {
  if (std::abs(t) < 1e-9) return 1;
  const double angle = std::numbers::pi * t;
  return std::sin(angle) / angle;
}

// The pixels around a position, indices limited to the image, and their weights.
struct SincTaps {
  std::array<int, kSincTaps> pixel;
  std::array<double, kSincTaps> weight;
};

SincTaps MakeSincTaps(double position, int size) {
  const double centre = position - 0.5;
  const int first = static_cast<int>(std::floor(centre)) - kSincLobes + 1;
  SincTaps taps;
  double sum = 0;
  for (int k = 0; k < kSincTaps; ++k) {
    const double t = centre - (first + k);
    taps.weight[k] = std::abs(t) < kSincLobes ? Sinc(t) * Sinc(t / kSincLobes) : 0;
    taps.pixel[k] = std::clamp(first + k, 0, size - 1);
    sum += taps.weight[k];
  }
  for (double& weight : taps.weight) weight /= sum;
  return taps;
}

}  // namespace

void SampleBandLimited(const BorderedPlane& image, std::span<const double> xs,
                       std::span<const double> ys, std::span<float> values) {
  std::vector<SincTaps> columns;
  for (const double x : xs) columns.push_back(MakeSincTaps(x, image.width()));
  std::vector<double> line(image.width());
  for (std::size_t j = 0; j < ys.size(); ++j) {
    const SincTaps rows = MakeSincTaps(ys[j], image.height());
    std::fill(line.begin(), line.end(), 0.0);
    for (int k = 0; k < kSincTaps; ++k) {
      const float* from = image.row(rows.pixel[k]);
      for (int x = 0; x < image.width(); ++x) line[x] += rows.weight[k] * from[x];
    }
    for (std::size_t i = 0; i < xs.size(); ++i) {
      double sum = 0;
      for (int k = 0; k < kSincTaps; ++k) sum += columns[i].weight[k] * line[columns[i].pixel[k]];
      values[j * xs.size() + i] = static_cast<float>(std::clamp(sum, 0.0, 1.0));
    }
  }
}

}  // namespace warplut
