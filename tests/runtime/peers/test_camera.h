// Cameras for tests of what is moved by them.
#pragma once

#include <array>
#include <cmath>

#include "runtime/motion/point_carrier.h"

namespace warplut {

// At `place`, turned to the right by `angle` (radians) from -z; 1.2 radians high.
inline CameraMatrices LookingCamera(const std::array<double, 3>& place, double angle, int width,
                                    int height) {
  const double c = std::cos(angle), s = std::sin(angle), f = 1 / std::tan(0.6);
  const auto [x, y, z] = place;
  CameraMatrices camera;
  camera.view = {c, 0, s, -(c * x + s * z), 0, 1, 0, -y, -s, 0, c, s * x - c * z, 0, 0, 0, 1};
  camera.projection = {f * height / width, 0, 0, 0, 0, f, 0, 0, 0, 0, -1.02, -0.2, 0, 0, -1, 0};
  return camera;
}

// Still objects, between two cameras.
inline Reprojection KnownCameras(const CameraMatrices& source, const CameraMatrices& generated,
                                 double depth_unit = 10) {
  Reprojection known;
  known.source = source;
  known.generated = generated;
  known.depth_unit = depth_unit;
  return known;
}

}  // namespace warplut
