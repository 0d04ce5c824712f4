// The nodes that are left when the 8 symmetries are divided out: 0 <= j <= i <= 16, 153 of 1024.
// The weights of every other node are those of one of these, with the taps permuted.
#pragma once

#include <algorithm>
#include <array>

#include "luts/contract.h"
#include "luts/fit/symmetry.h"

namespace warplut {

inline constexpr int kHalfNode = kNodes / 2;
inline constexpr int kCanonicalNodes = (kHalfNode + 1) * (kHalfNode + 2) / 2;
static_assert(kCanonicalNodes == 153);

// The canonical node of node (ix, jy), 0..kNodes, and the symmetry that maps the node to it.
struct CanonicalNode {
  int index = 0;
  int symmetry = 0;
};

constexpr CanonicalNode ToCanonical(int ix, int jy) {
  const bool flip_x = ix > kHalfNode;
  const bool flip_y = jy > kHalfNode;
  const int x = flip_x ? kNodes - ix : ix;
  const int y = flip_y ? kNodes - jy : jy;
  const bool transpose = y > x;
  const int i = std::max(x, y);
  const int j = std::min(x, y);
  return {i * (i + 1) / 2 + j, (flip_x ? 1 : 0) | (flip_y ? 2 : 0) | (transpose ? 4 : 0)};
}

// The node (ix, jy) of a canonical index.
constexpr std::array<int, 2> CanonicalPosition(int index) {
  int i = 0;
  while ((i + 1) * (i + 2) / 2 <= index) ++i;
  return {i, index - i * (i + 1) / 2};
}

// The weights of the canonical nodes.
template <class T>
using CanonicalWeights = std::array<Weights<T>, kCanonicalNodes>;

}  // namespace warplut
