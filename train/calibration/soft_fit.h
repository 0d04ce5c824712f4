// Levenberg-Marquardt on the residuals of the pipeline with gates of finite width.
#pragma once

#include "train/calibration/run_log.h"
#include "train/calibration/search_space.h"

namespace warplut {

// From `start` at one gate width: Ceres, Jacobians by forward differences of kDifference
// (inwards at the upper end); a point outside the unit cube stands for the nearest one in it.
// Returns the best point, `start` if there is no better one; stops early with the log.
// *trust_radius is what Levenberg-Marquardt begins and ends with.
Point FitAtWidth(RunLog& log, const SearchSpace& space, float gate_width, const Point& start,
                 double* trust_radius);

// To begin with. A loss of which most is there at any parameter varies slowly beside its size, so
// that J^T J understates its curvature: short steps first.
inline constexpr double kTrustRadius = 0.2;

// Steps of the differences, of the unit cube's side: larger than the noise of frames that are
// stored in 8 bits or half float.
inline constexpr double kDifference = 0.01;

}  // namespace warplut
