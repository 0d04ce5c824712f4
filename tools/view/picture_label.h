// Pictures with a line of text above them, and smaller ones.
#pragma once

#include <string>

#include "datasets/image.h"

namespace warplut {

inline constexpr int kLabelHeight = 22;  // pixels

// The picture (3 channels) below a strip of kLabelHeight with the text, cut where it is too long.
// Letters beyond ASCII are shown as question marks.
Image Labelled(const Image& picture, const std::string& text);

// The picture (3 channels) with at most `width` pixels in a row, averaged over areas.
Image AtMostWide(const Image& picture, int width);

}  // namespace warplut
