// The accuracy of calibrated parameters: standard errors and correlations.
#pragma once

#include <optional>
#include <vector>

#include "train/calibration/run_log.h"
#include "train/calibration/search_space.h"

namespace warplut {

// In coordinates of the space.
struct Covariance {
  // Nothing for coordinates that no residual depends on or that lie at an end of their range.
  std::vector<std::optional<double>> standard_errors;
  std::vector<double>
      correlations;  // size x size, row by row; 0 where one of the two has no standard error
};

// Of the differences, of the unit cube's side.
inline constexpr double kCovarianceStep = 0.02;

// H^-1 M H^-1: with the loss L = sum of l_k, l_k = r_k^2 / 2, H is the Hessian of L and M = n /
// (n - p) * sum of (g_k - mean g) (g_k - mean g)^T over the gradients of the n residuals' l_k; both
// by differences of kCovarianceStep. It answers how much the point with the least loss would move
// with other data of this kind, each residual independent of the others. sigma^2 (J^T J)^-1 does
// not: most of a loss like 1 - SSIM is there at any parameter, and is not noise around zero.
// Source: Huber, "The behavior of maximum likelihood estimates under nonstandard conditions", 1967.
//
// 2 p + p (p - 1) / 2 runs. Nothing if the log stops, if n <= p, or if H is not positive definite:
// `point` is then no minimum at this width.
std::optional<Covariance> CovarianceAt(RunLog& log, const SearchSpace& space, float gate_width,
                                       const Point& point);

}  // namespace warplut
