// Bidirectional reprojection by fixed-point iteration (docs/METHODS.md).
//
// Motion is linear. For a pixel q of the generated frame the source in frame 1 is the p that moves
// to it: p + D(p) = q with D = -(1 - alpha) m1; in frame 0 D = alpha m0. It is sought by
//   p <- q - D(p)   kIterations times, D read at the pixel nearest to p,
// from p = q, and where that misses q by more than the tolerance also from q - D with the motion
// that the other frame has at q; what misses by less is taken. The miss is the greater axis of
// |p + D(p) - q|; it is infinite, and p = q, where the way leads out of the image or to a pixel
// without motion.
//
// A source counts if it misses by no more than the tolerance. Of two that count and are not alike
// in depth (DepthTolerance) the nearer to the camera hides the other; if none counts, the lesser
// miss is taken. A source that is not taken is kOutside. Where the motion of frame 0 does not count
// (it is a cut) frame 0 is read where the source in frame 1 was.
#pragma once

#include "runtime/generation/motion/target_motion.h"
#include "runtime/peers/generation/linear_motion.h"

namespace warplut::peers {

inline constexpr int kIterations = 3;

// A frame whose pixels move to the generated frame by share * motion.
struct MovingFrame {
  MotionView motion;
  float share;
};
inline MovingFrame Frame0(const GenerationJob& job) { return {job.motion0, job.alpha}; }
inline MovingFrame Frame1(const GenerationJob& job) { return {job.motion1, job.alpha - 1}; }

// Motion from a frame to a pixel q of the generated frame: the source is q - motion.
struct Reprojection {
  Vector motion;
  float miss;
};

// The search for the source of pixel (x, y) in `frame`; `other` gives the second start.
Reprojection Reproject(const GenerationJob& job, const MovingFrame& frame, const MovingFrame& other,
                       int x, int y);

// The motion to the generated frame's pixel (x, y).
TargetMotion BidirectionalMotionAt(const GenerationJob& job, int x, int y);

void BidirectionalRowReference(const GenerationJob& job, int y, const MutableMotionView& from0,
                               const MutableMotionView& from1);

}  // namespace warplut::peers
