// Linear HDR images to and from the codes that they are warped and blended in
// (runtime/color_encoding.h).
#pragma once

#include "runtime/image_view.h"

namespace warplut::generation {

// Row y of `linear` (RGBA8, RGBA16F or RGBA32F), limited as LimitHdr does, as codes into that of
// `to` (RGBA32F); alpha is 1.
void EncodeHdrRowReference(const ImageView& linear, int y, const MutableImageView& to);

// And back, codes limited to [0, 1] first, into any format.
void DecodeHdrRowReference(const ImageView& codes, int y, const MutableImageView& to);

// Limits row y of `warped` (RGBA32F), which `motion` made of `codes`: no channel is more than the
// greatest of its 4 x 4 texels, unless it is at most the code of kUnlimitedHdr.
void LimitHdrRow(const ImageView& codes, const MotionView& motion, int y,
                 const MutableImageView& warped);

}  // namespace warplut::generation
