// Images that ground truth is put into, and masks of pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "datasets/image.h"
#include "runtime/image_view.h"
#include "runtime/warp.h"

namespace warplut {

// One value per pixel, row by row; 0 is no.
using PixelMask = std::vector<std::uint8_t>;

// The image (R, G, B in [0, 1]) taken at p - m by the filter, limited to [0, 1].
Image WarpedImage(const Image& image, const MotionView& motion, const WarpOptions& filter);

// Copies the pixels of the mask from `from`; images of one size.
void CopyMasked(const Image& from, const PixelMask& mask, Image& to);

// The luma of `image` minus that of `reference`, averaged over those of the 5 x 5 pixels around
// each that are in the mask; 0 where none is. Errors of resampling nearly cancel in it, as every
// filter keeps the mean; a change of shading stays.
Image LocalLumaError(const Image& image, const Image& reference, const PixelMask& mask);

// A local luma error beyond this, five codes of eight bits, is a change of shading.
inline constexpr float kShadingChange = 0.02f;

// The best that blends of the two can do: at each pixel the colour on the segment from a to b, at
// the share (in [0, 1]) with the least squared distance from the reference over the
// (2 radius + 1)^2 pixels around it. Radius 0 lets every pixel choose for itself, and so fits
// noise; a larger one is what a rule could know that looks at more than one pixel.
Image BestBlend(const Image& a, const Image& b, const Image& reference, int radius);

// Takes from `from` the pixels around which (as above) it is nearer to the reference.
void TakeNearer(const Image& from, const Image& reference, int radius, Image& to);

}  // namespace warplut
