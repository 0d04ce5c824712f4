// Rounding that keeps a sum: integers near given numbers whose weighted sum is exactly what it must
// be.
#pragma once

#include <cstdint>
#include <vector>

namespace warplut {

// A number to round; it stands for `count` equal ones (weights that a symmetry makes equal).
struct RoundingTerm {
  double value = 0;
  int count = 1;
  std::int32_t rounded = 0;  // result
};

// The integers that a term may become: those in [least, most], above `even_above` in magnitude only
// even ones.
struct RoundingGrid {
  std::int32_t least = 0;
  std::int32_t most = 0;
  std::int32_t even_above = 0;

  bool Has(std::int32_t q) const {
    return q >= least && q <= most && ((q >= -even_above && q <= even_above) || q % 2 == 0);
  }
};

// How far a term may move from its nearest integer.
inline constexpr int kMaxRoundingStep = 2;

// Sets `rounded` so that the sum of count * rounded is `total` and the sum of
// count * |rounded - value| is least among integers within kMaxRoundingStep of the nearest ones.
// Exact, by dynamic programming over the terms; among equals the choice is fixed. Returns false,
// with nothing set, where no such integers exist.
bool RoundToSum(std::int32_t total, const RoundingGrid& grid, std::vector<RoundingTerm>* terms);

}  // namespace warplut
