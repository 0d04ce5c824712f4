#include "tools/judge/frame_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "train/inspection/ranking.h"

namespace warplut {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLeastIndependent = 3;

std::vector<double> Differences(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (std::isinf(a[i]) && a[i] == b[i]) {
      differences.push_back(0);
    } else if (std::isfinite(a[i]) && std::isfinite(b[i])) {
      differences.push_back(a[i] - b[i]);
    }
  }
  return differences;
}

// The correlation of neighbours among deviations from their mean, with the sum of their squares.
double Correlation(const std::vector<double>& deviations, double squares) {
  double products = 0;
  for (std::size_t i = 1; i < deviations.size(); ++i) {
    products += deviations[i - 1] * deviations[i];
  }
  const double r = products / squares;
  const double corrected = r + (1 + 3 * r) / static_cast<double>(deviations.size());
  return std::clamp(corrected, 0.0, 1.0);
}

}  // namespace

bool FrameDifference::HasError() const { return std::isfinite(standard_error); }

double FrameDifference::Uncertainty() const {
  if (!HasError()) return kNan;
  return standard_error * StudentQuantile(static_cast<int>(independent) - 1);
}

FrameDifference DifferenceOver(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> deviations = Differences(a, b);
  FrameDifference difference;
  const auto n = static_cast<double>(deviations.size());
  difference.frames = static_cast<int>(deviations.size());
  difference.independent = std::max(n, kLeastIndependent);
  difference.mean = kNan;
  difference.standard_error = kNan;
  if (deviations.empty()) return difference;
  double sum = 0, squares = 0;
  for (const double d : deviations) sum += d;
  difference.mean = sum / n;
  for (double& d : deviations) {
    d -= difference.mean;
    squares += d * d;
  }
  if (difference.frames < kLeastDifferingFrames) return difference;
  difference.standard_error = 0;
  if (squares == 0) return difference;
  const double r = Correlation(deviations, squares);
  difference.independent = std::max(n * (1 - r) / (1 + r), kLeastIndependent);
  difference.standard_error = std::sqrt(squares / n / (difference.independent - 1));
  return difference;
}

FrameDifference MeanDifference(const std::vector<FrameDifference>& sequences) {
  FrameDifference mean;
  double variance = 0, independent = 0, over_degrees = 0;
  for (const FrameDifference& one : sequences) {
    const double square = one.standard_error * one.standard_error;
    mean.mean += one.mean;
    mean.frames += one.frames;
    variance += square;
    independent += one.independent;
    over_degrees += square * square / (one.independent - 1);
  }
  const auto count = static_cast<double>(sequences.size());
  mean.mean /= count;
  mean.standard_error = std::sqrt(variance) / count;
  mean.independent = variance > 0 ? 1 + variance * variance / over_degrees : independent;
  mean.independent = std::max(mean.independent, kLeastIndependent);
  return mean;
}

FrameDifference Reversed(const FrameDifference& difference) {
  FrameDifference reversed = difference;
  reversed.mean = 0 - difference.mean;
  return reversed;
}

Payoff PayoffOf(const FrameDifference& gain, double least) {
  const double uncertainty = gain.Uncertainty();
  if (gain.mean + uncertainty <= least) return Payoff::kDoesNotPay;
  if (gain.mean - uncertainty > 0) return Payoff::kPays;
  return Payoff::kCannotTell;
}

}  // namespace warplut
