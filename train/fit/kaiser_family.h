// The Kaiser-windowed sincs (luts/wide_kernel.h): rivals of resamplers with 24 and 36 taps, and where
// their training starts.
#pragma once

#include <functional>

#include "train/fit/resampler.h"

namespace warplut {

// The b of the six-tap filter that results are compared with.
inline constexpr double kComparedKaiser = 4.5;

// The windowed sinc of 36 taps, as it is.
Resampler KaiserResampler(double b);

// The head's base of a footprint of 24 or 36 taps: its wide kernel, whose first moments are closed.
Resampler WideBase(Footprint footprint, double b);

// The least b in [kFirstKaiser, kLastKaiser], to within 1e-3, whose base has a gain of at most `limit`
// at every node, as every larger one has.
inline constexpr double kFirstKaiser = 2;
inline constexpr double kLastKaiser = 12;
double LeastKaiser(Footprint footprint, double limit);

// The b in [least, kLastKaiser] of the least loss, by golden section to within kKaiserWidth.
inline constexpr double kKaiserWidth = 0.05;
double BestKaiser(const std::function<double(double b)>& loss, double least);

}  // namespace warplut
