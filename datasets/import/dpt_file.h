// Depth in the .dpt format of MPI Sintel, which image libraries do not read.
// Source: the depth data of the MPI Sintel dataset (Butler et al., ECCV 2012), and its sdk.
#pragma once

#include <filesystem>

#include "datasets/image.h"

namespace warplut {

// The bytes "PIEH", width and height (int32), then a float32 view depth for each pixel, row by row
// from the top; all little-endian. Errors: missing, not this format, of another length than its
// size says, a side outside 1 to kMaxImageSide.
Image ReadDpt(const std::filesystem::path& path);

}  // namespace warplut
