// Selects the shown frames that a method is judged by.
#pragma once

#include <vector>

#include "train/replay/mode_run.h"

namespace warplut {

// Methods that generate are judged by their generated frames, the others by all but the first,
// which has no history; in both cases by those at the time of a frame of the clip.
bool IsJudged(const MethodInfo& method, const ShownFrame& shown);

// The streams that judging the method needs of a sequence that has `available`: references with the
// depth and motion that they have; of generation from rendered frames those, which are judged by
// the rendered frames that it did not see. Where there is nothing to judge by, kReference, which
// loading then misses.
Streams JudgingStreams(const MethodInfo& method, Streams available);

// What a frame of the clip that is shown as width x height pixels is judged by: its reference if
// that has this size, else its rendered colour if that has; else an empty view. Beside it the depth
// and motion of that grid; empty views if one of them is not there.
struct TrueFrame {
  ImageView image;
  ImageView depth;
  MotionView motion;

  bool HasGeometry() const { return depth.width > 0; }
};
TrueFrame TrueFrameOf(const ClipFrame& frame, int width, int height);

// The indices in the clip of the frames that RunMode will show and that are judged, ascending.
// Options must be valid.
std::vector<int> JudgedFrames(const Clip& clip, const ModeRunOptions& options);

}  // namespace warplut
