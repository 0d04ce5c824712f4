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

// How far a term may move from its nearest integer.
inline constexpr int kMaxRoundingStep = 2;

// The integers that a term may become: those in [least, most]. As a float of so many digits has
// them: above `even_above` in magnitude only even ones, above twice that only multiples of 4, and
// so on.
struct RoundingGrid {
  std::int32_t least = 0;
  std::int32_t most = 0;
  std::int32_t even_above = 0;  // more than 0
  int most_step = kMaxRoundingStep;

  bool Has(std::int32_t q) const {
    std::int64_t unit = 1;
    while (q < -even_above * unit || q > even_above * unit) unit *= 2;
    return q >= least && q <= most && q % unit == 0;
  }
};

// Sets `rounded` so that the sum of count * rounded is `total` and the sum of
// count * |rounded - value| is least among integers within grid.most_step of the nearest ones.
// Exact, by dynamic programming over the terms; among equals the choice is fixed. Returns false,
// with nothing set, where no such integers exist.
bool RoundToSum(std::int32_t total, const RoundingGrid& grid, std::vector<RoundingTerm>* terms);

}  // namespace warplut
