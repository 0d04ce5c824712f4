// Objects that move beside the camera, where the renderer tells which they are: what is behind them
// in frame 1, and what of them is drawn into the generated frame (runtime/reprojection.h).
#pragma once

#include <cstdint>

#include "runtime/image_view.h"

namespace warplut::generation {

// Frame 1 without what moves. `column` has the pixel of the same row that is shown in place of each
// one, row after row; null: all pixels stand still.
struct StillSurface {
  ImageView depth;
  const std::int32_t* column = nullptr;
};

// Row y of a still surface from the depth of frame 1 and `moving` (Reprojection::moving). A pixel
// that moves takes the next one to the left or to the right that stands still, the farther one, of
// equal depths the left one; a row that moves as a whole stays as it is.
void FindStillRow(const ImageView& depth, const ImageView& moving, int y,
                  const MutableImageView& still_depth, std::int32_t* column);

// Row y of `drawn` over that of `out`, by its alpha: out + alpha (drawn - out). `linear`: the
// colours are linear HDR, limited as LimitHdr does; else they are limited to [0, 1].
void DrawOverRow(const ImageView& drawn, bool linear, int y, const MutableImageView& out);

}  // namespace warplut::generation
