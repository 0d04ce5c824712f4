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

// The sentence why the two do not go together: a prefilter belongs to 16 taps. "" if they do.
inline std::string FootprintFault(Footprint footprint, const Prefilter& prefilter) {
  if (footprint == Footprint::k16 || !HasPrefilter(prefilter)) return "";
  return "has " + std::to_string(TapCount(footprint)) +
         " taps and a prefilter; expected none but with " +
         std::to_string(TapCount(Footprint::k16)) + " taps";
}

}  // namespace warplut
