// Median and quartiles of measured values.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace warplut {

struct Quartiles {
  double low = 0, median = 0, high = 0;
};

// Between the two nearest order statistics, linearly: the share p lies at p (n - 1), counted from
// 0. `values` is not empty and has no NaN.
inline Quartiles QuartilesOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double position = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    const double part = position - static_cast<double>(below);
    // Equal neighbours, infinite ones too, are their own mean.
    if (values[below] == values[above]) return values[below];
    return values[below] + part * (values[above] - values[below]);
  };
  return {at(0.25), at(0.5), at(0.75)};
}

}  // namespace warplut
