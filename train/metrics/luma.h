// Luma: the one grey value that losses and metrics are computed on.
#pragma once

#include "datasets/image.h"
#include "luts/luma_weights.h"

namespace warplut {

// 0.2126 R + 0.7152 G + 0.0722 B of the values as stored (no transfer function is undone), as 1
// channel, computed in double. A 1-channel image is returned as it is; the alpha of a 4-channel one
// is ignored. Error for 2 channels or none.
Image Luma(const Image& image);

}  // namespace warplut
