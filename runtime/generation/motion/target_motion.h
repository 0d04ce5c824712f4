// The third pass: motion of the generated frame's own pixels, to warp frames 0 and 1 by.
//
// A pixel at which a pixel of frame 1 arrived takes its motion. Then
//   gaps (refine): of the four 2 x 2 blocks that hold the pixel none is alike in depth to it: it
//     takes the mean motion of the foreground among its 8 neighbours, those alike in depth to the
//     nearest one, which must be nearer than itself;
//   disocclusions, the others without an arrival: interpolation takes the motion of the farthest
//     among the first arrivals in 8 directions, its background, extrapolation does as
//     DisocclusionFill says. With the perspective model interpolation looks for the pixel of frame
//     0 that arrives there as it goes on moving, and takes its motion.
// "Alike" is |DepthDifference| <= T_D, whatever the gate width; pixels without an arrival are alike
// to each other only. Pixels beyond the border are those on it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "runtime/generation/generation_job.h"
#include "runtime/motion_tiles.h"

namespace warplut::generation {

// Motion from frames 0 and 1 to a pixel of the generated frame, as Warp takes it: the source
// positions are q - m.
struct TargetMotion {
  Vector from0;
  Vector from1;
  bool filled = false;  // a disocclusion: nothing arrived here, and it is no gap
};

// What arrived: the results of the first two passes. Rows of `forward` follow each other without
// padding.
struct Arrivals {
  MotionView forward;
  KeyView keys;
};

// How far the search for background goes, in pixels along each of the 8 directions.
inline constexpr int kBackgroundReach = 64;

// How a disocclusion is found in frame 0: steps, and how near the last one comes, in pixels.
inline constexpr int kSearchSteps = 6;
inline constexpr float kSearchClosure = 0.5f;

// |DepthDifference| <= T_D without its division, for depths of arrivals and kNoArrivalDepth.
struct DepthTolerance {
  float absolute, relative;

  explicit DepthTolerance(const GenerationJob& job)
      : absolute(DepthOf(job.options) == DepthMeasure::kNone       ? 2 * kFarthestDepth
                 : DepthOf(job.options) == DepthMeasure::kAbsolute ? job.depth_threshold()
                                                                   : 0.0f),
        relative(DepthOf(job.options) == DepthMeasure::kRelative ? job.depth_threshold() : 0.0f) {}

  bool Alike(float a, float b) const {
    return std::abs(a - b) <= absolute + relative * std::max(std::min(a, b), 1e-12f);
  }
};

TargetMotion TargetMotionAt(const GenerationJob& job, const Arrivals& arrivals, int x, int y);

// Stores the motion of pixel (x, y). from0 is left alone if the job extrapolates.
inline void StoreMotion(const GenerationJob& job, const TargetMotion& motion, int x, int y,
                        const MutableMotionView& from0, const MutableMotionView& from1,
                        std::uint8_t* disoccluded) {
  if (job.Interpolates()) SetMotion(from0, x, y, motion.from0);
  SetMotion(from1, x, y, motion.from1);
  if (motion.filled) disoccluded[x / kTileWidth] = 1;
}

// `disoccluded` has one entry per tile column: 1 is written where a pixel of the row is filled.
void TargetMotionRowReference(const GenerationJob& job, const Arrivals& arrivals, int y,
                              const MutableMotionView& from0, const MutableMotionView& from1,
                              std::uint8_t* disoccluded);

// Without splatting: the pixel at the same place of frame 1 is taken to arrive. `from1` holds the
// forward displacements of row y; where one is not finite nothing moves.
void OwnMotionRowReference(const GenerationJob& job, int y, const MutableMotionView& from0,
                           const MutableMotionView& from1);

}  // namespace warplut::generation
