// Frame generation: frames between two displayed frames (interpolation) or after the later one
// (extrapolation).
//
// p1 is a pixel of frame 1, m1 its motion (from frame 0 to 1), m0 the motion of frame 0 at p1 - m1
// (from frame -1 to 0). MotionModel::kQuadratic has it
//   interpolated, at time alpha:      p1 - m1 + alpha/2 (m1 + m0) + alpha^2/2 (m1 - m0)
//   extrapolated, at time 1 + alpha:  p1 + alpha/2 (3 m1 - m0) + alpha^2/2 (m1 - m0)
// and kLinear p1 - (1 - alpha) m1 and p1 + alpha m1. kPerspective, the default, has the same curve
// in homogeneous coordinates, with the depths at p1 and at p1 - m1.
//
// Passes (docs/GENERATION.md has formulas, buffers and limits):
//   splat   writes the motion of every pixel of frame 1 to the nearest pixel of its new place. The
//           least depth wins, equal depths by the lesser source index, for any order of threads.
//   refine  gives thin gaps the mean motion of their foreground neighbours. Pixels that then have
//           no motion are disocclusions and take it from their surroundings.
//   warp    warps both frames and blends by InterpolationShare (interpolation), or warps frame 1
//           (extrapolation).
//
// Any executor gives the same bits. The generating functions allocate nothing. Bytes per pixel:
//   splatting 16, kLinearHdr 16, motion filter 16 and its own, filter with a prefilter 32,
//   kMeshProjection 8;
//   for each thread 48 for each pixel of 16 rows.
// Subnormals are flushed to zero, in colour, depth and motion (runtime/float_environment.h); a
// source that is shown as it is keeps its bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "luts/visibility.h"
#include "runtime/choices.h"
#include "runtime/color_encoding.h"
#include "runtime/executor.h"
#include "runtime/frame_tiles.h"
#include "runtime/gates.h"
#include "runtime/image_view.h"
#include "runtime/motion_filter.h"
#include "runtime/parameters.h"
#include "runtime/peers.h"
#include "runtime/pipeline.h"
#include "runtime/reprojection.h"
#include "runtime/warp.h"

namespace WARPLUT_PUBLIC warplut {

// One displayed frame. All views are on one grid. Formats, units and the treatment of NaN and
// infinity are those of RenderedFrame. A pixel whose motion is not finite was not there in the
// frame before: it goes nowhere.
struct DisplayedFrame {
  ImageView color;
  ImageView depth;
  MotionView motion;
  // Shares nothing with the frame before, or there is none: the first frame of all, one after a
  // camera cut or after SuperResolution::Reset (OutputGeometry::cut tells). Its motion leads
  // nowhere: as frame 0 it makes the motion uniform. What engines write there, often 0, would count
  // as an acceleration.
  bool cut = false;
  // If not 0, identifies the frame among all that this object is given. A filter with a prefilter
  // then turns its colour into coefficients once, however many frames are generated from it. With 0
  // it does so at every call.
  std::uint64_t id = 0;
  // Without data, or the interface that belongs over this frame, RGBA8, RGBA16F or RGBA32F with
  // premultiplied alpha (runtime/hud.h). The colour is without it. It is neither warped nor blended
  // with that of the other frame.
  ImageView hud = {};
  // Of frame 1, read by kMeshProjection alone: null, or the cameras and the objects that move
  // (runtime/reprojection.h).
  const Reprojection* reprojection = nullptr;
};

// Defaults are those of kPipeline (runtime/pipeline.h) for choices that the build fixes.
struct FrameGenerationOptions {
  int width = 0, height = 0;
  MotionModel motion_model = kPipeline.generation.motion_model.value_or(MotionModel::kPerspective);
  // false: a pixel takes the motion of frame 1 at its own place, which is nearly right where little
  // moves. `refine` and `fill` then have no effect.
  bool splat = kPipeline.generation.splat.value_or(true);
  bool refine = kPipeline.generation.refine.value_or(true);
  // The fill of extrapolation; interpolation takes kBackground, or what frame 0 shows there
  // (kPerspective).
  DisocclusionFill fill = kPipeline.generation.fill.value_or(DisocclusionFill::kOwnMotion);
  DepthMeasure depth = kPipeline.generation.depth.value_or(DepthMeasure::kRelative);
  // false: a linear blend wherever depth agrees.
  bool brightness_gate = kPipeline.generation.brightness_gate.value_or(false);
  // Removes quantisation from the motion (runtime/motion_filter.h).
  bool motion_filter = kPipeline.generation.motion_filter.value_or(false);
  float motion_filter_limit = kGenerationMotionFilterLimit;  // MotionFilterOptions::limit
  // Null, or another system (runtime/peers.h), whose motion of the generated frame is taken.
  const GenerationPeer* peer = nullptr;
  WarpOptions warp;
  ColorEncoding encoding = kPipeline.generation.encoding.value_or(ColorEncoding::kDisplay);
  Parameters parameters;
  float gate_width = 0;    // as in SuperResolutionOptions
  bool reference = false;  // run the plain version of every pass

  bool IsValid(std::string* why = nullptr) const;
};

class FrameGeneration {
 public:
  // Allocates every buffer. Options must be valid; executor outlives the object.
  FrameGeneration(const FrameGenerationOptions& options, Executor& executor);
  ~FrameGeneration();

  // Makes the frame at `alpha` in (0, 1) between frame0 and frame1. If frame1 is a cut, the nearer
  // frame in time is shown. If frame0 is a cut, the motion is linear. `out` has the size of the
  // options and is RGBA8, RGBA16F or RGBA32F, whatever the format of the colours. It overlaps no
  // input; its alpha becomes 1. The HUD of the nearer frame in time (frame 1 from alpha = 1/2 on)
  // is drawn over it, if that frame has one.
  void Interpolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                   const MutableImageView& out);

  // Makes the frame at `alpha` in (0, 1) after frame1. frame0 gives motion and depth alone and may
  // have no colour. The HUD of frame1 is drawn over it, if there is one.
  void Extrapolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                   const MutableImageView& out);

  // Whether both functions accept these arguments; otherwise *why (if not null) gets the reason. A
  // frame0 without colour data fits Extrapolate alone.
  bool IsGenerable(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                   const MutableImageView& out, std::string* why) const;

  // Sets parameters and gate width, both valid, from the next call on.
  void SetParameters(const Parameters& parameters, float gate_width = 0);

  // Counts the tiles of the last frame; all are 0 if a source was shown as it is. A tile is
  // disoccluded if some of its pixels had no arrival or a replaced one. options.reference does not
  // count warps.
  FrameTiles Tiles() const;

  // Bytes of all buffers. Buffers without use for these options are not allocated.
  std::size_t MemoryBytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warplut
