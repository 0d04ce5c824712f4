// When two depths belong to one surface.
#pragma once

namespace warplut {

// Depths of one surface in two frames differ by at most this, relative to the lesser one.
inline constexpr double kSameSurface = 0.1;

}  // namespace warplut
