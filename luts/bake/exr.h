// OpenEXR bytes that depend on the pixels alone.
#pragma once

#include <string>

#include "datasets/image.h"

namespace warplut {

// A single-channel image (channel Y, 32-bit float) as an OpenEXR 2 file: scan lines in increasing
// order, without compression, the required attributes and no others, so that no library version,
// clock or machine leaves a trace. Source: "The OpenEXR File Layout", OpenEXR documentation.
std::string EncodeExr(const Image& image);

}  // namespace warplut
