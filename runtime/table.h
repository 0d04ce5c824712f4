// A baked table made ready for lookup: floats, 33 x 33 nodes, so that bilinear lookup needs no wrap.
#pragma once

#include <cstdint>
#include <vector>

#include "luts/contract.h"
#include "runtime/tap_layout.h"

namespace warplut {

// How an offset becomes weights: the nearest node, or the bilinear mean of the four nodes around it.
enum class Lookup : std::uint8_t { kNearest, kBilinear };

constexpr const char* Name(Lookup lookup) {
  return lookup == Lookup::kNearest ? "nearest" : "bilinear";
}

inline constexpr int kTableNodes = kNodes + 1;  // nodes per axis of a decoded table

// The nearest node of an offset component in [0, 1): 0..32, halves rounded up.
constexpr int NearestNode(float d) { return static_cast<int>(d * kNodes + 0.5f); }

class Table {
 public:
  // Decodes the table; `view.data` need not outlive the call. Rows of node 32 are those of node 0, one tap further
  // (the contract keeps the tap that would leave the window at zero). Assumes that the view keeps the contract.
  explicit Table(const TableView& view);

  // The weights for offset (dx, dy) in [0, 1): those of the window, 0 where there is no tap. The nearest lookup is exactly what every kernel uses; the bilinear
  // one is that of the kernels up to float rounding (a kernel may fuse multiply and add): 2^-22 per weight.
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

}  // namespace warplut
