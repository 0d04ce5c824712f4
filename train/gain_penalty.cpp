#include "train/gain_penalty.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace warplut {
namespace {

constexpr int kSteps = 16;  // frequencies per pi
constexpr int kFrequencies = (kSteps + 1) * 2 * kSteps;

using Column = Eigen::Matrix<double, kWeights, 1>;

}  // namespace

GainPenalty::GainPenalty(double bound)
    : bound_(bound), cosine_(kFrequencies, kWeights), sine_(kFrequencies, kWeights) {
  int row = 0;
  for (int v = 0; v <= kSteps; ++v) {
    for (int u = -kSteps + 1; u <= kSteps; ++u, ++row) {
      for (int k = 0; k < kWeights; ++k) {
        const double phase = std::numbers::pi / kSteps * (u * TapX(k) + v * TapY(k));
        cosine_(row, k) = std::cos(phase);
        sine_(row, k) = std::sin(phase);
      }
    }
  }
}

double GainPenalty::AddGradient(const CanonicalWeights<double>& weights, double factor,
                                CanonicalWeights<double>& gradient) const {
  double total = 0;
  Eigen::VectorXd real, imaginary, excess;
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const Eigen::Map<const Column> w(weights[c].data());
    real.noalias() = cosine_ * w;
    imaginary.noalias() = sine_ * w;
    excess = (real.array().square() + imaginary.array().square() - bound_ * bound_).max(0.0);
    const double part = excess.squaredNorm();
    if (part == 0) continue;
    total += part;
    real.array() *= excess.array();
    imaginary.array() *= excess.array();
    Eigen::Map<Column>(gradient[c].data()) +=
        4 * factor * (cosine_.transpose() * real + sine_.transpose() * imaginary);
  }
  return total;
}

}  // namespace warplut
