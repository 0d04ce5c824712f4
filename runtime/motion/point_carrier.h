// Carries points of a frame to another one by their cameras.
//
// A point at pixel (x, y), counted from the centre of the first, with inverse depth g, is
// h = (x, y, 1, g) in homogeneous coordinates. A pinhole camera that moves maps it to
//   h' = (A (x, y, 1) + g b, g),  x' = h'_0 / h'_2,  y' = h'_1 / h'_2,  g' = g / h'_2.
// A point with h'_2 <= 0 is behind the other camera. Source: Hartley, Zisserman, "Multiple View
// Geometry", section 13.1 (plane and parallax).
#pragma once

#include <array>
#include <optional>

#include "runtime/reprojection.h"

namespace warplut {

// Columns 0 to 2 are A, column 3 is b; row-major, of three rows.
struct PointMap {
  std::array<float, 12> m{};

  struct Point {
    float x, y, w;  // x and y are those of a pixel where w > 0; depth is multiplied by w
  };
  // Each sum in this order, without fused operations: the vector kernels have it too.
  Point Apply(float x, float y, float g) const {
    const auto row = [&](std::size_t r) {
      return (m[4 * r] * x + m[4 * r + 1] * y) + (m[4 * r + 2] + m[4 * r + 3] * g);
    };
    const float w = row(2);
    return {row(0) / w, row(1) / w, w};
  }
};

// From frame 1 to the generated frame, and back.
struct PointCarrier {
  PointMap forward, backward;

  // Frames of width x height pixels. Nothing where the cameras or the unit are not valid.
  static std::optional<PointCarrier> Of(const Reprojection& reprojection, int width, int height);
};

}  // namespace warplut
