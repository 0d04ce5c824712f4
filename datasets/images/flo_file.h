// Optical flow in the .flo format of the Middlebury benchmark, which image libraries do not read.
// Source: Baker et al., "A database and evaluation methodology for optical flow", IJCV 2011, and
// its flow-code.
#pragma once

#include <filesystem>

#include "datasets/images/image_io.h"

namespace warplut {

// A component of a larger magnitude says that the flow of its pixel is unknown.
inline constexpr float kFloUnknown = 1e9f;

// The bytes "PIEH", width and height (int32), then x and y (float32) of every pixel, row by row
// from the top; all little-endian. Two channels, X and Y, of 32-bit floats.
//
// Errors as ReadImageInfo and ReadImage: missing, not this format, of another length than its size
// says, a side outside 1 to kMaxImageSide.
ImageInfo ReadFloInfo(const std::filesystem::path& path);

// Both channels; NaN in both where one of them is NaN or beyond kFloUnknown.
Image ReadFlo(const std::filesystem::path& path);

}  // namespace warplut
