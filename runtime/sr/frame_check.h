// Whether a frame fits the options.
#pragma once

#include <string>

#include "runtime/super_resolution.h"

namespace warplut {

// SuperResolution::IsProcessable for these options.
bool IsFrameProcessable(const SuperResolutionOptions& options, const RenderedFrame& frame,
                        const MutableImageView& out, std::string* why);

// SuperResolution::IsRenderSize for these options, of an object that was made for most_width x
// most_height.
bool IsRenderSizeOf(const SuperResolutionOptions& o, int width, int height, int most_width,
                    int most_height, std::string* why);

}  // namespace warplut
