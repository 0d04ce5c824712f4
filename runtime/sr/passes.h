// The passes of super resolution and what they work on. Rows are handed out in bands; no pass needs
// to know the others' bands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/configuration/chosen.h"
#include "runtime/core/band.h"
#include "runtime/image_buffer.h"
#include "runtime/sr/aliasing.h"
#include "runtime/sr/axis_map.h"
#include "runtime/sr/plane.h"
#include "runtime/sr/render_planes.h"
#include "runtime/super_resolution.h"

namespace warplut {

// One frame on its way through the passes.
struct SrJob {
  const SuperResolutionOptions& options;
  const AxisMap& x;
  const AxisMap& y;
  const RenderPlanes& planes;

  // Of the frame before: the least and greatest depth of samples (i - 1, j - 1) to (i + 2, j + 2),
  // the greatest of its reactive mask, and its grid.
  const Plane& nearest_before;
  const Plane& farthest_before;
  const Plane& reactive_before;
  AxisBefore x_before, y_before;

  bool has_history;
  ImageView
      history;  // of the frame before; where the history is not warped it is already in `next`
  ImageView coefficients;       // of `history`, where the filter has a prefilter
  MutableImageView next;        // first the predicted colour, then the new history
  MutableImageView next_state;  // of a peer that keeps one (runtime/peers/sr/sr_peer.h)
  const Plane* residual;        // R, G, B: sample minus prediction
  const AliasingMap* aliasing;  // in the adaptive form

  bool HasHistory() const { return KeepsHistory(options) && has_history; }
};

// What one worker may write beside its rows; allocated once.
struct SrScratch {
  explicit SrScratch(const SuperResolutionOptions& options);
  std::size_t bytes() const;

  void SetRenderWidth(int width) { render_rows.SetSize(width, kRenderRows); }

  MotionBuffer motion;  // of a band of output rows, where the history is warped
  Plane validity;       // of the same rows, in [0, 1]
  Plane render_rows;    // kRenderRows rows on the render grid
  Plane output_rows;    // kOutputRows rows on the output grid, where motion is read
  // Per tile of a band: 1 where some history is not valid. predict sets it.
  std::vector<std::uint8_t> disoccluded;
  FrameTiles tiles;  // of the bands that this worker took

  static constexpr int kRenderRows = 25;
  static constexpr int kOutputRows = 3;
};

struct SrPasses {
  // Rows [begin, end) of the planes, borders included; depth and motion where they are read.
  void (*fill_planes)(const SuperResolutionOptions& options, const RenderedFrame& frame,
                      const MotionView& motion, int begin, int end, RenderPlanes& planes);
  // Output rows [begin, end): depth, and motion in output pixels (NaN where there is none).
  void (*geometry)(const SrJob& job, int begin, int end, SrScratch& scratch,
                   const MutableImageView& depth, const MutableMotionView& motion);
  // Output rows [begin, end), at most kBandRows of one band: the predicted colour, and its validity
  // in alpha.
  void (*predict)(const SrJob& job, int begin, int end, SrScratch& scratch);
  // Render rows [begin, end), those of one row of aliasing tiles: the residual, and in the adaptive
  // form its variances.
  void (*residual)(const SrJob& job, int begin, int end, Plane* residual, AliasingMap& aliasing);
  // Output rows [begin, end): the new samples enter; history and output are written.
  void (*update)(const SrJob& job, int begin, int end, SrScratch& scratch,
                 const MutableImageView& out);
  // Render rows [begin, end) of the depth range that the next frame is compared with.
  void (*depth_range)(const Plane& depth, int begin, int end, Plane& nearest, Plane& farthest);
  // Render rows [begin, end) of the reactive mask as the next frame reads it: the greatest of
  // samples (i - 1, j - 1) to (i + 2, j + 2).
  void (*reactive_reach)(const Plane& reactive, int begin, int end, Plane& reach);
  // Whether predict writes the validity of methods without history, too.
  bool always_validity;
};

// Slow and obvious, one pixel after the other. Not to be called where the build does not contain
// them.
const SrPasses& ReferencePasses();

// The same on vectors, for the processor at hand.
const SrPasses& FastPasses();

}  // namespace warplut
