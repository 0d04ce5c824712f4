// The frames that two methods make of a sequence, as files.
#pragma once

#include <filesystem>

#include "tools/view/view_request.h"
#include "tools/view/viewed_frames.h"

namespace warplut {

// Runs both methods of the request over its sequence and writes the frames that both are judged by,
// as displayed, with 8 bits: FOLDER/METHOD/NUMBER.png, and FOLDER/reference/NUMBER.png where a
// frame has a reference. Each file is written atomically. Errors as Pipeline, LoadClip and RunMode;
// no frame is common to both; an interruption.
ViewedFrames FramesOfMethods(const ViewRequest& request, const std::filesystem::path& folder);

}  // namespace warplut
