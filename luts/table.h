// A baked table made ready for lookup: floats, 33 x 33 nodes, so that bilinear lookup needs no wrap.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luts/contract.h"
#include "luts/half.h"
#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

// How an offset becomes weights: the nearest node, or the bilinear mean of the four nodes around it.
enum class Lookup : std::uint8_t { kNearest, kBilinear };

constexpr const char* Name(Lookup lookup) {
  return lookup == Lookup::kNearest ? "nearest" : "bilinear";
}

// Weight `index` of the table as a number.
inline float DecodedWeight(const TableView& view, int index) {
  const float unit = std::ldexp(1.0f, -FractionBits(view.format));
  switch (view.format) {
    case TableFormat::kI16:
      return unit * static_cast<const std::int16_t*>(view.data)[index];
    case TableFormat::kF16:
      return HalfToFloat(static_cast<const std::uint16_t*>(view.data)[index]);
    case TableFormat::kI8:
      return unit * static_cast<const std::int8_t*>(view.data)[index];
    case TableFormat::kF32:
      return static_cast<const float*>(view.data)[index];
  }
  return 0.0f;
}

inline constexpr int kTableNodes = kNodes + 1;  // nodes per axis of a decoded table

// The nearest node of an offset component in [0, 1): 0..32, halves rounded up.
constexpr int NearestNode(float d) { return static_cast<int>(d * kNodes + 0.5f); }

class Table {
 public:
  // Decodes the table; `view.data` need not outlive the call. Rows of node 32 are those of node 0, one tap further
  // (the contract keeps the tap that would leave the window at zero). Assumes that the view keeps the contract.
  explicit Table(const TableView& view);

  // The weights for offset (dx, dy) in [0, 1). The nearest lookup is exactly what every kernel uses; the bilinear
  // one is that of the kernels up to float rounding (a kernel may fuse multiply and add): 2^-22 per weight.
  Weights<float> At(float dx, float dy, Lookup lookup) const;

  // 33 x 33 rows of 16 weights, dy slowest, 64-byte aligned rows.
  const float* data() const { return rows_.front().weights.data(); }

  // The prefilter that turns an image into the coefficients of this table (luts/prefilter.h).
  const Prefilter& prefilter() const { return prefilter_; }

 private:
  struct alignas(64) Row {
    Weights<float> weights;
  };
  std::vector<Row> rows_;
  Prefilter prefilter_;
};

inline Table::Table(const TableView& view)
    : rows_(kTableNodes * kTableNodes), prefilter_(view.prefilter) {
  for (int jy = 0; jy < kTableNodes; ++jy) {
    for (int ix = 0; ix < kTableNodes; ++ix) {
      // Node 32 is node 0 of the next texel: its tap k is tap k - 1 there.
      const int shift_x = ix / kNodes;
      const int shift_y = jy / kNodes;
      const int row = RowIndex(ix % kNodes, jy % kNodes) * kWeights;
      Weights<float>& out = rows_[jy * kTableNodes + ix].weights;
      out.fill(0.0f);
      for (int ky = shift_y; ky < kTaps; ++ky) {
        for (int kx = shift_x; kx < kTaps; ++kx) {
          out[WeightIndex(kx, ky)] = DecodedWeight(view, row + WeightIndex(kx - shift_x, ky - shift_y));
        }
      }
    }
  }
}

inline Weights<float> Table::At(float dx, float dy, Lookup lookup) const {
  if (lookup == Lookup::kNearest) {
    return rows_[NearestNode(dy) * kTableNodes + NearestNode(dx)].weights;
  }
  const int ix = static_cast<int>(dx * kNodes);
  const int jy = static_cast<int>(dy * kNodes);
  const float fx = dx * kNodes - static_cast<float>(ix);
  const float fy = dy * kNodes - static_cast<float>(jy);
  const int corner = jy * kTableNodes + ix;
  Weights<float> w;
  for (int k = 0; k < kWeights; ++k) {
    const float upper = (1 - fx) * rows_[corner].weights[k] + fx * rows_[corner + 1].weights[k];
    const float lower = (1 - fx) * rows_[corner + kTableNodes].weights[k] +
                        fx * rows_[corner + kTableNodes + 1].weights[k];
    w[k] = (1 - fy) * upper + fy * lower;
  }
  return w;
}

}  // namespace warplut
