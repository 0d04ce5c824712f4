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

bool InWindow(int x, int y) {
  constexpr int kEnd = kFirstWindowTap + kWindowTaps;
  return x < kEnd && y < kEnd;
}

}  // namespace

Table::Table(const TableView& view)
    : lines_(
          static_cast<std::size_t>(kTableNodes * kTableNodes * RowFloats(view.footprint) / kLine)),
      prefilter_(view.prefilter),
      footprint_(view.footprint) {
  const FootprintTaps& taps = TapsOf(footprint_);
  const TapLayout& layout = LayoutOf(footprint_);
  for (int jy = 0; jy < kTableNodes; ++jy) {
    for (int ix = 0; ix < kTableNodes; ++ix) {
      // Node 32 is node 0 of the next texel: its tap k is tap k - 1 there.
      const int shift_x = ix / kNodes;
      const int shift_y = jy / kNodes;
      const int row = RowIndex(ix % kNodes, jy % kNodes) * taps.count;
      Weights<float> weights{};
      for (int i = 0; i < taps.count; ++i) {
        const int x = TapX(taps[i]) + shift_x, y = TapY(taps[i]) + shift_y;
        if (InWindow(x, y)) weights[TapWeight(x, y)] = Decode(view, row + i);
      }
      for (int place = 0; place < taps.count; ++place) {
        const int at = (jy * kTableNodes + ix) * RowFloats(footprint_) + place;
        lines_[at / kLine].weights[at % kLine] = weights[layout.Weight(place)];
      }
    }
  }
}

Weights<float> Table::At(float dx, float dy, Lookup lookup) const {
  const TapLayout& layout = LayoutOf(footprint_);
  const int taps = TapCount(footprint_);
  Weights<float> w{};
  if (lookup == Lookup::kNearest) {
    for (int place = 0; place < taps; ++place) {
      w[layout.Weight(place)] = Weight(NearestNode(dx), NearestNode(dy), place);
    }
    return w;
  }
  const int ix = static_cast<int>(dx * kNodes);
  const int jy = static_cast<int>(dy * kNodes);
  const float fx = dx * kNodes - static_cast<float>(ix);
  const float fy = dy * kNodes - static_cast<float>(jy);
  for (int place = 0; place < taps; ++place) {
    const float upper = (1 - fx) * Weight(ix, jy, place) + fx * Weight(ix + 1, jy, place);
    const float lower = (1 - fx) * Weight(ix, jy + 1, place) + fx * Weight(ix + 1, jy + 1, place);
    w[layout.Weight(place)] = (1 - fy) * upper + fy * lower;
  }
  return w;
}

}  // namespace warplut
