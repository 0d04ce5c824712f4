#include "train/fit/rivals/kaiser_family.h"

#include <limits>

#include "luts/fit/head.h"
#include "luts/wide_kernel.h"
#include "train/fit/rivals/golden_section.h"
#include "train/fit/rivals/spline_family.h"

namespace warplut {

Resampler WideBase(Footprint footprint, double b) {
  Resampler base({}, {}, footprint);
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    base.weights[c] = WideWeights(footprint, b, NodeOffset(i), NodeOffset(j));
  }
  return base;
}

Resampler KaiserResampler(double b) { return WideBase(Footprint::k36, b); }

std::optional<double> BestKaiser(const std::function<double(double b)>& loss, Footprint footprint,
                                 double limit) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const Maximum best = GoldenSection(
      [&](double b) {
        return LargestNodeGain(WideBase(footprint, b)) <= limit ? -loss(b) : -kNone;
      },
      kFirstKaiser, kLastKaiser, kKaiserWidth);
  return best.value > -kNone ? std::optional(best.at) : std::nullopt;
}

}  // namespace warplut
