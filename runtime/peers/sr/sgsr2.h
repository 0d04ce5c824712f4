// The two passes of SGSR 2 (docs/METHODS.md): its numbers, and its kernel.
#pragma once

#include <algorithm>

namespace warplut::peers {

inline constexpr float kSgsr2Slack = 0.05f;        // of the range that samples are limited to
inline constexpr float kSgsr2StillKept = 0.3f;     // of history out of range where nothing moves
inline constexpr float kSgsr2StillMotion = 1e-6f;  // output pixels

// Lanczos' kernel of two lobes of t = (d bias / 2)^2, as the polynomial (3/4 u + u^2) u^2 in
// u = t - 1 for t in [0, 1]; 1/4 at its centre.
inline float Sgsr2Kernel(float t) {
  const float u = std::min(t, 1.0f) - 1;
  const float square = u * u;
  return (0.75f * u + square) * square;
}

}  // namespace warplut::peers
