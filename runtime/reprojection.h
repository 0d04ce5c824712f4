// What a renderer knows of a frame before it is rendered: its camera, and the objects that it draws
// anew. Mesh projection (kMeshProjection) moves what stands still by it.
#pragma once

#include <array>
#include <string>

#include "luts/visibility.h"
#include "runtime/image_view.h"

namespace WARPLUT_PUBLIC warplut {

// Row-major, acting on column vectors. The view leads from the scene to the space of the camera: x
// right, y up, -z forward, a rotation and a shift. The projection leads from there to clip space, x
// right, y up, w = view depth. Without jitter.
struct CameraMatrices {
  std::array<double, 16> view{};
  std::array<double, 16> projection{};

  // Whether the projection is perspective, as above, and the view a rotation and a shift, within
  // 1e-3; otherwise *why (if not null) says what it is.
  bool IsValid(std::string* why = nullptr) const;
};

// The camera at `time`, where `from` is that at 0 and `to` that at 1; other times go on. The place
// moves and the matrix of the projection changes uniformly; the view turns uniformly about one
// axis, by less than half a turn. Both cameras must be valid.
CameraMatrices CameraBetween(const CameraMatrices& from, const CameraMatrices& to, double time);

// For one generated frame. Views without data stand for nothing.
struct Reprojection {
  CameraMatrices source;     // of frame 1
  CameraMatrices generated;  // of the generated frame
  double depth_unit = 1;     // of depth 1 of frame 1, in units of the matrices; > 0
  // R32F on the grid of the frames: not 0 where frame 1 shows an object that moves. These pixels
  // are not shown again; what is behind them is taken from the nearest pixel of their row that
  // stands still, the farther one of both sides.
  ImageView moving;
  // Colour on the same grid, encoded as the frames' colours: what was rendered anew, over the rest
  // by its alpha (0 to 1 or 0 to 255). A renderer leaves it 0 where the object is hidden.
  ImageView drawn;
};

// The least number of pixels that a frame needs beyond each of its borders, so that all that the
// generated frame shows inside of them is in frame 1: the largest distance, in pixels, by which the
// camera moves a point of the border of a frame of width x height pixels, at the depth `nearest` or
// farther. `source` and `generated` are valid; nearest > 0, in units of depth. kMostOverscan where
// a point of the border was behind the camera.
// Source: Qi, 144FPS Rendering on Mobile, SIGGRAPH 2024.
inline constexpr int kMostOverscan = 4096;
int Overscan(const Reprojection& reprojection, int width, int height, double nearest);

}  // namespace warplut
