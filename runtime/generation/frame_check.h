// Whether frames fit the options.
#pragma once

#include <string>

#include "runtime/frame_generation.h"

namespace warplut {

// FrameGeneration::IsGenerable for these options.
bool AreGenerable(const FrameGenerationOptions& options, const DisplayedFrame& frame0,
                  const DisplayedFrame& frame1, float alpha, const MutableImageView& out,
                  std::string* why);

}  // namespace warplut
