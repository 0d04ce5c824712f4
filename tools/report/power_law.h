// How a cost grows: the exponent of y = c x^k.
#pragma once

#include <span>
#include <string>

namespace warplut {

struct PowerLaw {
  double exponent = 0;
  double error = 0;   // standard error of the exponent; NaN with two points
  double factor = 0;  // c
};

// Least squares of log y = log c + k log x, all points with the same weight. The standard error is
// sqrt(sum of squared residuals / (n - 2) / sum of squared deviations of log x). At least two
// points with different x; all positive: otherwise everything is NaN.
PowerLaw FitPowerLaw(std::span<const double> x, std::span<const double> y);

// "0.98 +- 0.02", or "0.98" without a standard error.
std::string ExponentText(const PowerLaw& law);

}  // namespace warplut
