// The MLP of resampling weights: offset (dx, dy) -> one raw value for each tap of a footprint,
// neurons [16, 32, 64, taps], tanh between layers.
//
// Parameters are one flat array; layer l holds its weights row-major ([out][in]) and then its
// biases. The input is centred: (2 dx - 1, 2 dy - 1). The head gives the raw values their meaning
// (head.h). Source: Mob-FGSR supplement, section 5 (layers and activation; the centring is ours).
#pragma once

#include <array>
#include <cmath>

#include "luts/contract.h"

namespace warplut {

inline constexpr std::array<int, 4> kMlpInner = {2, 16, 32, 64};  // widths before the last layer
inline constexpr int kMlpLayers = static_cast<int>(kMlpInner.size());

// How many values go into layer `layer`, or out of the one before it.
constexpr int MlpWidth(int layer, Footprint footprint) {
  return layer < kMlpLayers ? kMlpInner[static_cast<std::size_t>(layer)] : TapCount(footprint);
}

// Where the parameters of a layer begin; that of the last one does not depend on the footprint.
constexpr int MlpLayerOffset(int layer, Footprint footprint = Footprint::k16) {
  int offset = 0;
  for (int l = 0; l < layer; ++l)
    offset += (MlpWidth(l, footprint) + 1) * MlpWidth(l + 1, footprint);
  return offset;
}

constexpr int MlpParameters(Footprint footprint) { return MlpLayerOffset(kMlpLayers, footprint); }
inline constexpr int kMlpParameters = MlpParameters(Footprint::k16);
static_assert(kMlpParameters == 3744);

// The slow, obvious forward pass; the baker's. `parameters` has MlpParameters(footprint) values.
template <class T>
Weights<T> Mlp(const T* parameters, T dx, T dy, Footprint footprint = Footprint::k16) {
  using std::tanh;
  std::array<T, 64> in{T(2) * dx - T(1), T(2) * dy - T(1)};
  std::array<T, 64> out{};
  for (int layer = 0; layer < kMlpLayers; ++layer) {
    const int n_in = MlpWidth(layer, footprint);
    const int n_out = MlpWidth(layer + 1, footprint);
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
  const FootprintTaps& taps = TapsOf(footprint);
  for (int i = 0; i < taps.count; ++i) raw[taps[i]] = in[i];
  return raw;
}

}  // namespace warplut
