#include "tools/report/power_law.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace warplut {

PowerLaw FitPowerLaw(std::span<const double> x, std::span<const double> y) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto count = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / count;
    mean_y += std::log(y[i]) / count;
  }
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = std::log(x[i]) - mean_x;
    xx += dx * dx;
    xy += dx * (std::log(y[i]) - mean_y);
  }
  if (!(xx > 0) || !std::isfinite(xx) || !std::isfinite(xy)) return {kNone, kNone, kNone};
  const double exponent = xy / xx;
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double residual = std::log(y[i]) - mean_y - exponent * (std::log(x[i]) - mean_x);
    squares += residual * residual;
  }
  return {.exponent = exponent,
          .error = x.size() > 2 ? std::sqrt(squares / (count - 2) / xx) : kNone,
          .factor = std::exp(mean_y - exponent * mean_x)};
}

std::string ExponentText(const PowerLaw& law) {
  return std::isfinite(law.error) ? fmt::format("{:.2f} +- {:.2f}", law.exponent, law.error)
                                  : fmt::format("{:.2f}", law.exponent);
}

}  // namespace warplut
