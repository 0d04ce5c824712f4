// What arrives at a pixel of the generated frame, as one integer: of several the least is kept,
// whatever their order.
//
//   bits 63..32  depth: all bits of a float >= 0, whose order is that of the integers
//   bits 31..0   index of the source pixel, y * width + x: of equal depths the first in reading
//                order is kept
#pragma once

#include <bit>
#include <cstdint>

namespace warplut::generation {

using SplatKey = std::uint64_t;

inline constexpr SplatKey kNoSplat = ~SplatKey{0};

// depth in [0, kFarthestDepth], not -0.
constexpr SplatKey MakeSplatKey(float depth, std::uint32_t source) {
  return SplatKey{std::bit_cast<std::uint32_t>(depth)} << 32 | source;
}

constexpr std::uint32_t SplatSource(SplatKey key) { return static_cast<std::uint32_t>(key); }

// The depth that pixels without an arrival have: beyond all others.
inline constexpr float kNoArrivalDepth = 0x1.fffffep127f;

constexpr float SplatDepth(SplatKey key) {
  return key == kNoSplat ? kNoArrivalDepth
                         : std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32));
}

}  // namespace warplut::generation
