// The filters that a warp can use: one registry that tests, benchmarks and the command line walk.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

enum class Filter : std::uint8_t { kBilinear, kCatmullRom, kKeys, kLut, kSpline };

struct FilterInfo {
  Filter filter;
  const char* name;
  int taps;          // per axis; a table may have more (luts/contract.h)
  bool needs_a;      // takes the Keys parameter
  bool needs_table;  // takes a table and a lookup
  bool needs_k;      // takes the spline parameter, and reads coefficients (luts/prefilter.h)
};

inline constexpr std::array<FilterInfo, 5> kFilters = {{
    {Filter::kBilinear, "bilinear", 2, false, false, false},
    {Filter::kCatmullRom, "catmull-rom", 4, false, false, false},
    {Filter::kKeys, "keys", 4, true, false, false},
    {Filter::kLut, "lut", 4, false, true, false},
    {Filter::kSpline, "spline", 4, false, false, true},
}};

constexpr const FilterInfo& Info(Filter filter) {
  return kFilters[static_cast<std::size_t>(filter)];
}

// Whether the filter can read coefficients: a table may have a prefilter.
constexpr bool MayHavePrefilter(Filter filter) {
  return Info(filter).needs_k || Info(filter).needs_table;
}

static_assert([] {
  for (const FilterInfo& info : kFilters) {
    if (&Info(info.filter) != &info) return false;
  }
  return true;
}());

}  // namespace warplut
