#include "train/fit/kaiser_family.h"

#include "luts/fit/head.h"
#include "train/fit/golden_section.h"
#include "train/fit/spline_family.h"

namespace warplut {
namespace {

constexpr int kHalvings = 14;

}  // namespace

Resampler KaiserResampler(double b) {
  Resampler kaiser({}, {}, Footprint::k36);
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    kaiser.weights[c] = WideWeights(Footprint::k36, b, NodeOffset(i), NodeOffset(j));
  }
  return kaiser;
}

Resampler WideBase(Footprint footprint, double b) {
  Resampler base({}, {}, footprint);
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    const double dx = NodeOffset(i), dy = NodeOffset(j);
    base.weights[c] =
        HeadAt<double>(footprint, WideWeights(footprint, b, dx, dy), dx, dy).Forward({});
  }
  return base;
}

double LeastKaiser(Footprint footprint, double limit) {
  const auto keeps = [&](double b) { return LargestNodeGain(WideBase(footprint, b)) <= limit; };
  double low = kFirstKaiser, high = kLastKaiser;
  if (keeps(low)) return low;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (keeps(middle) ? high : low) = middle;
  }
  return high;
}

double BestKaiser(const std::function<double(double b)>& loss, double least) {
  return GoldenSection([&](double b) { return -loss(b); }, least, kLastKaiser, kKaiserWidth).at;
}

}  // namespace warplut
