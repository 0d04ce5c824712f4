// Selects the shown frames that a method is judged by.
#pragma once

#include <vector>

#include "train/replay/mode_run.h"

namespace warplut {

// Methods that generate are judged by their generated frames, the others by all but the first,
// which has no history; in both cases by those at the time of a frame of the clip.
bool IsJudged(const MethodInfo& method, const ShownFrame& shown);

// The indices in the clip of the frames that RunMode will show and that are judged, ascending.
// Options must be valid.
std::vector<int> JudgedFrames(const Clip& clip, const ModeRunOptions& options);

}  // namespace warplut
