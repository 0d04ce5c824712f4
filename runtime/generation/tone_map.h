// Linear HDR images to and from the tone-mapped form that they are warped and blended in.
#pragma once

#include "runtime/image_view.h"

namespace warplut::generation {

// Rows [first, last) of `linear` (RGBA8, RGBA16F or RGBA32F) tone-mapped into the same rows of `to` (RGBA32F). NaN, infinite and
// negative channels count as 0; alpha is 1.
void ToneMapRows(const ImageView& linear, int first, int last, const MutableImageView& to);

// And back, into any format; values are limited to [0, 1] first.
void InverseToneMapRows(const ImageView& mapped, int first, int last, const MutableImageView& to);

}  // namespace warplut::generation
