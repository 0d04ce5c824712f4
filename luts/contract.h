// The LUT contract: the layout that trainer, baker and kernel agree on, and all that they share.
//
// A table holds, for each of 32 x 32 sub-pixel offsets, the 16 weights of a 4 x 4 neighbourhood.
//   offset   d = (dx, dy) in [0, 1)^2: the fraction of the sampled position, from the upper-left
//            texel centre of the 2 x 2 cell that contains it; x right, y down.
//   taps     -1, 0, 1, 2 in each axis, counted from that texel.
//   weights  k = 4 * ky + kx with kx, ky = 0..3 for the taps -1..2 (x fastest).
//   nodes    offset i / 32 for i = 0..31 in each axis. Node 32 is node 0 of the next texel, so that
//            0 and 1/2 are nodes.
//   rows     ((jy * 32) + ix) * 16 + k: dy slowest, dx next, weight fastest.
// Every row sums to exactly 1 in its own fixed point. Without prefilter row (0, 0) is exactly the
// identity; a node with dx = 0 has weights only in column kx = 1 and one with dy = 0 only in row
// ky = 1, so that the weights are continuous from each cell to the next.
//
// A table may have a prefilter (luts/prefilter.h): it then weighs coefficients in place of samples.
// Row (0, 0) holds the products of (s, 1 - 2 s, s, 0), s the prefilter's side, within
// WholeOffsetTolerance; a node with dx = 0 has no weight in column kx = 3 and equal ones in the
// columns 0 and 2, one with dy = 0 none in row ky = 3 and equal ones in the rows 0 and 2.
// Source: Mob-FGSR (SIGGRAPH 2024), section 4 "Learning LUT"; the node positions are ours.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "luts/prefilter.h"
#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

inline constexpr int kNodes = 32;                                       // nodes per axis
inline constexpr int kTaps = 4;                                         // taps per axis
inline constexpr int kFirstTap = -1;                                    // tap of kx = 0
inline constexpr int kWeights = kTaps * kTaps;                          // weights per node
inline constexpr int kRows = kNodes * kNodes;                           // rows of a table
inline constexpr int kTableValues = kRows * kWeights;                   // numbers in a table
inline constexpr int kIdentityWeight = -kFirstTap * kTaps - kFirstTap;  // weight of tap (0, 0)

static_assert(kNodes % 2 == 0, "one half must be a node");
static_assert(kTableValues == 32 * 32 * 16);
static_assert(kIdentityWeight == 5);

constexpr int WeightIndex(int kx, int ky) { return ky * kTaps + kx; }
constexpr int TapX(int k) { return k % kTaps + kFirstTap; }
constexpr int TapY(int k) { return k / kTaps + kFirstTap; }
constexpr int RowIndex(int ix, int jy) { return jy * kNodes + ix; }
constexpr double NodeOffset(int i) { return static_cast<double>(i) / kNodes; }

template <class T>
using Weights = std::array<T, kWeights>;

// How a table stores its weights: integers q of a grid, weight = q / 2^FractionBits, in [-2, 2) in
// every format.
//   i16  int16 q, 14 fraction bits.
//   f16  IEEE half, a multiple of 2^-11 (of 2^-10 above 1 in magnitude).
//   i8   int8 q, 6 fraction bits.
//   f32  float, a multiple of 2^-22.
enum class TableFormat : std::uint8_t { kI16, kF16, kI8, kF32 };

constexpr int FractionBits(TableFormat format) {
  switch (format) {
    case TableFormat::kI16:
      return 14;
    case TableFormat::kF16:
      return 11;
    case TableFormat::kI8:
      return 6;
    case TableFormat::kF32:
      return 22;
  }
  return 0;
}

constexpr const char* Name(TableFormat format) {
  switch (format) {
    case TableFormat::kI16:
      return "i16";
    case TableFormat::kF16:
      return "f16";
    case TableFormat::kI8:
      return "i8";
    case TableFormat::kF32:
      return "f32";
  }
  return "";
}

constexpr std::size_t BytesPerWeight(TableFormat format) {
  return format == TableFormat::kF32 ? 4 : format == TableFormat::kI8 ? 1 : 2;
}

// How far a weight of row (0, 0) of a table with prefilter may be from the product of the side: two
// units of the format. The middle weight closes the sum for the other eight and may be twice as
// far.
constexpr double WholeOffsetTolerance(TableFormat format) {
  return 2.0 / (1 << FractionBits(format));
}

// A baked table: kTableValues weights in `format`. `data` is int16_t, uint16_t (bits of a half),
// int8_t or float, and stays owned by whoever made it (a baked header has static storage).
struct TableView {
  TableFormat format = TableFormat::kI16;
  const void* data = nullptr;
  Prefilter prefilter = {};  // of the image, before the table reads it
};

}  // namespace warplut
