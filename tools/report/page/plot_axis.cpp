#include "tools/report/page/plot_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace warplut {
namespace {

constexpr double kRoom = 0.06;  // at each end, as a share of the range of the values

}  // namespace

PlotAxis::PlotAxis(bool logarithmic, std::span<const double> values) : logarithmic_(logarithmic) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!CanDraw(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) {
    low_ = logarithmic ? 1 : 0;
    high_ = logarithmic ? 10 : 1;
    return;
  }
  if (logarithmic) {
    const double room = std::max(kRoom * std::log10(high / low), 0.05);
    low_ = low * std::pow(10, -room);
    high_ = high * std::pow(10, room);
  } else {
    const double size = std::max({std::abs(low), std::abs(high), 1e-9});
    const double room = std::max(kRoom * (high - low), 1e-3 * size);
    low_ = low - room;
    high_ = high + room;
    // Numbers that are near zero on the scale of the others are seen from zero.
    if (low >= 0 && low < 0.3 * high) low_ = 0;
  }
}

bool PlotAxis::CanDraw(double value) const {
  return std::isfinite(value) && (!logarithmic_ || value > 0);
}

double PlotAxis::Share(double value) const {
  return logarithmic_ ? std::log(value / low_) / std::log(high_ / low_)
                      : (value - low_) / (high_ - low_);
}

std::vector<double> PlotAxis::Tics(int most) const {
  if (logarithmic_) return LogarithmicTics(most);
  const double raw = (high_ - low_) / most;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) {
      step = factor * power;
      break;
    }
  }
  std::vector<double> tics;
  for (double i = std::ceil(low_ / step); i * step <= high_ * (1 + 1e-12); ++i) {
    tics.push_back(i * step);
  }
  return tics;
}

std::vector<double> PlotAxis::LogarithmicTics(int most) const {
  const auto inside = [&](std::span<const double> factors, int every) {
    std::vector<double> tics;
    const int last = static_cast<int>(std::floor(std::log10(high_)));
    for (int power = static_cast<int>(std::floor(std::log10(low_))); power <= last; ++power) {
      if (power % every != 0) continue;
      for (const double factor : factors) {
        const double tic = factor * std::pow(10, power);
        if (tic >= low_ && tic <= high_) tics.push_back(tic);
      }
    }
    return tics;
  };
  const double all[] = {1, 2, 3, 4, 5, 6, 7, 8, 9}, third[] = {1, 2, 5}, half[] = {1, 3},
               one[] = {1};
  for (const std::span<const double> factors :
       {std::span<const double>(all), {third}, {half}, {one}}) {
    std::vector<double> tics = inside(factors, 1);
    if (static_cast<int>(tics.size()) <= most) return tics;
  }
  int every = 2;
  while (static_cast<int>(inside(one, every).size()) > most) ++every;
  return inside(one, every);
}

std::string TicText(double value) {
  return std::abs(value) < 1e-12 ? "0" : fmt::format("{:.4g}", value);
}

}  // namespace warplut
