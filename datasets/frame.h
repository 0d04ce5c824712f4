// One frame of a sequence in the one convention of this project. Everything else is converted at
// the edge.
#pragma once

#include <array>
#include <optional>

#include "datasets/image.h"

namespace warplut {

struct Vec2 {
  double x = 0;
  double y = 0;
};

// Camera matrices, row-major, acting on column vectors; NDC as OpenGL
// (x right, y up, z in [-1, 1]).
struct Camera {
  std::array<double, 16> view{};
  std::array<double, 16> projection{};
};

// Streams that a sequence lacks are empty images.
//   color, reference  RGB: what the display gets, [0, 1], or linear HDR where the sequence says so:
//                     any number, infinity too.
//   depth             1 channel: view depth divided by the far plane, 0 at the camera, 1 at far;
//                     background +1 or +infinity.
//   motion            2 channels x, y: displacement in pixels of its own grid, from frame f-1 to
//                     frame f, of what is seen at the pixel; y down. The previous position is
//                     p - m. No jitter in it.
//   reactive          1 channel: from 0, history is trusted as without it, to 1, there is none.
//   hud               4 channels R, G, B, alpha: what is drawn over the frame on the output grid,
//                     in the encoding of the colour, premultiplied by alpha.
//   alpha             1 channel: how much of the pixel the colour covers, 0 to 1. Colour is
//                     premultiplied by it. reference_alpha likewise.
//   jitter            LR pixel (i, j) shows what projects, unjittered, to
//                     (i + 0.5 + x, j + 0.5 + y).
struct Frame {
  int number = 0;                                      // as in the file names
  bool cut = false;                                    // shares nothing with the frame before
  Image color, depth, motion;                          // render grid (LR)
  Image reference, reference_depth, reference_motion;  // output grid (HR)
  Image reactive;                                      // render grid
  Image hud;                                           // output grid
  Image alpha;                                         // render grid
  Image reference_alpha;                               // output grid
  Vec2 jitter;
  std::optional<Camera> camera;
};

}  // namespace warplut
