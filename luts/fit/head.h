// The head: raw MLP outputs -> resampling weights that keep the contract by construction.
//
//   F(d)    = mean over the 8 symmetries g of g^-1 f(g d), with f(d) the MLP's raw values, one for
//           each tap: equivariant everywhere, also at offsets that a symmetry leaves in place
//   r(d)    = M(d) F(d), the residual: M masks each tap so that the residual vanishes where the
//           contract wants zeros (outer taps fade with 4 d (1 - d), inner ones with the distance to
//           the other inner tap)
//   w(d)    = C(d) + r(d) - m B(d) - m_x G_x(d) - m_y G_y(d), with C Catmull-Rom and B bilinear
//           weights
//
// m is the sum of r; m_x and m_y are its first moments about d, the sums of r_k (tap_k - d). G_x is
// the difference (0, -1, 1, 0) along x times the bilinear weights along y: it sums to 0 and has
// first moment 1; G_y alike.
//
// Hence, for any parameters: the 8 symmetries hold; the weights sum to 1; their first moment is d,
// so that a ramp is moved by exactly d and nothing drifts when the same offset repeats (a pan);
// d = 0 is the identity; and a node with dx = 0 (dy = 0) has weights in one column (row) only, so
// that neighbouring cells meet without a seam.
//
// With 24 and 36 taps C are the weights of their wide kernel (luts/wide_kernel.h), and m_x and m_y
// are left out: what closes the first moment of weights that reach so far costs more at the
// frequencies that images have than it gains.
//
// With a prefilter of side s (luts/prefilter.h) C is the spline of that side in place of
// Catmull-Rom, and
//
//   r(d) = fade(d) R(dx) F(d) R(dy)^T,   fade(d) = 1 - (1 - 2 dx)^2 (1 - 2 dy)^2
//
// with F as a 4 x 4 array. R adds to the masked taps a bend (1, -2, 1) about tap 0, by what tap -1
// has, and about tap 1, by what tap 2 has, so that a node with dx = 0 has equal weights in the
// columns 0 and 2 and none in column 3. The fade is 0 where both axes are whole: there the
// prefilter, then the weights, are the identity.
#pragma once

#include "luts/filters.h"
#include "luts/fit/mlp.h"
#include "luts/fit/symmetry.h"
#include "luts/wide_kernel.h"

namespace warplut {

// The mask of the taps of the window along one axis at fraction d.
template <class T>
constexpr WindowTaps<T> HeadMask(T d) {
  const T outer = T(4) * d * (T(1) - d);
  return {outer, outer, T(1) - d, d, outer, outer};
}

// The same of both axes, 0 where the footprint has no tap.
template <class T>
constexpr Weights<T> HeadMask(Footprint footprint, T dx, T dy) {
  const WindowTaps<T> x = HeadMask(dx), y = HeadMask(dy);
  Weights<T> mask{};
  for (const int k : TapsOf(footprint)) mask[k] = y[k / kWindowTaps] * x[k % kWindowTaps];
  return mask;
}

// R(d) of one axis, for its four taps: [row of the result][tap of F].
template <class T>
using HeadMatrix = std::array<std::array<T, kTaps>, kTaps>;

template <class T>
constexpr HeadMatrix<T> HeadSpread(T d) {
  const WindowTaps<T> mask = HeadMask(d);
  const T e = T(1) - d;
  return {{{mask[1] + e, T(0), T(0), T(0)},
           {T(-2) * e, mask[2], T(0), d},
           {e, T(0), mask[3], T(-2) * d},
           {T(0), T(0), T(0), mask[4] + d}}};
}

// What the head does at one offset, linear in F: w = base + P F. Project and its transpose serve
// the forward pass and the gradient.
template <class T>
class HeadAt {
 public:
  // Of 16 taps, without prefilter.
  HeadAt(T dx, T dy)
      : base_(KeysWeights(T(kCatmullRomA), dx, dy)),
        mask_(HeadMask(Footprint::k16, dx, dy)),
        even_(BilinearWeights(dx, dy)),
        step_x_(Separable(kStep, BilinearTaps(dy))),
        step_y_(Separable(BilinearTaps(dx), kStep)) {
    SetMoments(dx, dy);
  }

  // Of 24 or 36 taps, with this `kernel` of theirs (WideWeights) at the offset.
  HeadAt(Footprint footprint, const Weights<double>& kernel, T dx, T dy)
      : footprint_(footprint), mask_(HeadMask(footprint, dx, dy)), even_(BilinearWeights(dx, dy)) {
    for (const int k : TapsOf(footprint)) base_[k] = T(kernel[k]);
  }

  // With a prefilter of this side.
  HeadAt(T dx, T dy, T side)
      : prefiltered_(true),
        base_(SplineWeights(SplineK(side), dx, dy)),
        even_(BilinearWeights(dx, dy)),
        step_x_(Separable(kStep, BilinearTaps(dy))),
        step_y_(Separable(BilinearTaps(dx), kStep)),
        spread_x_(HeadSpread(dx)),
        spread_y_(HeadSpread(dy)) {
    const T x = T(1) - T(2) * dx, y = T(1) - T(2) * dy;
    const T fade = T(1) - x * x * y * y;
    for (auto& row : spread_x_) {
      for (T& entry : row) entry = fade * entry;
    }
    const auto bend_x = SplineBend(dx), bend_y = SplineBend(dy);
    const auto taps_x = SplineTaps(SplineK(side), dx), taps_y = SplineTaps(SplineK(side), dy);
    const Weights<T> along_x = Separable(bend_x, taps_y), along_y = Separable(taps_x, bend_y);
    for (int k = 0; k < kWeights; ++k) base_slope_[k] = along_x[k] + along_y[k];
    SetMoments(dx, dy);
  }

