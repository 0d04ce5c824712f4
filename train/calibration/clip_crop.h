// Smaller clips, where a whole one takes too long.
#pragma once

#include "train/replay/clip.h"

namespace warplut {

// The largest centred window of at most `max_pixels` output pixels whose borders lie between pixels
// of both grids, of all streams. Motion that leaves the window finds no history, as at the border
// of an image. 0 or a clip that is small enough: the clip itself. Error if no such window has
// kSsimWindow pixels a side, which some ratios of sizes cause.
Clip CropClip(Clip clip, int max_pixels);

}  // namespace warplut
