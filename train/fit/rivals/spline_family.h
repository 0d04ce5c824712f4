// The cubic splines beta3 + k beta3'' (luts/filters.h), the rivals and the base of filters with a
// prefilter: as resamplers, within a bound on gain, and the best of them.
#pragma once

#include <functional>

#include "train/fit/resampler.h"

namespace warplut {

// A spline that stands between the B-spline and the o-MOMS: a gain of 1.0075.
inline constexpr double kMiddleSplineK = 1.0 / 84;

// The exact prefilter of a side in (0, 1/4).
RealPrefilter RecursivePrefilter(double side);

// The 2 reach + 1 taps, of sum 1, whose product with the whole offset of `side` is nearest to 1 in
// the mean square over all frequencies.
RealPrefilter FirPrefilter(double side, int reach);

// The exact prefilter, or that FIR where `reach` is above 0.
RealPrefilter SplinePrefilter(double side, int reach);

// The spline of the prefilter's side, read through that prefilter.
Resampler SplineResampler(const RealPrefilter& prefilter);

// The largest gain (luts/certificate/gain.h) of the canonical nodes.
double LargestNodeGain(const Resampler& resampler);

// The largest side up to kLargestSide whose spline, with SplinePrefilter(side, reach), has a gain
// of at most `limit` > 1 and a valid prefilter that is the identity to within half of
// kFirIdentityTolerance; to within 1e-6.
double LargestSplineSide(double limit, int reach);

// The side in [kFirstSide, largest_side] of the least loss, by golden section to within kSideWidth.
inline constexpr double kFirstSide = 0.13;
inline constexpr double kSideWidth = 1e-3;
double BestSplineSide(const std::function<double(double side)>& loss, double largest_side);

}  // namespace warplut
