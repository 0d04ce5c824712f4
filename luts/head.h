// The head: raw MLP outputs -> resampling weights that keep the contract by construction.
//
//   F(d)    = mean over the 8 symmetries g of g^-1 f(g d), with f(d) the MLP's 16 raw values: equivariant everywhere,
//           also at offsets that a symmetry leaves in place
//   r(d)    = M(d) F(d), the residual: M masks each tap so that the residual vanishes where the contract
//           wants zeros (outer taps fade with 4 d (1 - d), inner ones with the distance to the other inner tap)
//   w(d)    = C(d) + r(d) - m B(d) - m_x G_x(d) - m_y G_y(d), with C Catmull-Rom and B bilinear weights
//
// m is the sum of r; m_x and m_y are its first moments about d, the sums of r_k (tap_k - d). G_x is the difference
// (0, -1, 1, 0) along x times the bilinear weights along y: it sums to 0 and has first moment 1; G_y alike.
//
// Hence, for any parameters: the 8 symmetries hold; the weights sum to 1; their first moment is d, so that a ramp is
// moved by exactly d and nothing drifts when the same offset repeats (a pan); d = 0 is the identity; and a node with
// dx = 0 (dy = 0) has weights in one column (row) only, so that neighbouring cells meet without a seam.
#pragma once

#include "luts/filters.h"
#include "luts/mlp.h"
#include "luts/symmetry.h"

namespace warplut {

// The mask of the four taps of one axis at fraction d.
template <class T>
constexpr std::array<T, kTaps> HeadMask(T d) {
  const T outer = T(4) * d * (T(1) - d);
  return {outer, T(1) - d, d, outer};
}

// What the head does at one offset, linear in F: w = base + P F. Project and its transpose serve the forward pass and
// the gradient.
template <class T>
class HeadAt {
 public:
  HeadAt(T dx, T dy)
      : base_(KeysWeights(T(kCatmullRomA), dx, dy)),
        mask_(Separable(HeadMask(dx), HeadMask(dy))),
        even_(BilinearWeights(dx, dy)),
        step_x_(Separable(kStep, BilinearTaps(dy))),
        step_y_(Separable(BilinearTaps(dx), kStep)) {
    for (int k = 0; k < kWeights; ++k) {
      from_x_[k] = T(TapX(k)) - dx;
      from_y_[k] = T(TapY(k)) - dy;
    }
  }

  // The weights for the mean F of the raw values.
  Weights<T> Forward(const Weights<T>& mean) const {
    T sum = T(0), moment_x = T(0), moment_y = T(0);
    Weights<T> residual{};
    for (int k = 0; k < kWeights; ++k) {
      residual[k] = mask_[k] * mean[k];
      sum = sum + residual[k];
      moment_x = moment_x + residual[k] * from_x_[k];
      moment_y = moment_y + residual[k] * from_y_[k];
    }
    Weights<T> weights{};
    for (int k = 0; k < kWeights; ++k) {
      weights[k] =
          base_[k] + residual[k] - sum * even_[k] - moment_x * step_x_[k] - moment_y * step_y_[k];
    }
    return weights;
  }

  // d(loss)/dF from d(loss)/d(weights).
  Weights<T> Backward(const Weights<T>& gradient) const {
    T even = T(0), step_x = T(0), step_y = T(0);
    for (int k = 0; k < kWeights; ++k) {
      even = even + gradient[k] * even_[k];
      step_x = step_x + gradient[k] * step_x_[k];
      step_y = step_y + gradient[k] * step_y_[k];
    }
    Weights<T> mean{};
    for (int k = 0; k < kWeights; ++k) {
      mean[k] = mask_[k] * (gradient[k] - even - step_x * from_x_[k] - step_y * from_y_[k]);
    }
    return mean;
  }

 private:
  static constexpr std::array<T, kTaps> kStep = {T(0), T(-1), T(1), T(0)};

  Weights<T> base_, mask_, even_, step_x_, step_y_, from_x_{}, from_y_{};
};

// The weights w(d) of the MLP with these parameters (kMlpParameters values); the slow, obvious version.
template <class T>
Weights<T> HeadWeights(const T* parameters, T dx, T dy) {
  Weights<T> mean{};
  for (int g = 0; g < kSymmetries; ++g) {
    const auto [gx, gy] = MapOffset(g, dx, dy);
    const Weights<T> raw = Mlp(parameters, gx, gy);
    for (int k = 0; k < kWeights; ++k) {
      mean[k] = mean[k] + raw[MapWeight(g, k)] * T(1.0 / kSymmetries);
    }
  }
  return HeadAt<T>(dx, dy).Forward(mean);
}

}  // namespace warplut
