// The head: raw MLP outputs -> resampling weights that keep the contract by construction.
//
//   f(d)    the MLP's 16 raw values
//   F(d)    = mean over the 8 symmetries g of g^-1 f(g d): equivariant everywhere, also at offsets that a
//           symmetry leaves in place
//   r(d)    = M(d) F(d), the residual: M masks each tap so that the residual vanishes where the contract
//           wants zeros (outer taps fade with 4 d (1 - d), inner ones with the distance to the other inner tap)
//   w(d)    = C(d) + r(d) - (sum of r(d)) B(d), with C Catmull-Rom and B bilinear weights
//
// Hence, for any parameters: the 8 symmetries hold, the weights sum to 1, d = 0 is the identity, and a node with
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
  const Weights<T> mask = Separable(HeadMask(dx), HeadMask(dy));
  T sum = T(0);
  for (int k = 0; k < kWeights; ++k) {
    mean[k] = mask[k] * mean[k];
    sum = sum + mean[k];
  }
  const Weights<T> base = KeysWeights(T(kCatmullRomA), dx, dy);
  const Weights<T> spread = BilinearWeights(dx, dy);
  Weights<T> w{};
  for (int k = 0; k < kWeights; ++k) w[k] = base[k] + mean[k] - sum * spread[k];
  return w;
}

}  // namespace warplut
