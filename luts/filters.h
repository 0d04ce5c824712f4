// The resampling formulas, once: weights of the closed-form filters, and the sum that turns weights
// and texels into a value. T is float in the reference kernel, double in the trainer, or any type
// with arithmetic (a dual number) where derivatives are wanted.
#pragma once

#include <cmath>

#include "luts/contract.h"

namespace warplut {

// Catmull-Rom is the Keys kernel with a = -1/2.
inline constexpr double kCatmullRomA = -0.5;

// The four weights of the Keys cubic convolution kernel with parameter a, for the fraction d in [0,
// 1]. They sum to 1; d = 0 gives (0, 1, 0, 0). Source: R. Keys 1981, equation 15 with free a.
template <class T>
constexpr std::array<T, kTaps> KeysTaps(T a, T d) {
  const T e = T(1) - d;
  // |t| <= 1: (a + 2) t^3 - (a + 3) t^2 + 1; 1 < |t| < 2: a t^3 - 5 a t^2 + 8 a t - 4 a, with
  // t = 1 + d factored as a d (1 - d)^2, which is exact at both ends.
  const T outer0 = a * d * e * e;
  const T outer3 = a * e * d * d;
  const T inner1 = ((a + T(2)) * d - (a + T(3))) * d * d + T(1);
  return {outer0, inner1, T(1) - inner1 - outer0 - outer3, outer3};
}

// The cubic spline family: kernel beta3 + k beta3'', beta3 the cubic B-spline, for coefficients
// that a prefilter of side SplineSide(k) made (luts/prefilter.h). k = 0 is the B-spline, k = 1/42
// the cubic o-MOMS. Source: Blu, Thevenaz, Unser, "MOMS: maximal-order interpolation of minimal
// support", IEEE TIP 2001.
inline constexpr double kOMomsK = 1.0 / 42;
template <class T>
constexpr T SplineSide(T k) {
  return T(1.0 / 6) + k;
}
template <class T>
constexpr T SplineK(T side) {
  return side - T(1.0 / 6);
}

// beta3'' at the taps of fraction d: the change of SplineTaps with k. They sum to 0.
template <class T>
constexpr std::array<T, kTaps> SplineBend(T d) {
  return {T(1) - d, T(3) * d - T(2), T(1) - T(3) * d, d};
}

// The four weights for the fraction d in [0, 1]. They sum to 1; d = 0 gives (s, 1 - 2 s, s, 0).
template <class T>
constexpr std::array<T, kTaps> SplineTaps(T k, T d) {
  const T e = T(1) - d;
  const T sixth = T(1.0 / 6);
  const std::array<T, kTaps> bend = SplineBend(d);
  const T outer0 = sixth * e * e * e + k * bend[0];
  const T outer3 = sixth * d * d * d + k * bend[3];
  const T inner1 = T(2.0 / 3) - d * d * (T(1) - T(0.5) * d) + k * bend[1];
  return {outer0, inner1, T(1) - inner1 - outer0 - outer3, outer3};
}

// The two-tap linear weights, as four taps.
template <class T>
constexpr std::array<T, kTaps> BilinearTaps(T d) {
  return {T(0), T(1) - d, d, T(0)};
}

// The tensor product of the weights of two axes: 4 x 4 taps.
template <class T>
constexpr Weights<T> Separable(const std::array<T, kTaps>& x, const std::array<T, kTaps>& y) {
  Weights<T> w{};
  for (int ky = 0; ky < kTaps; ++ky) {
    for (int kx = 0; kx < kTaps; ++kx) {
      w[TapWeight(kFirstTap + kx, kFirstTap + ky)] = y[ky] * x[kx];
    }
  }
  return w;
}

// The same of 6 x 6 taps.
template <class T>
constexpr Weights<T> Separable(const std::array<T, kWindowTaps>& x,
                               const std::array<T, kWindowTaps>& y) {
  Weights<T> w{};
  for (int k = 0; k < kWeights; ++k) w[k] = y[k / kWindowTaps] * x[k % kWindowTaps];
  return w;
}

template <class T>
constexpr Weights<T> KeysWeights(T a, T dx, T dy) {
  return Separable(KeysTaps(a, dx), KeysTaps(a, dy));
}

template <class T>
constexpr Weights<T> SplineWeights(T k, T dx, T dy) {
  return Separable(SplineTaps(k, dx), SplineTaps(k, dy));
}

template <class T>
constexpr Weights<T> BilinearWeights(T dx, T dy) {
  return Separable(BilinearTaps(dx), BilinearTaps(dy));
}

// The sampled value: sum of weight times texel over the taps of the footprint, in their order.
template <class T, class Texel>
constexpr Texel ApplyWeights(Footprint footprint, const Weights<T>& w,
                             const std::array<Texel, kWeights>& texels) {
  const FootprintTaps& taps = TapsOf(footprint);
  Texel sum = w[taps[0]] * texels[taps[0]];
  for (int i = 1; i < taps.count; ++i) sum = sum + w[taps[i]] * texels[taps[i]];
  return sum;
}

}  // namespace warplut
