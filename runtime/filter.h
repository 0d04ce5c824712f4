// The filters that a warp can use: one registry that tests, benchmarks and the command line walk.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace warplut {

enum class Filter : std::uint8_t { kBilinear, kCatmullRom, kKeys, kLut };

struct FilterInfo {
  Filter filter;
  const char* name;
  int taps;          // per axis
  bool needs_a;      // takes the Keys parameter
  bool needs_table;  // takes a table and a lookup
};

inline constexpr std::array<FilterInfo, 4> kFilters = {{
    {Filter::kBilinear, "bilinear", 2, false, false},
    {Filter::kCatmullRom, "catmull-rom", 4, false, false},
    {Filter::kKeys, "keys", 4, true, false},
    {Filter::kLut, "lut", 4, false, true},
}};

constexpr const FilterInfo& Info(Filter filter) {
  return kFilters[static_cast<std::size_t>(filter)];
}

static_assert([] {
  for (const FilterInfo& info : kFilters) {
    if (&Info(info.filter) != &info) return false;
  }
  return true;
}());

}  // namespace warplut
