// Footprints by their number of taps, as people and files name them.
#pragma once

#include <optional>
#include <string>

#include "luts/contract.h"

namespace warplut {

// The footprint of so many taps.
constexpr std::optional<Footprint> FootprintWith(int taps) {
  for (const Footprint footprint : kFootprints) {
    if (TapCount(footprint) == taps) return footprint;
  }
  return std::nullopt;
}

// "16, 24 or 36".
inline std::string FootprintNames() {
  std::string names;
  for (const Footprint footprint : kFootprints) {
    if (!names.empty()) names += footprint == kFootprints.back() ? " or " : ", ";
    names += std::to_string(TapCount(footprint));
  }
  return names;
}

}  // namespace warplut
