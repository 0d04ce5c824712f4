// A baked table made ready for lookup: floats, 33 x 33 nodes, so that bilinear lookup needs no
// wrap.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luts/contract.h"
#include "luts/half.h"
#include "luts/tap_layout.h"
#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

// How an offset becomes weights: the nearest node, or the bilinear mean of the four nodes around
// it.
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
  // Decodes the table; `view.data` need not outlive the call. Rows of node 32 are those of node 0,
  // one tap further (the contract keeps the tap that would leave the window at zero). Assumes that
  // the view keeps the contract.
  explicit Table(const TableView& view);

  // The weights for offset (dx, dy) in [0, 1): those of the window, 0 where there is no tap. Those
  // of the nearest lookup are exactly those of every kernel. Those of the bilinear one are, up to
  // float rounding (a kernel may fuse multiply and add): 2^-22 per weight.
  Weights<float> At(float dx, float dy, Lookup lookup) const;

  // 33 x 33 rows of RowFloats(footprint()) numbers, dy slowest, 64-byte aligned: the weights in the
  // order of LayoutOf(footprint()), then 0.
  const float* data() const { return lines_.front().weights.data(); }

  Footprint footprint() const { return footprint_; }

  // What turns an image into the coefficients that this table reads (luts/prefilter.h).
  const Prefilter& prefilter() const { return prefilter_; }

 private:
  static constexpr int kLine = 16;
  struct alignas(64) Line {
    std::array<float, kLine> weights{};
  };

  float Weight(int ix, int jy, int place) const {
    return data()[(jy * kTableNodes + ix) * RowFloats(footprint_) + place];
  }

  std::vector<Line> lines_;
  Prefilter prefilter_;
  Footprint footprint_;
};

inline Table::Table(const TableView& view)
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
      constexpr int kEnd = kFirstWindowTap + kWindowTaps;
      Weights<float> weights{};
      for (int i = 0; i < taps.count; ++i) {
        const int x = TapX(taps[i]) + shift_x, y = TapY(taps[i]) + shift_y;
        if (x < kEnd && y < kEnd) weights[TapWeight(x, y)] = DecodedWeight(view, row + i);
      }
      for (int place = 0; place < taps.count; ++place) {
        const int at = (jy * kTableNodes + ix) * RowFloats(footprint_) + place;
        lines_[at / kLine].weights[at % kLine] = weights[layout.Weight(place)];
      }
    }
  }
}

inline Weights<float> Table::At(float dx, float dy, Lookup lookup) const {
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
