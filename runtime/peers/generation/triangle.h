// Triangles of a mesh that is drawn into the generated frame: which pixels they cover, and what is
// interpolated between their corners.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "runtime/peers/generation/linear_motion.h"

namespace warplut::peers {

// Pixels whose float index of a displacement fits 31 bits: what vectors gather.
inline constexpr std::int64_t kMostGathered = std::int64_t{1} << 29;

// Corners of a triangle, around q, and what is interpolated between them.
struct Triangle {
  Vector a, b, c;

  // Weights of the corners, times twice the area; false where q is outside.
  struct Weights {
    float a, b, c, area;
    bool inside;
  };
  Weights At() const {
    const float wa = b.x * c.y - b.y * c.x;
    const float wb = c.x * a.y - c.y * a.x;
    const float wc = a.x * b.y - a.y * b.x;
    const float area = wa + wb + wc;
    const bool front = wa >= 0 && wb >= 0 && wc >= 0 && area > 0;
    const bool back = wa <= 0 && wb <= 0 && wc <= 0 && area < 0;
    return {wa, wb, wc, area, front || back};
  }
};

// The pixels at the corners of a triangle, counted from the quad's upper left one.
struct TriangleCorners {
  PixelIndex a, b, c;
};
constexpr TriangleCorners CornersOf(bool lower) {
  return lower ? TriangleCorners{{1, 1}, {0, 1}, {1, 0}} : TriangleCorners{{0, 0}, {1, 0}, {0, 1}};
}

// The columns of row y, in [0, width), beyond which the triangle of these corners has no pixel
// centre; last < first where it has none. Wider than the triangle by at most two pixels at each
// end, so that the rounding of its edges leaves nothing out: Triangle::At decides.
struct ColumnRange {
  int first, last;
};
inline ColumnRange ColumnsOf(Vector a, Vector b, Vector c, int y, int width) {
  const auto row = static_cast<float>(y);
  float left = static_cast<float>(width), right = -1;
  const auto cut = [&](Vector from, Vector to) {
    if (std::min(from.y, to.y) > row || std::max(from.y, to.y) < row) return;
    const float rise = to.y - from.y;
    const float share = rise == 0 ? 0 : std::clamp((row - from.y) / rise, 0.0f, 1.0f);
    const float x = from.x + share * (to.x - from.x);
    left = std::min(left, rise == 0 ? std::min(from.x, to.x) : x);
    right = std::max(right, rise == 0 ? std::max(from.x, to.x) : x);
  };
  cut(a, b);
  cut(b, c);
  cut(c, a);
  if (right < left) return {0, -1};
  const auto end = static_cast<float>(width - 1);
  return {static_cast<int>(std::clamp(std::floor(left) - 1, 0.0f, end + 1)),
          static_cast<int>(std::clamp(std::ceil(right) + 1, -1.0f, end))};
}

}  // namespace warplut::peers
