// The MLP of resampling weights: offset (dx, dy) -> 16 raw values, neurons [16, 32, 64, 16], tanh
// between layers.
//
// Parameters are one flat array; layer l holds its weights row-major ([out][in]) and then its
// biases. The input is centred: (2 dx - 1, 2 dy - 1). The head gives the raw values their meaning
// (head.h). Source: Mob-FGSR supplement, section 5 (layers and activation; the centring is ours).
#pragma once

#include <array>
#include <cmath>

#include "luts/contract.h"

namespace warplut {

inline constexpr std::array<int, 5> kMlpWidths = {2, 16, 32, 64, kWeights};
inline constexpr int kMlpLayers = static_cast<int>(kMlpWidths.size()) - 1;

constexpr int MlpLayerOffset(int layer) {
  int offset = 0;
  for (int l = 0; l < layer; ++l) offset += (kMlpWidths[l] + 1) * kMlpWidths[l + 1];
  return offset;
}

inline constexpr int kMlpParameters = MlpLayerOffset(kMlpLayers);
static_assert(kMlpParameters == 3744);

// The slow, obvious forward pass; the baker's. `parameters` has kMlpParameters values.
template <class T>
Weights<T> Mlp(const T* parameters, T dx, T dy) {
  using std::tanh;
  std::array<T, 64> in{T(2) * dx - T(1), T(2) * dy - T(1)};
  std::array<T, 64> out{};
  for (int layer = 0; layer < kMlpLayers; ++layer) {
    const int n_in = kMlpWidths[layer];
    const int n_out = kMlpWidths[layer + 1];
    const T* weight = parameters + MlpLayerOffset(layer);
    const T* bias = weight + n_in * n_out;
    for (int o = 0; o < n_out; ++o) {
      T sum = bias[o];
      for (int i = 0; i < n_in; ++i) sum = sum + weight[o * n_in + i] * in[i];
      out[o] = layer + 1 < kMlpLayers ? tanh(sum) : sum;
    }
    in = out;
  }
  Weights<T> raw{};
  for (int k = 0; k < kWeights; ++k) raw[k] = in[k];
  return raw;
}

}  // namespace warplut
