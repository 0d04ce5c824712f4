#include "train/fit/rivals/spline_family.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "luts/certificate/gain.h"
#include "luts/filters.h"
#include "train/fit/objective/prefilter_map.h"
#include "train/fit/rivals/golden_section.h"

namespace warplut {
namespace {

constexpr int kFrequencies = 128;
constexpr int kHalvings = 18;

double Frequency(int i) { return std::numbers::pi * i / kFrequencies; }

// LargestNodeGain of a spline: a product of two axes, it is largest where both offsets are the
// same.
double SplineGain(const RealPrefilter& prefilter) {
  double largest = 0;
  for (int i = 0; i <= kHalfNode; ++i) {
    const Weights<double> node =
        SplineWeights(SplineK(prefilter.side), NodeOffset(i), NodeOffset(i));
    largest = std::max(largest, MaxGain(node, Rounded(prefilter)).gain);
  }
  return largest;
}

bool IsNearIdentity(const RealPrefilter& prefilter) {
  for (int i = 0; i <= kFrequencies; ++i) {
    const double f = Frequency(i);
    const double product = PrefilterResponse(prefilter, f) * WholeOffsetResponse(prefilter, f);
    if (!(std::abs(product - 1) <= kFirIdentityTolerance / 2)) return false;
  }
  return IsValid(Rounded(prefilter));
}

}  // namespace

RealPrefilter RecursivePrefilter(double side) {
  return {.kind = PrefilterKind::kRecursive, .side = side};
}

// With t_0 = 1 - 2 sum of t_j the product is A + sum of t_j 2 (cos j f - 1) A: linear in t_j.
RealPrefilter FirPrefilter(double side, int reach) {
  RealPrefilter fir{.kind = PrefilterKind::kFir, .side = side, .reach = reach};
  Eigen::MatrixXd change(kFrequencies + 1, reach);
  Eigen::VectorXd missing(kFrequencies + 1);
  for (int i = 0; i <= kFrequencies; ++i) {
    const double f = Frequency(i);
    const double whole = WholeOffsetResponse(fir, f);
    missing[i] = 1 - whole;
    for (int j = 1; j <= reach; ++j) change(i, j - 1) = 2 * (std::cos(j * f) - 1) * whole;
  }
  const Eigen::VectorXd taps = change.colPivHouseholderQr().solve(missing);
  fir.taps[0] = 1 - 2 * taps.sum();
  for (int j = 1; j <= reach; ++j) fir.taps[j] = taps[j - 1];
  return fir;
}

RealPrefilter SplinePrefilter(double side, int reach) {
  return reach > 0 ? FirPrefilter(side, reach) : RecursivePrefilter(side);
}

Resampler SplineResampler(const RealPrefilter& prefilter) {
  Resampler spline({}, prefilter);
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    spline.weights[c] = SplineWeights(SplineK(prefilter.side), NodeOffset(i), NodeOffset(j));
  }
  return spline;
}

double LargestNodeGain(const Resampler& resampler) {
  const Prefilter prefilter = Rounded(resampler.prefilter);
  double largest = 0;
  for (const Weights<double>& node : resampler.weights) {
    largest = std::max(largest, MaxGain(node, prefilter).gain);
  }
  return largest;
}

double LargestSplineSide(double limit, int reach) {
  const auto keeps = [&](double side) {
    const RealPrefilter prefilter = SplinePrefilter(side, reach);
    return IsNearIdentity(prefilter) && SplineGain(prefilter) <= limit;
  };
  double low = static_cast<double>(kLeastSide), high = static_cast<double>(kLargestSide);
  if (keeps(high)) return high;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (keeps(middle) ? low : high) = middle;
  }
  return low;
}

double BestSplineSide(const std::function<double(double side)>& loss, double largest_side) {
  const double first = std::min(kFirstSide, largest_side / 2);
  const Maximum best =
      GoldenSection([&](double side) { return -loss(side); }, first, largest_side, kSideWidth);
  return best.at;
}

}  // namespace warplut
