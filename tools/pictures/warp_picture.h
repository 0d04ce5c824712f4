// What repeated warps do to an image, for the eye.
#pragma once

#include <span>

#include "tools/judge/images/warp_protocol.h"

namespace warplut {

// Sides of a panel in pixels, and what lies between two of them.
inline constexpr int kPanelSide = 320;
inline constexpr int kPanelGap = 8;

// Panels side by side at 1:1: the middle of `image` (1 or 3 channels), then what is left of it
// after the protocol's warps by each filter, along the same trajectory. 3 channels.
Image WarpPicture(const Image& image, std::span<const ProtocolFilter> filters,
                  const Protocol& protocol, std::uint64_t seed);

}  // namespace warplut
