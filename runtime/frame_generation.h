// Frame generation: frames between two displayed frames (interpolation) or after the later one (extrapolation).
//
// p1 is a pixel of frame 1, m1 its motion (from frame 0 to 1), m0 the motion of frame 0 at p1 - m1 (from frame -1 to 0):
//   interpolated, at time alpha:      p1 - m1 + alpha/2 (m1 + m0) + alpha^2/2 (m1 - m0)
//   extrapolated, at time 1 + alpha:  p1 + alpha/2 (3 m1 - m0) + alpha^2/2 (m1 - m0)
// and without m0 the linear p1 - (1 - alpha) m1 and p1 + alpha m1.
//
// Passes: splat (the motion of every pixel of frame 1 to the nearest pixel of where it will be; the least depth wins, ties by the
// lesser source index, whatever the thread order), refine (thin gaps take the mean of their foreground neighbours; what then has
// no motion is a disocclusion and takes it from its surroundings), warp both frames and InterpolationShare (interpolation), or
// warp frame 1 (extrapolation). docs/GENERATION.md has formulas, buffers, limits and measured quality.
//
// Subnormals are flushed to zero, in colour, depth and motion (runtime/float_environment.h); a
// source that is shown as it is keeps its bits.
// Any executor gives the same bits. The generating functions allocate nothing. Buffers take 16 bytes per pixel (without splatting none),
// with kLinearHdr and with a motion filter 16 more each, with a filter that has a prefilter 32 more, and 48 bytes for each pixel of 16 rows and each thread; a motion filter has its own besides.
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
#include "runtime/pipeline.h"
#include "runtime/warp.h"

namespace WARPLUT_PUBLIC warplut {

// One displayed frame; all views on one grid. Formats, units and the treatment of NaN and infinity as for RenderedFrame; a pixel
// whose motion is not finite counts as one that was not there in the frame before: it goes nowhere.
struct DisplayedFrame {
  ImageView color;
  ImageView depth;
  MotionView motion;
  // Shares nothing with the frame before, or there is none: the first frame of all, one after a
  // camera cut or after SuperResolution::Reset (OutputGeometry::cut tells). Its motion leads
  // nowhere: as frame 0 it makes the motion uniform. What engines write there, often 0, would count
  // as an acceleration.
  bool cut = false;
  // Not 0: tells the frame from all others that this object is given. A filter with prefilter then turns its colour into
  // coefficients once, however many frames are generated from it. 0: at every call.
  std::uint64_t id = 0;
};

// Defaults are those of kPipeline (runtime/pipeline.h) where the build contains one value alone.
struct FrameGenerationOptions {
  int width = 0, height = 0;
  MotionModel motion_model = kPipeline.generation.motion_model.value_or(MotionModel::kQuadratic);
  // false: a pixel takes the motion that frame 1 has at its place, as where little moves it nearly does; `refine` and `fill` then have
  // nothing to do.
  bool splat = kPipeline.generation.splat.value_or(true);
  bool refine = kPipeline.generation.refine.value_or(true);
  // Of extrapolation; interpolation takes kBackground.
  DisocclusionFill fill = kPipeline.generation.fill.value_or(DisocclusionFill::kOwnMotion);
  DepthMeasure depth = kPipeline.generation.depth.value_or(DepthMeasure::kRelative);
  // false: a linear blend wherever depth agrees.
  bool brightness_gate = kPipeline.generation.brightness_gate.value_or(false);
  // Takes quantisation out of the motion (runtime/motion_filter.h).
  bool motion_filter = kPipeline.generation.motion_filter.value_or(false);
  float motion_filter_limit = kGenerationMotionFilterLimit;  // MotionFilterOptions::limit
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

  // The frame at `alpha` in (0, 1) between frame0 and frame1. If frame1 is a cut the nearer frame in time is shown. If
  // frame0 is a cut its motion is not used: the motion is taken as linear. `out`: size of the options, RGBA8, RGBA16F or
  // RGBA32F, which need not be the format of the colours; it overlaps no input; alpha channel 1.
  void Interpolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                   const MutableImageView& out);

  // The frame at `alpha` in (0, 1) after frame1; frame0 gives its motion and depth alone and may have no colour.
  void Extrapolate(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                   const MutableImageView& out);

  // Whether the two may be called with these; otherwise *why (if not null) says why not. A frame0 without colour data is fit for
  // Extrapolate alone.
  bool IsGenerable(const DisplayedFrame& frame0, const DisplayedFrame& frame1, float alpha,
                   const MutableImageView& out, std::string* why) const;

  // New parameters and gate width from the next call on; both valid.
  void SetParameters(const Parameters& parameters, float gate_width = 0);

  // Of the last frame; all 0 where a source was shown as it is. Tiles are disoccluded where at some pixels nothing arrived, or what did
  // was replaced. With options.reference the warps are not counted.
  FrameTiles Tiles() const;

  // Bytes of all buffers; those that the options have no use for are not there.
  std::size_t MemoryBytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warplut
