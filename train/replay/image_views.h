// Images of the offline tools as buffers of the runtime, and back.
#pragma once

#include "datasets/image.h"
#include "runtime/image_buffer.h"

namespace warplut {

// An image of 3 channels in an RGBA format, alpha 1, or of 1 channel in kR32F. 8-bit codes and
// halves are rounded to nearest; an image that came from an 8-bit file is the same codes.
ImageBuffer ToBuffer(const Image& image, PixelFormat format);

// Motion of 2 channels.
MotionBuffer ToMotionBuffer(const Image& motion);

// R, G, B of an RGBA view (codes divided by 255), or the 1 channel of kR32F.
Image ToImage(const ImageView& view);

Image ToImage(const MotionView& view);

// Copies pixels; both of one size and format.
void CopyPixels(const ImageView& from, const MutableImageView& to);
void CopyMotion(const MotionView& from, const MutableMotionView& to);

}  // namespace warplut
