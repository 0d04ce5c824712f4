// Keeps the bound on gain: takes back the excess that the penalty lets through.
//
// With the head's residual scaled by t, which is to scale the last layer's parameters by t, the
// weights are C + t (w - C), C the head's base: Catmull-Rom weights, whose gain is 1, the spline of
// the prefilter's side, or a wide kernel. The gain is convex in t: it is within the limit from 0 up
// to some largest t. A trained FIR goes with t too, from the one of its side
// (train/fit/rivals/spline_family.h): T + t (P - T).
#pragma once

#include <vector>

#include "train/fit/resampler_model.h"

namespace warplut {

// The gain that a fit must keep whose training was bound to `gain_bound`: kGrowthReserve
// (train/fit/train_options.h) was held back for this. With the default bound it is the gain whose
// power at the longest horizon is kSafeGrowth.
double LargestGain(double gain_bound);

// Scales the last layer of `parameters` by the largest t in [0, 1] for which no node's gain is
// above `limit` > 1, to within 1e-3, the prefilter as it is stored; returns t. Leaves them alone
// where t is 1. A FIR is moved by the same t, which also makes it valid. The base keeps the limit
// (not checked).
double LimitGain(double limit, ResamplerModel& model, std::vector<double>& parameters);

}  // namespace warplut
