// Forward flow: motion that is stored at the pixels of the frame that it starts from.
#pragma once

#include "datasets/image.h"

namespace warplut {

// The motion of the frame that forward flow leads to, in this project's convention. `flow` has the
// channels x and y, pixels, y down: what is seen at pixel p of its frame is at p + flow(p) in the
// next; NaN: unknown. `depth` is that of the same frame, 1 channel, or empty.
//
// Each pixel is written to the pixels within 3/4 of a pixel of where it arrives; the least depth
// wins, without depth the nearest arrival. Holes, which are what the frame before did not show,
// take the motion of the farthest (without depth: the slowest) of the nearest pixels to the left,
// to the right, above and below. NaN where the whole flow is.
Image MotionOfForwardFlow(const Image& flow, const Image& depth);

}  // namespace warplut
