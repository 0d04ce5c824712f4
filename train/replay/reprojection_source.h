// What a renderer knows of a frame that it does not render, from a clip: cameras, and the objects
// that it draws anew (runtime/reprojection.h).
#pragma once

#include "runtime/method.h"
#include "train/replay/clip.h"

namespace warplut {

// Motion that is farther, in pixels and in either axis, from what the cameras give to a still
// surface is that of an object which moves.
inline constexpr float kUnexplainedMotion = 0.5f;

// The camera at `time`, in frames of the clip, whose frames 0, every, 2 every, ... are rendered.
//   kOfFrame   that of the clip's frame there, or between those of the frames around
//   kBetween   between those of the rendered frames around
// After the last frame that counts, the last two go on. All frames of the clip have cameras, and
// two of them count.
CameraMatrices CameraAt(const Clip& clip, CameraSchedule schedule, int every, double time);

// Makes the reprojections of a clip's generated frames, one at a time.
class ReprojectionSource {
 public:
  // For methods whose generation takes the references (`references`) or the rendered frames of a
  // clip with cameras; the clip outlives the object.
  ReprojectionSource(const Clip& clip, CameraSchedule schedule, int every, bool references);

  // From the clip's frame `source` to `time`; valid until the next call. A pixel moves if its
  // motion is unexplained, as are the 8 around it. Where the clip has a frame at `time`, what moves
  // there is drawn anew: its pixels are those of that frame. Elsewhere nothing is known to move.
  // Before a cut the camera stays.
  const Reprojection& At(int source, double time);

 private:
  const ImageBuffer& Color(int frame) const;
  // Whether each pixel of a frame moves, 0 or 1, to `moving`.
  void FindMoving(int frame, const MutableImageView& moving) const;

  const Clip& clip_;
  CameraSchedule schedule_;
  int every_;
  bool references_;
  ImageBuffer moving_, drawn_moving_, drawn_;
  Reprojection reprojection_;
};

}  // namespace warplut
