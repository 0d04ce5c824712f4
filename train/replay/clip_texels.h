// Rendered frames made from the reference: the other kind of low resolution, which published demos
// use.
#pragma once

#include "train/replay/clip.h"

namespace warplut {

// Replaces colour, depth, motion and jitter of every frame by texels of its reference. With s =
// output / render, a whole number in each axis, one texel of each s_x x s_y block is taken: the one
// nearest to the frame's jitter, k = floor(s (1/2 + jitter)), whose offset (k + 1/2) / s - 1/2
// becomes the jitter. A clip without jitter visits the texels of a block row by row, one a frame.
// Texels are resolved pixels of the output grid, not single samples: less aliased, and easier than
// what a renderer gives.
//
// Error if a reference stream was not loaded or a scale is not whole.
void TakeTexels(Clip& clip);

}  // namespace warplut
