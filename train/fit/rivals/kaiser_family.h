// The Kaiser-windowed sincs (luts/wide_kernel.h): rivals of resamplers with 24 and 36 taps, and
// where their training starts.
#pragma once

#include <functional>
#include <optional>

#include "train/fit/resampler.h"

namespace warplut {

// The b of the six-tap filter that results are compared with.
inline constexpr double kComparedKaiser = 4.5;

// The head's base of a footprint of 24 or 36 taps: its wide kernel.
Resampler WideBase(Footprint footprint, double b);

// The windowed sinc of 36 taps.
Resampler KaiserResampler(double b);

// The b in [kFirstKaiser, kLastKaiser] of the least loss among those whose base has a gain of at
// most `limit` at every node, by golden section to within kKaiserWidth; none if the search meets no
// such b.
inline constexpr double kFirstKaiser = 2;
inline constexpr double kLastKaiser = 12;
inline constexpr double kKaiserWidth = 0.05;
std::optional<double> BestKaiser(const std::function<double(double b)>& loss, Footprint footprint,
                                 double limit);

}  // namespace warplut
