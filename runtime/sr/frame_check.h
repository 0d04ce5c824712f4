// Whether a frame fits the options.
#pragma once

#include <string>

#include "runtime/super_resolution.h"

namespace warplut {

// SuperResolution::IsProcessable for these options.
bool IsFrameProcessable(const SuperResolutionOptions& options, const RenderedFrame& frame,
                        const MutableImageView& out, std::string* why);

}  // namespace warplut
