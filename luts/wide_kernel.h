// The closed-form kernels of the footprints of 24 and 36 taps: where their weights start, and the
// head's base (luts/fit/head.h).
//
// Along one axis, with the fraction d in [0, 1] and the taps n = -2..3:
//
//   K_n(d) = sinc(d - n) I0(b sqrt(1 - ((d - n) / 3)^2)),  divided by the sum over n
//
// the Kaiser-windowed sinc of 6 taps; sinc(t) = sin(pi t) / (pi t), I0 the modified Bessel function
// of order 0. b = 0 is the truncated sinc; a larger one is blurrier. Source: Kaiser 1974.
//
//   36 taps  K(dx) K(dy)
//   24 taps  C C + (K - C) B + B (K - C),  the first factor along x, with C Catmull-Rom and B the
//            linear weights: the Boolean sum, whose outer taps lie in the two central rows and
//            columns alone
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "luts/filters.h"

namespace warplut {

inline constexpr double kLargestKaiser = 32;  // of b, in [0, kLargestKaiser]

template <class T>
using WindowTaps = std::array<T, kWindowTaps>;

// I0(sqrt(square)) by its power series, whose terms are all positive: accurate to the last bits.
template <class T>
T BesselI0OfSquare(T square) {
  constexpr int kTerms = 64;  // enough for kLargestKaiser, in double
  T sum = T(1), term = T(1);
  for (int k = 1; k <= kTerms; ++k) {
    term = term * square * T(1.0 / (4.0 * k * k));
    sum = sum + term;
  }
  return sum;
}

// The weights above for d in [0, 1]. They sum to 1; d = 0 gives the texel itself, d = 1 the next
// one, and 1 - d the same weights in reverse.
inline WindowTaps<double> KaiserTaps(double b, double d) {
  constexpr double kHalfWidth = kWindowTaps / 2;
  const bool mirrored = d > 0.5;
  if (mirrored) d = 1 - d;
  WindowTaps<double> taps{};
  double total = 0;
  // sin(pi (d - n)) is sin(pi d) but for its sign, which leaves all outer taps exactly 0 at d = 0.
  const double sine = std::sin(std::numbers::pi * d);
  for (int i = 0; i < kWindowTaps; ++i) {
    const int n = kFirstWindowTap + i;
    const double t = d - n;
    const double inside = std::max(0.0, 1 - (t / kHalfWidth) * (t / kHalfWidth));
    const double sinc = t == 0 ? 1 : (n % 2 == 0 ? sine : -sine) / (std::numbers::pi * t);
    taps[i] = sinc * BesselI0OfSquare(b * b * inside);
    total += taps[i];
  }
  for (double& tap : taps) tap /= total;
  if (mirrored) std::reverse(taps.begin(), taps.end());
  return taps;
}

// Four taps as those of the window.
template <class T>
constexpr WindowTaps<T> InWindow(const std::array<T, kTaps>& taps) {
  WindowTaps<T> wide{};
  for (int k = 0; k < kTaps; ++k) wide[k + kFirstTap - kFirstWindowTap] = taps[k];
  return wide;
}

// The weights above for a footprint of 24 or 36 taps and an offset in [0, 1]^2. They sum to 1.
inline Weights<double> WideWeights(Footprint footprint, double b, double dx, double dy) {
  const WindowTaps<double> kx = KaiserTaps(b, dx), ky = KaiserTaps(b, dy);
  if (footprint == Footprint::k36) return Separable(kx, ky);
  const WindowTaps<double> cx = InWindow(KeysTaps(kCatmullRomA, dx));
  const WindowTaps<double> cy = InWindow(KeysTaps(kCatmullRomA, dy));
  WindowTaps<double> more_x{}, more_y{};
  for (int k = 0; k < kWindowTaps; ++k) {
    more_x[k] = kx[k] - cx[k];
    more_y[k] = ky[k] - cy[k];
  }
  const Weights<double> inner = Separable(cx, cy);
  const Weights<double> along_x = Separable(more_x, InWindow(BilinearTaps(dy)));
  const Weights<double> along_y = Separable(InWindow(BilinearTaps(dx)), more_y);
  Weights<double> w{};
  for (int k = 0; k < kWeights; ++k) w[k] = inner[k] + along_x[k] + along_y[k];
  return w;
}

}  // namespace warplut
