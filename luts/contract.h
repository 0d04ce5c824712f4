// The LUT contract: the layout that trainer, baker and kernel agree on, and all that they share.
//
// A table holds, for each of 32 x 32 sub-pixel offsets, one weight for each tap of its footprint.
//   offset     d = (dx, dy) in [0, 1)^2: the fraction of the sampled position, from the upper-left
//              texel centre of the 2 x 2 cell that contains it; x right, y down.
//   taps       whole texels, counted from that texel. All lie in the window: -2..3 in each axis.
//   footprint  which taps of the window there are: 16 are the 4 x 4 square -1..2 (the default), 24
//              add to it two more on each side, the central ones, and 36 are the whole window.
//   nodes      offset i / 32 for i = 0..31 in each axis. Node 32 is node 0 of the next texel, so
//              that 0 and 1/2 are nodes.
//   rows       (jy * 32 + ix) * taps + k: dy slowest, dx next, weight fastest. The weights of a row
//              are those of the footprint's taps, row by row of the window, x fastest.
// Every row sums to exactly 1 in its own fixed point. Without prefilter row (0, 0) is exactly the
// identity; a node with dx = 0 has weights only in the column of tap 0 and one with dy = 0 only in
// the row of tap 0, so that the weights are continuous from each cell to the next.
//
// A table of 16 taps may have a prefilter (luts/prefilter.h): it then weighs coefficients in place
// of samples. Row (0, 0) holds the products of (s, 1 - 2 s, s, 0), s the prefilter's side, within
// WholeOffsetTolerance; a node with dx = 0 has no weight in the column of tap 2 and equal ones in
// those of the taps -1 and 1, one with dy = 0 none in the row of tap 2 and equal ones in the rows
// of the taps -1 and 1.
// Source: Mob-FGSR (SIGGRAPH 2024), section 4 "Learning LUT"; the node positions and the larger
// footprints are ours.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "luts/prefilter.h"
#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

inline constexpr int kNodes = 32;              // nodes per axis
inline constexpr int kRows = kNodes * kNodes;  // rows of a table
static_assert(kNodes % 2 == 0, "one half must be a node");

// The taps of one axis of the default footprint and of every closed-form filter.
inline constexpr int kTaps = 4;
inline constexpr int kFirstTap = -1;

// The window. Weights in memory are those of a window, 0 where the footprint has no tap.
inline constexpr int kWindowTaps = 6;  // taps per axis
inline constexpr int kFirstWindowTap = -2;
inline constexpr int kWeights = kWindowTaps * kWindowTaps;

constexpr int WeightIndex(int kx, int ky) { return ky * kWindowTaps + kx; }
constexpr int TapX(int k) { return k % kWindowTaps + kFirstWindowTap; }
constexpr int TapY(int k) { return k / kWindowTaps + kFirstWindowTap; }
// The weight of tap (x, y).
constexpr int TapWeight(int x, int y) {
  return WeightIndex(x - kFirstWindowTap, y - kFirstWindowTap);
}
inline constexpr int kIdentityWeight = TapWeight(0, 0);

constexpr int RowIndex(int ix, int jy) { return jy * kNodes + ix; }
constexpr double NodeOffset(int i) { return static_cast<double>(i) / kNodes; }

template <class T>
using Weights = std::array<T, kWeights>;

enum class Footprint : std::uint8_t { k16, k24, k36 };

inline constexpr std::array<Footprint, 3> kFootprints = {Footprint::k16, Footprint::k24,
                                                         Footprint::k36};

// Whether tap (x, y) of the window belongs to the footprint.
constexpr bool HasTap(Footprint footprint, int x, int y) {
  constexpr int kLastTap = kFirstTap + kTaps - 1;
  const bool inner_x = x >= kFirstTap && x <= kLastTap;
  const bool inner_y = y >= kFirstTap && y <= kLastTap;
  const bool central_x = x == 0 || x == 1;
  const bool central_y = y == 0 || y == 1;
  switch (footprint) {
    case Footprint::k16:
      return inner_x && inner_y;
    case Footprint::k24:
      return (inner_x && inner_y) || central_x || central_y;
    case Footprint::k36:
      return true;
  }
  return false;
}

// The taps of a footprint in the order of a table's rows, each as its weight of the window.
struct FootprintTaps {
  std::array<int, kWeights> weights{};
  int count = 0;

  constexpr explicit FootprintTaps(Footprint footprint) {
    for (int k = 0; k < kWeights; ++k) {
      if (HasTap(footprint, TapX(k), TapY(k))) {
        weights[static_cast<std::size_t>(count++)] = k;
      }
    }
  }

  constexpr const int* begin() const { return weights.data(); }
  constexpr const int* end() const { return weights.data() + count; }
  constexpr int operator[](int i) const { return weights[static_cast<std::size_t>(i)]; }
};

inline constexpr std::array<FootprintTaps, kFootprints.size()> kFootprintTaps = {
    FootprintTaps(Footprint::k16), FootprintTaps(Footprint::k24), FootprintTaps(Footprint::k36)};

constexpr const FootprintTaps& TapsOf(Footprint footprint) {
  return kFootprintTaps[static_cast<std::size_t>(footprint)];
}
constexpr int TapCount(Footprint footprint) { return TapsOf(footprint).count; }

// The taps per axis of the least square that holds the footprint, and its first one.
constexpr int AxisTaps(Footprint footprint) {
  return footprint == Footprint::k16 ? kTaps : kWindowTaps;
}
constexpr int FirstAxisTap(Footprint footprint) {
  return footprint == Footprint::k16 ? kFirstTap : kFirstWindowTap;
}

// Numbers in a table.
constexpr int TableValues(Footprint footprint) { return kRows * TapCount(footprint); }
inline constexpr int kTableValues = TableValues(Footprint::k16);

static_assert(TapCount(Footprint::k16) == 16 && TapCount(Footprint::k24) == 24 &&
              TapCount(Footprint::k36) == 36);
static_assert(kTableValues == 32 * 32 * 16);

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

// A baked table: TableValues(footprint) weights in `format`. `data` is int16_t, uint16_t (bits of a
// half), int8_t or float, and stays owned by whoever made it (a baked header has static storage).
struct TableView {
  TableFormat format = TableFormat::kI16;
  const void* data = nullptr;
  Prefilter prefilter = {};  // of the image, before the table reads it; none but with 16 taps
  Footprint footprint = Footprint::k16;
};

}  // namespace warplut