  // With a prefilter: d(weights)/d(side).
  const Weights<T>& base_slope() const { return base_slope_; }

  // The weights for the mean F of the raw values.
  Weights<T> Forward(const Weights<T>& mean) const {
    if (prefiltered_) return Closed(Spread(mean));
    Weights<T> residual{};
    for (const int k : TapsOf(footprint_)) residual[k] = mask_[k] * mean[k];
    return Closed(residual);
  }

  // d(loss)/dF from d(loss)/d(weights).
  Weights<T> Backward(const Weights<T>& gradient) const {
    T even = T(0), step_x = T(0), step_y = T(0);
    for (const int k : TapsOf(footprint_)) {
      even = even + gradient[k] * even_[k];
      step_x = step_x + gradient[k] * step_x_[k];
      step_y = step_y + gradient[k] * step_y_[k];
    }
    Weights<T> mean{};
    for (const int k : TapsOf(footprint_)) {
      mean[k] = gradient[k] - even - step_x * from_x_[k] - step_y * from_y_[k];
      if (!prefiltered_) mean[k] = mask_[k] * mean[k];
    }
    return prefiltered_ ? SpreadTransposed(mean) : mean;
  }

 private:
  static constexpr std::array<T, kTaps> kStep = {T(0), T(-1), T(1), T(0)};

  void SetMoments(T dx, T dy) {
    for (int k = 0; k < kWeights; ++k) {
      from_x_[k] = T(TapX(k)) - dx;
      from_y_[k] = T(TapY(k)) - dy;
    }
  }

  // C + r, less what the sum of r and its moments take from it.
  Weights<T> Closed(const Weights<T>& residual) const {
    T sum = T(0), moment_x = T(0), moment_y = T(0);
    for (const int k : TapsOf(footprint_)) {
      sum = sum + residual[k];
      moment_x = moment_x + residual[k] * from_x_[k];
      moment_y = moment_y + residual[k] * from_y_[k];
    }
    Weights<T> weights{};
    for (const int k : TapsOf(footprint_)) {
      weights[k] =
          base_[k] + residual[k] - sum * even_[k] - moment_x * step_x_[k] - moment_y * step_y_[k];
    }
    return weights;
  }

  // R(dy) mean R(dx)^T, and its transpose; the fade is in R(dx).
  Weights<T> Spread(const Weights<T>& mean) const { return Transform<false>(mean); }
  Weights<T> SpreadTransposed(const Weights<T>& mean) const { return Transform<true>(mean); }

  template <bool kTransposed>
  Weights<T> Transform(const Weights<T>& in) const {
    const auto at = [](const HeadMatrix<T>& matrix, int row, int column) {
      return kTransposed ? matrix[column][row] : matrix[row][column];
    };
    const auto place = [](int kx, int ky) { return TapWeight(kFirstTap + kx, kFirstTap + ky); };
    Weights<T> along_x{}, out{};
    for (int ky = 0; ky < kTaps; ++ky) {
      for (int kx = 0; kx < kTaps; ++kx) {
        T& sum = along_x[place(kx, ky)];
        for (int i = 0; i < kTaps; ++i) sum = sum + at(spread_x_, kx, i) * in[place(i, ky)];
      }
    }
    for (int ky = 0; ky < kTaps; ++ky) {
      for (int kx = 0; kx < kTaps; ++kx) {
        T& sum = out[place(kx, ky)];
        for (int j = 0; j < kTaps; ++j) sum = sum + at(spread_y_, ky, j) * along_x[place(kx, j)];
      }
    }
    return out;
  }

  bool prefiltered_ = false;
  Footprint footprint_ = Footprint::k16;
  Weights<T> base_{}, mask_{}, even_{}, step_x_{}, step_y_{}, from_x_{}, from_y_{}, base_slope_{};
  HeadMatrix<T> spread_x_{}, spread_y_{};
};

// F(d) of the MLP with these parameters (MlpParameters(footprint) values).
template <class T>
Weights<T> HeadMean(const T* parameters, T dx, T dy, Footprint footprint = Footprint::k16) {
  Weights<T> mean{};
  for (int g = 0; g < kSymmetries; ++g) {
    const auto [gx, gy] = MapOffset(g, dx, dy);
    const Weights<T> raw = Mlp(parameters, gx, gy, footprint);
    for (const int k : TapsOf(footprint)) {
      mean[k] = mean[k] + raw[MapWeight(g, k)] * T(1.0 / kSymmetries);
    }
  }
  return mean;
}

// The weights w(d) of 16 taps, without prefilter; the slow, obvious version.
template <class T>
Weights<T> HeadWeights(const T* parameters, T dx, T dy) {
  return HeadAt<T>(dx, dy).Forward(HeadMean(parameters, dx, dy));
}

// The same with a prefilter of this side.
template <class T>
Weights<T> HeadWeights(const T* parameters, T dx, T dy, T side) {
  return HeadAt<T>(dx, dy, side).Forward(HeadMean(parameters, dx, dy));
}

// The same of 24 or 36 taps, with the wide kernel of parameter b. The offset is real.
template <class T>
Weights<T> HeadWeights(Footprint footprint, double b, const T* parameters, double dx, double dy) {
  const HeadAt<T> head(footprint, WideWeights(footprint, b, dx, dy), T(dx), T(dy));
  return head.Forward(HeadMean(parameters, T(dx), T(dy), footprint));
}

}  // namespace warplut
