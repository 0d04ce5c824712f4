#include "train/fit/objective/gain_penalty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace warplut {
namespace {

constexpr int kSteps = 16;  // frequencies per pi
constexpr int kFrequencies = (kSteps + 1) * 2 * kSteps;

// Calls visit(row, u, v) for the frequency (u, v) pi / kSteps of each row.
template <class Visit>
void VisitFrequencies(const Visit& visit) {
  int row = 0;
  for (int v = 0; v <= kSteps; ++v) {
    for (int u = -kSteps + 1; u <= kSteps; ++u, ++row) visit(row, u, v);
  }
}

double Frequency(int step) { return std::numbers::pi / kSteps * step; }

// R^2 at every frequency.
Eigen::ArrayXd SquaredResponses(const RealPrefilter& prefilter) {
  Eigen::ArrayXd squared(kFrequencies);
  VisitFrequencies([&](int row, int u, int v) {
    const double response =
        PrefilterResponse(prefilter, Frequency(u)) * PrefilterResponse(prefilter, Frequency(v));
    squared[row] = response * response;
  });
  return squared;
}

// Adds what dP/d(R^2) of each frequency means for the side, or the taps.
void AddResponseGradient(const RealPrefilter& prefilter, const Eigen::ArrayXd& per_squared,
                         RealPrefilter& gradient) {
  std::array<double, kSteps + 1> per_response{};  // of the frequencies |u|, along either axis
  VisitFrequencies([&](int row, int u, int v) {
    const double ru = PrefilterResponse(prefilter, Frequency(u));
    const double rv = PrefilterResponse(prefilter, Frequency(v));
    per_response[std::abs(u)] += 2 * per_squared[row] * ru * rv * rv;
    per_response[v] += 2 * per_squared[row] * ru * ru * rv;
  });
  for (int u = 0; u <= kSteps; ++u) {
    const double f = Frequency(u);
    if (prefilter.kind == PrefilterKind::kRecursive) {
      const double response = PrefilterResponse(prefilter, f);
      gradient.side += per_response[u] * 2 * (1 - std::cos(f)) * response * response;
    } else {
      gradient.taps[0] += per_response[u];
      for (int j = 1; j <= prefilter.reach; ++j) {
        gradient.taps[j] += per_response[u] * 2 * std::cos(j * f);
      }
    }
  }
}

}  // namespace

GainPenalty::GainPenalty(double bound, Footprint footprint)
    : bound_(bound),
      footprint_(footprint),
      cosine_(kFrequencies, TapCount(footprint)),
      sine_(kFrequencies, TapCount(footprint)) {
  const FootprintTaps& taps = TapsOf(footprint);
  VisitFrequencies([&](int row, int u, int v) {
    for (int i = 0; i < taps.count; ++i) {
      const double phase = std::numbers::pi / kSteps * (u * TapX(taps[i]) + v * TapY(taps[i]));
      cosine_(row, i) = std::cos(phase);
      sine_(row, i) = std::sin(phase);
    }
  });
}

double GainPenalty::AddGradient(const Resampler& resampler, double factor,
                                Resampler& gradient) const {
  const RealPrefilter& prefilter = resampler.prefilter;
  const bool with_prefilter = HasPrefilter(prefilter);
  const Eigen::ArrayXd squared = with_prefilter ? SquaredResponses(prefilter) : Eigen::ArrayXd();
  double total = 0;
  const FootprintTaps& taps = TapsOf(footprint_);
  Eigen::VectorXd w(taps.count), of_w, real, imaginary, excess;
  Eigen::ArrayXd per_squared = Eigen::ArrayXd::Zero(squared.size());  // dP/d(R^2)
  for (int c = 0; c < kCanonicalNodes; ++c) {
    for (int i = 0; i < taps.count; ++i) w[i] = resampler.weights[c][taps[i]];
    real.noalias() = cosine_ * w;
    imaginary.noalias() = sine_ * w;
    excess = real.array().square() + imaginary.array().square();
    if (with_prefilter) excess.array() *= squared;
    excess = (excess.array() - bound_ * bound_).max(0.0);
    const double part = excess.squaredNorm();
    if (part == 0) continue;
    total += part;
    if (with_prefilter) {
      per_squared += 2 * excess.array() * (real.array().square() + imaginary.array().square());
      excess.array() *= squared;
    }
    real.array() *= excess.array();
    imaginary.array() *= excess.array();
    of_w = 4 * factor * (cosine_.transpose() * real + sine_.transpose() * imaginary);
    for (int i = 0; i < taps.count; ++i) gradient.weights[c][taps[i]] += of_w[i];
  }
  if (with_prefilter && total > 0) {
    AddResponseGradient(prefilter, factor * per_squared, gradient.prefilter);
  }
  return total;
}

}  // namespace warplut
