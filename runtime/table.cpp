#include "runtime/table.h"

#include <cmath>
#include <cstddef>

#include "runtime/half.h"

namespace warplut {
namespace {

float Decode(const TableView& view, int index) {
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

}  // namespace

Table::Table(const TableView& view)
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
          out[WeightIndex(kx, ky)] = Decode(view, row + WeightIndex(kx - shift_x, ky - shift_y));
        }
      }
    }
  }
}

Weights<float> Table::At(float dx, float dy, Lookup lookup) const {
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
