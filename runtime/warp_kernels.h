// The vector kernels behind Warp, chosen at run time for the processor. Input is checked before.
#pragma once

#include "runtime/motion_tiles.h"
#include "runtime/warp.h"

namespace warplut {

// What the options come to in this build (runtime/pipeline.h).
constexpr Filter FilterOf(const WarpOptions& options) {
  return Choose(kPipeline.filter, options.filter);
}
constexpr Lookup LookupOf(const WarpOptions& options) {
  return Choose(kPipeline.lookup, options.lookup);
}

struct WarpJob {
  const ImageView& history;
  const MotionView& motion;
  const WarpOptions& options;
  const MutableImageView& out;
};

// The formula, one pixel after the other.
void WarpReferencePixels(const WarpJob& job, const TileRect& pixels);

// Whether all motion of the pixels equals that of the first one; a NaN equals nothing.
bool IsUniform(const MotionView& motion, const TileRect& pixels);

// Each pixel has its own weights.
void WarpGeneral(const WarpJob& job, const TileRect& pixels);

// All pixels have the motion (mx, my), which is finite and not whole in both axes.
void WarpUniform(const WarpJob& job, const TileRect& pixels, float mx, float my);

}  // namespace warplut
