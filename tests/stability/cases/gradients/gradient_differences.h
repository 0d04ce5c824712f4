// Derivatives to compare an analytic gradient with.
//
// Complex step: f'(x) = Im f(x + i h) / h, without cancellation and for h = 1e-100 exact to
// rounding, for any f that is real and analytic. Source: Squire and Trapp, "Using complex variables
// to estimate derivatives of real functions", 1998.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>
#include <vector>

namespace warplut {

using Complex = std::complex<double>;

inline constexpr double kComplexStep = 1e-100;

inline Complex Seeded(double value, double direction) { return {value, kComplexStep * direction}; }
inline double Derivative(const Complex& value) { return value.imag() / kComplexStep; }

// A direction of random signs: a point seeded in it, and what a gradient there says of the
// derivative along it.
struct SeededDirection {
  std::vector<Complex> point;
  double analytic = 0;
};

// `random.Below(2)` gives the signs (train/fit/random.h).
template <class Random>
SeededDirection RandomDirection(const std::vector<double>& at, const std::vector<double>& gradient,
                                Random& random) {
  SeededDirection direction;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double sign = random.Below(2) == 0 ? -1 : 1;
    direction.point.push_back(Seeded(at[i], sign));
    direction.analytic += sign * gradient[i];
  }
  return direction;
}

// The Euclidean length: the root mean square of g . v over random directions v.
inline double LengthOf(const std::vector<double>& gradient) {
  double sum = 0;
  for (const double g : gradient) sum += g * g;
  return std::sqrt(sum);
}

// f'(x) to fourth order: truncation h^4 f^(5) / 30, rounding 1.5 eps |f| / h.
template <class Function>
double FourthOrderDifference(const Function& f, double x, double h) {
  return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h);
}

// The largest difference of elements, relative to the largest of `exact`; absolute where that is 0.
template <class A, class B>
double RelativeError(const A& approximate, const B& exact) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < std::size(exact); ++i) {
    const double d = std::abs(approximate[i] - exact[i]);
    if (!(d <= difference)) difference = d;
    size = std::max(size, std::abs(static_cast<double>(exact[i])));
  }
  return size > 0 ? difference / size : difference;
}

}  // namespace warplut
