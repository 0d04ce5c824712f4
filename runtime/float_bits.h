// Whether floats are numbers, by their bits: comparisons say what they like where a program is
// compiled with -ffast-math.
#pragma once

#include <bit>
#include <cstdint>

#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

constexpr bool IsFinite(float x) {
  return (std::bit_cast<std::uint32_t>(x) & 0x7FFFFFFFu) < 0x7F800000u;
}
constexpr bool IsNan(float x) {
  return (std::bit_cast<std::uint32_t>(x) & 0x7FFFFFFFu) > 0x7F800000u;
}
constexpr bool IsNan(double x) {
  return (std::bit_cast<std::uint64_t>(x) & ~(std::uint64_t{1} << 63)) > std::uint64_t{0x7FF} << 52;
}
// Derivative types and others: whose comparisons are what they are.
template <class T>
constexpr bool IsNan(const T&) {
  return false;
}

}  // namespace warplut
