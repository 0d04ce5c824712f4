// Rounding a table to its stored format, with row sums closed exactly.
#pragma once

#include <vector>

#include "luts/quantize/baked_table.h"
#include "luts/quantize/real_table.h"

namespace warplut {

// A table whose Asymmetry is at most this keeps the 8 symmetries of the square exactly when
// rounded.
inline constexpr double kSymmetryTolerance = 1e-9;

// How far from 1 a row sum, and from 0 a weight that the contract wants to be 0, may be before
// rounding.
inline constexpr double kClosureTolerance = 1e-9;

// Rounds each row to integers q of `format` (weight = q / 2^b, b = FractionBits) such that
//   - the row sums to exactly 2^b,
//   - the sum of |q - 2^b w| over the row is least among integers that do,
//   - weights that the contract wants to be 0 are 0, hence node (0, 0) without prefilter is the
//     identity;
//   - with a prefilter weights that mirror each other about a whole offset are equal.
// In a symmetric table one node of each orbit of the 8 symmetries is rounded and copied to the
// others; where a symmetry leaves a node in place, the taps that it exchanges are rounded together.
// Their numbers per group (1 and 2 on the axes and the diagonal, 4 and 8 at (1/2, 1/2)) divide 2^b
// or come with single taps, so that the sum always closes. An Error names the table, the node and
// what was found: a weight that is not finite or outside [-2, 2) after rounding, a sum away from 1
// or a weight away from 0 by more than kClosureTolerance. Returns (intervals + 1)^2 rows, as in
// RealTable.
std::vector<IntegerRow> RoundTable(const RealTable& table, TableFormat format);

// RoundTable of a table with kNodes intervals, as it is stored.
BakedTable Quantize(const RealTable& table, TableFormat format);

// Halves at full precision: multiples of 2^-kHalfFractionBits that a half holds, so that weights
// below 1/8 in magnitude have the unit of i16 and larger ones that of a half. Rows sum to exactly
// 1, in any order of adding in float: the error of the sum that rounding to halves makes is 0.
inline constexpr int kHalfFractionBits = 14;

// Quantize to such halves, in format f32. Each weight is within kMostHalfStep units of the exact
// one.
inline constexpr int kMostHalfStep = 8;
BakedTable QuantizeToHalves(const RealTable& table);

}  // namespace warplut
