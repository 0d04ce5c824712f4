// A baked table made ready for lookup: floats, 33 x 33 nodes, so that bilinear lookup needs no wrap.
#pragma once

#include <cstdint>
#include <vector>

#include "luts/contract.h"

namespace warplut {

// How an offset becomes weights: the nearest node, or the bilinear mean of the four nodes around it.
enum class Lookup : std::uint8_t { kNearest, kBilinear };

constexpr const char* Name(Lookup lookup) {
  return lookup == Lookup::kNearest ? "nearest" : "bilinear";
}

class Table {
 public:
  // Decodes the table; `view.data` need not outlive the call. Rows of node 32 are those of node 0, one tap further
  // (the contract keeps the tap that would leave the window at zero).
  explicit Table(const TableView& view);

  // The weights for offset (dx, dy) in [0, 1): exactly those that every kernel uses.
  Weights<float> At(float dx, float dy, Lookup lookup) const;

  // 33 x 33 rows of 16 weights, dy slowest, 64-byte aligned rows.
  const float* data() const { return rows_; }

 private:
  std::vector<float> storage_;
  const float* rows_ = nullptr;
};

}  // namespace warplut
