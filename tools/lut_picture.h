// A LUT as an image for the eye.
#pragma once

#include <span>

#include "datasets/image.h"
#include "luts/contract.h"

namespace warplut {

// Pixels per node and axis, and between tiles.
inline constexpr int kPictureZoom = 4;
inline constexpr int kPictureGap = 4;

// 4 x 4 tiles, one per tap (column = x tap, row = y tap); in a tile x = dx, y = dy, one square per node.
// White is 0, orange positive, blue negative; the colour deepens with the square root of |weight|, so that
// small lobes show. `rows` has kTableValues weights in the order of the contract. The result has 3 channels.
Image LutPicture(std::span<const float> rows);

}  // namespace warplut
