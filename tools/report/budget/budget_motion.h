// Motion as a game stores it, and motion in the other direction of time.
#pragma once

#include <string>

#include "datasets/image.h"
#include "tools/report/budget/budget_images.h"
#include "train/metrics/temporal_error.h"
#include "train/replay/clip.h"

namespace warplut {

// How a game stores motion m as a share of the screen, (m / size + 1) / 2, in each axis, `size`
// being that of a display of 1920 x 1080 (of its render grid, where motion is of the render grid).
//   kBytes  two bytes, a multiple of 1 / 255^2: steps of 2^-15 of the screen
//   kHalf   an IEEE half: steps of 2^-11 of the screen to one side, 2^-10 to the other
// What is not finite stays.
enum class MotionStorage : std::uint8_t { kBytes, kHalf };

inline constexpr GridSize kStoredDisplay = {1920, 1080};

// A component of motion, read back. size > 0.
float StoredMotion(float m, float size, MotionStorage storage);

// The clip with the motion of both grids stored and read back.
Clip WithStoredMotion(const Clip& clip, MotionStorage storage);

// For frame f, from the motion of frame f + 1 (which points from f to f + 1, stored at its pixels):
// v(p), such that what is seen at p in frame f is at p + v in frame f + 1. Found by fixed-point
// iteration q <- p + m(q) from the arrivals in the 3 x 3 pixels around p, m read bilinearly.
// Accepted where it closes within kClosure pixels and the depths of the two frames there differ by
// at most kSameSurface (train/metrics/same_surface.h); elsewhere frame f + 1 does not show p.
struct ForwardMotion {
  MotionBuffer motion;  // -v, as warps take it; NaN where it is not known
  PixelMask known;
};
ForwardMotion ForwardMotionOf(const FrameGeometry& now, const FrameGeometry& next);

inline constexpr double kClosure = 0.25;

}  // namespace warplut
