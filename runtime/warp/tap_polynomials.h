// The four weights of an axis as cubic polynomials of the offset, for vector code.
#pragma once

#include <array>

#include "luts/filters.h"
#include "runtime/filter.h"

namespace warplut {

// The four weights of one axis of a closed-form filter (not Filter::kLut); `parameter` is a of
// Filter::kKeys, k of Filter::kSpline.
template <class T>
constexpr std::array<T, kTaps> FilterTaps(Filter filter, float parameter, T d) {
  switch (filter) {
    case Filter::kBilinear:
      return BilinearTaps(d);
    case Filter::kCatmullRom:
      return KeysTaps(T(kCatmullRomA), d);
    case Filter::kKeys:
      return KeysTaps(T(parameter), d);
    case Filter::kSpline:
      return SplineTaps(T(parameter), d);
    case Filter::kLut:
      break;
  }
  return {};
}

// weight of tap t at offset d = sum of coefficients[t][i] d^i.
struct TapPolynomials {
  std::array<std::array<float, 4>, kTaps> coefficients{};

  // The closed forms are cubic in d, so their values at d = -1, 0, 1, 2 determine them.
  explicit TapPolynomials(Filter filter, float parameter = static_cast<float>(kCatmullRomA)) {
    const auto at_minus_1 = FilterTaps(filter, parameter, -1.0);
    const auto at_0 = FilterTaps(filter, parameter, 0.0);
    const auto at_1 = FilterTaps(filter, parameter, 1.0);
    const auto at_2 = FilterTaps(filter, parameter, 2.0);
    for (int t = 0; t < kTaps; ++t) {
      const double c3 = (at_2[t] - at_minus_1[t] + 3 * (at_0[t] - at_1[t])) / 6;
      const double c2 = (at_1[t] + at_minus_1[t]) / 2 - at_0[t];
      const double c1 = at_1[t] - at_0[t] - c2 - c3;
      coefficients[t] = {static_cast<float>(at_0[t]), static_cast<float>(c1),
                         static_cast<float>(c2), static_cast<float>(c3)};
    }
  }
};

}  // namespace warplut
