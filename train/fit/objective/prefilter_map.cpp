#include "train/fit/objective/prefilter_map.h"

#include <algorithm>
#include <cmath>

namespace warplut {
namespace {

constexpr double kLeast = static_cast<double>(kLeastSide);
constexpr double kInside = 1e-3;  // of the range: how far from its ends a number can begin

double Logistic(double u) { return 1 / (1 + std::exp(-u)); }

}  // namespace

PrefilterMap PrefilterMap::Fixed(double side) {
  return {PrefilterKind::kRecursive, 0, false, side};
}
PrefilterMap PrefilterMap::Recursive(double largest_side) {
  return {PrefilterKind::kRecursive, 0, true, largest_side};
}
PrefilterMap PrefilterMap::Fir(int reach, double largest_side) {
  return {PrefilterKind::kFir, reach, true, largest_side};
}

RealPrefilter PrefilterMap::At(const double* numbers) const {
  RealPrefilter prefilter{.kind = kind_, .side = side_, .reach = reach_};
  if (free_) prefilter.side = kLeast + (side_ - kLeast) * Logistic(numbers[0]);
  if (reach_ == 0) return prefilter;
  prefilter.taps[0] = 1;
  for (int j = 1; j <= reach_; ++j) {
    prefilter.taps[j] = numbers[j];
    prefilter.taps[0] -= 2 * numbers[j];
  }
  return prefilter;
}

void PrefilterMap::Backward(const double* numbers, const RealPrefilter& gradient,
                            double* out) const {
  if (!free_) return;
  const double share = Logistic(numbers[0]);
  out[0] = gradient.side * (side_ - kLeast) * share * (1 - share);
  for (int j = 1; j <= reach_; ++j) out[j] = gradient.taps[j] - 2 * gradient.taps[0];
}

std::vector<double> PrefilterMap::NumbersOf(const RealPrefilter& prefilter) const {
  if (!free_) return {};
  const double share =
      std::clamp((prefilter.side - kLeast) / (side_ - kLeast), kInside, 1 - kInside);
  std::vector<double> numbers = {std::log(share / (1 - share))};
  for (int j = 1; j <= reach_; ++j) numbers.push_back(prefilter.taps[j]);
  return numbers;
}

Prefilter Rounded(const RealPrefilter& prefilter) {
  Prefilter rounded{
      .kind = prefilter.kind, .side = static_cast<float>(prefilter.side), .reach = prefilter.reach};
  for (int j = 0; j <= prefilter.reach; ++j) {
    rounded.taps[j] = static_cast<float>(prefilter.taps[j]);
  }
  if (prefilter.kind != PrefilterKind::kFir) rounded.taps = {};
  return rounded;
}

RealPrefilter ToReal(const Prefilter& prefilter) {
  RealPrefilter real{.kind = prefilter.kind,
                     .side = static_cast<double>(prefilter.side),
                     .reach = prefilter.reach};
  for (int j = 0; j <= kLargestFirReach; ++j) real.taps[j] = static_cast<double>(prefilter.taps[j]);
  return real;
}

}  // namespace warplut
