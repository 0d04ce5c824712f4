#include "tests/stability/cases/training/training_weights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "luts/fit/head.h"
#include "tests/stability/cases/training/training_problem.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

constexpr int kWarps = 6;  // of the longest horizon

std::vector<double> Scaled(double factor) {
  std::vector<double> parameters = RandomParameters(1);
  for (double& p : parameters) p *= factor;
  return parameters;
}

TinyResult TrainFrom(double factor, StabilityEffort effort) {
  TinyProblem problem;
  problem.images = {NoiseImage(kTinySide, kTinySide, 1)};
  problem.horizons = {2, kWarps};
  problem.iterations = effort == StabilityEffort::kFull ? 100 : 15;
  return RunTiny(problem, MakeObjective(problem), Scaled(factor));
}

// Whether the scaled start ends within 5 % of where the same training ends from the parameters as
// they are.
StabilityResult Optimum(double factor, StabilityEffort effort) {
  const double scaled = TrainFrom(factor, effort).end, plain = TrainFrom(1, effort).end;
  return {scaled <= 1.05 * plain, fmt::format("{:.4f}, {:.4f} unscaled", scaled, plain)};
}

double LargestDifference(const Weights<double>& a, const Weights<double>& b) {
  double largest = 0;
  for (int k = 0; k < kWeights; ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

double LargestRaw(const std::vector<double>& parameters) {
  double largest = 0;
  for (const double d : {0.0, 0.5, 1.0}) {
    for (const double raw : Mlp(parameters.data(), d, d))
      largest = std::max(largest, std::abs(raw));
  }
  return largest;
}

}  // namespace

// tanh of the hidden layers is +-1: their gradient vanishes, that of the last layer does not.
StabilityResult TrainFromSaturated(StabilityEffort effort) {
  const TinyResult result = TrainFrom(1e3, effort);
  return {result.KeepsContract() && result.SafeFor(kWarps), result.Text()};
}

// The start is all but Catmull-Rom, at a saddle: the last biases alone have a gradient.
StabilityResult TrainFromTiny(StabilityEffort effort) {
  const TinyResult result = TrainFrom(1e-6, effort);
  return {result.KeepsContract() && result.SafeFor(kWarps) && result.end < 0.9 * result.start,
          result.Text()};
}

StabilityResult OptimumFromSaturated(StabilityEffort effort) { return Optimum(1e3, effort); }
StabilityResult OptimumFromTiny(StabilityEffort effort) { return Optimum(1e-6, effort); }

// At d = 0 the identity; at d = 1 - eps, eps = 2^-53, the identity of the next texel but for
// eps (8 |F| + 2): the slope of Catmull-Rom is at most 1/2 there, that of the masks at most 4.
StabilityResult HeadAtExtremeOffsets(StabilityEffort) {
  constexpr double kEpsilon = 0x1p-53;
  bool passed = true;
  std::string observed;
  for (const double factor : {1e-6, 1.0, 1e3}) {
    const std::vector<double> parameters = Scaled(factor);
    const double raw = LargestRaw(parameters);
    Weights<double> here{}, next{};
    here[kIdentityWeight] = 1;
    next[TapWeight(1, 1)] = 1;
    const auto at = [&](double d) { return HeadWeights(parameters.data(), d, d); };
    const double zero = LargestDifference(at(0), here);
    const double one = LargestDifference(at(1 - kEpsilon), next);
    const Weights<double> half = at(0.5);
    double asymmetry = 0;
    for (int g = 0; g < kSymmetries; ++g) {
      for (int k = 0; k < kWeights; ++k) {
        asymmetry = std::max(asymmetry, std::abs(half[MapWeight(g, k)] - half[k]));
      }
    }
    // Sums of 16 products of raw values round to within 16 of their last bits.
    const double rounding = 32 * kEpsilon * (1 + raw);
    passed = passed && zero <= rounding && one <= rounding && asymmetry <= rounding;
    observed += fmt::format("{}F {:.1e}: at 0 {:.0e}, at 1 - eps {:.0e}, asymmetry at 1/2 {:.0e}",
                            observed.empty() ? "" : "; ", raw, zero, one, asymmetry);
  }
  return {passed, observed};
}

// Raw values b everywhere add 9 b to the sum at (1/2, 1/2): at b = -1/9 the sum of Catmull-Rom and
// residual is 0. The head subtracts what is too much instead of dividing by the sum.
StabilityResult HeadOfVanishingSum(StabilityEffort) {
  constexpr double kVanishing = -1.0 / 9;
  // d w / d b = mask - 9 B with masks of at most 1 and B = 1/4: the first moments of the residual
  // vanish.
  constexpr double kSlope = 9.0 / 4;
  const auto weights = [](double b) {
    std::vector<double> parameters(kMlpParameters, 0.0);
    constexpr int kBiases = TapCount(Footprint::k16);
    std::fill_n(parameters.end() - kBiases, kBiases, b);
    return HeadWeights(parameters.data(), 0.5, 0.5);
  };
  const Weights<double> at = weights(kVanishing);
  double slope = 0, sum_error = 0;
  for (int power = 1; power <= 9; ++power) {
    for (const double sign : {-1.0, 1.0}) {
      const double change = sign * std::pow(10.0, -power);
      const Weights<double> beside = weights(kVanishing + change);
      slope = std::max(slope, LargestDifference(at, beside) / std::abs(change));
      double sum = 0;
      for (const double w : beside) sum += w;
      sum_error = std::max(sum_error, std::abs(sum - 1));
    }
  }
  const double largest = std::abs(*std::max_element(
      at.begin(), at.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
  return {slope <= kSlope * (1 + 1e-6) && sum_error <= 1e-15,
          fmt::format("largest weight {:.4f}, slope {:.6f}, sums within {:.0e}", largest, slope,
                      sum_error)};
}

}  // namespace warplut
