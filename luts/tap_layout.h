// The order of a footprint's taps in a decoded table: groups of four, each of which kernels load as
// one run of texels or as two pairs.
//
// Every row of taps gives runs of four from its left; what is left over are pairs, which make the
// last groups two by two. 16 taps are four runs, in the contract's order.
#pragma once

#include <array>

#include "luts/contract.h"
#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

inline constexpr int kGroupTaps = 4;

// Four taps: (x, y) and the three to its right, or two pairs of which each is a tap and the one to
// its right.
struct TapGroup {
  bool is_run = true;
  std::array<int, 2> x{}, y{};  // of the run, or of each pair
};

struct TapLayout {
  static constexpr int kMostGroups = kWeights / kGroupTaps;
  std::array<TapGroup, kMostGroups> groups{};
  int count = 0;

  constexpr explicit TapLayout(Footprint footprint) {
    std::array<std::array<int, 2>, kMostGroups * 2> pairs{};
    int pair_count = 0;
    for (int y = kFirstWindowTap; y < kFirstWindowTap + kWindowTaps; ++y) {
      int x = kFirstWindowTap;
      while (x < kFirstWindowTap + kWindowTaps) {
        if (!HasTap(footprint, x, y)) {
          ++x;
        } else if (x + kGroupTaps <= kFirstWindowTap + kWindowTaps &&
                   HasTap(footprint, x + kGroupTaps - 1, y)) {
          groups[static_cast<std::size_t>(count++)] = {true, {x, x}, {y, y}};
          x += kGroupTaps;
        } else {
          pairs[static_cast<std::size_t>(pair_count++)] = {x, y};
          x += 2;
        }
      }
    }
    for (int p = 0; p + 1 < pair_count; p += 2) {
      const auto& a = pairs[static_cast<std::size_t>(p)];
      const auto& b = pairs[static_cast<std::size_t>(p + 1)];
      groups[static_cast<std::size_t>(count++)] = {false, {a[0], b[0]}, {a[1], b[1]}};
    }
  }

  // The weight, of the window, at `place` of a row.
  constexpr int Weight(int place) const {
    const TapGroup& group = groups[static_cast<std::size_t>(place / kGroupTaps)];
    const int i = place % kGroupTaps;
    if (group.is_run) return TapWeight(group.x[0] + i, group.y[0]);
    const auto pair = static_cast<std::size_t>(i / 2);
    return TapWeight(group.x[pair] + i % 2, group.y[pair]);
  }
};

inline constexpr std::array<TapLayout, kFootprints.size()> kTapLayouts = {
    TapLayout(Footprint::k16), TapLayout(Footprint::k24), TapLayout(Footprint::k36)};

constexpr const TapLayout& LayoutOf(Footprint footprint) {
  return kTapLayouts[static_cast<std::size_t>(footprint)];
}

static_assert([] {
  for (const Footprint footprint : kFootprints) {
    if (LayoutOf(footprint).count * kGroupTaps != TapCount(footprint)) return false;
  }
  return true;
}());

// The numbers of a row of a decoded table: whole cache lines.
constexpr int RowFloats(Footprint footprint) { return (TapCount(footprint) + 15) / 16 * 16; }
inline constexpr int kMostRowFloats = RowFloats(Footprint::k36);

}  // namespace warplut
