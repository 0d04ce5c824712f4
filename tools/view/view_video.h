// A video of both sources, by the program ffmpeg where it is installed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "tools/view/viewed_frames.h"

namespace warplut {

// Whether ffmpeg is in PATH and runs.
bool HasVideoProgram();

// Writes `file` (.mp4, H.264), atomically: for each moment both sources side by side, the errors
// below them, labelled. `rate`: frames per second. `on_frame` is called before each frame and may
// throw. Frames lie in a folder beside `file` meanwhile, which is removed in any case. Returns a
// sentence that says why there is no video; empty if there is.
std::string WriteVideo(const ViewedFrames& frames, double amplify, double rate,
                       const std::filesystem::path& file, const std::function<void()>& on_frame);

}  // namespace warplut
