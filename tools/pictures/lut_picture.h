// A LUT as an image for the eye.
#pragma once

#include <vector>

#include "datasets/image.h"
#include "luts/contract.h"

namespace warplut {

// Pixels per node and axis, and between tiles.
inline constexpr int kPictureZoom = 4;
inline constexpr int kPictureGap = 4;

// Tiles of 4 x 4 or 6 x 6, one per tap (column = x tap, row = y tap); in a tile x = dx, y = dy, one
// square per node. White is 0, orange positive, blue negative; the colour deepens with the square
// root of |weight|, so that small lobes show. `rows` has the weights of the kRows nodes. The result
// has 3 channels and LutPictureSide pixels a side.
Image LutPicture(Footprint footprint, const std::vector<Weights<float>>& rows);
int LutPictureSide(Footprint footprint);

}  // namespace warplut
