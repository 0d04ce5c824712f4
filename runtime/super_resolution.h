// Super resolution: rendered frames with jitter -> frames on the output grid, by a history that a LUT warps.
//
// Steps of one frame, for output pixel q with centre P (output pixels), s = output / render size in each axis:
//   1. motion m and depth at q, from the render samples around P / s (edge-aware: bilinear inside surfaces, the nearest
//      surface's at depth edges);
//   2. q^w = history at P - m by the filter; valid where P - m is in the image, no cut, and the depth at q lies at most T_D behind
//      the range of the 4 x 4 depths around P - m one frame ago (absolute measure: nor before it);
//   3. q^w limited to the colour box at P, bilinear among those of the samples around it (each of its 3 x 3 samples); where history is partly valid (gate_width > 0) or
//      not at all the rest is the current frame alone, interpolated at P with its jitter;
//   4. the new samples enter, in one of three forms (docs/SUPER_RESOLUTION.md):
//      kSample    q = share * mean(w s) / mean(w) + (1 - share) q^w, share = BlendShare(a, mean w) over the samples within one
//                 render pixel: equation 2 of the paper in the form that keeps constants;
//      kResidual  q = q^w + share * (bilinearly interpolated differences of the samples from what the warped history predicts
//                 at their own positions, by Catmull-Rom); share = BlendShare(a, SampleWeight(b, distance of the nearest
//                 sample));
//      kAdaptive  the residual form, which passes by degrees into a blend with the current frame alone where the samples alias
//                 (runtime/sr/aliasing.h). In all the share is multiplied by the validity of the history.
//   Without history (first frame, cut, options.history false) step 2 finds nothing valid.
//   With MotionUpsampling::kStatic steps 1 and 2 are left out: q^w is the history at P and valid; neither motion nor depth is read.
// q is limited to [0, 1] before it is stored. In linear HDR all this is done in codes (runtime/color_encoding.h), and q is limited to the
// brightest of the 4 x 4 samples around P, or to the code of kUnlimitedHdr if that is more.
//
// Subnormals are flushed to zero, in colour, depth and motion (runtime/float_environment.h).
//
// A sample (i, j) of the render grid lies at output position ((i + 1/2 + jitter_x) s_x, (j + 1/2 + jitter_y) s_y).
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
#include "runtime/parameters.h"
#include "runtime/pipeline.h"
#include "runtime/warp.h"

namespace WARPLUT_PUBLIC warplut {

// One rendered frame; all views on the render grid. Colour: RGBA8, RGBA16F or RGBA32F (alpha is ignored). Depth: R32F, view
// depth in units of the far plane, >= 0; NaN, negative and infinite values count as kFarthestDepth. Motion: pixels of the
// render grid, from the frame before to this one, without jitter; where a component is NaN or infinite there is no history.
// In kDisplay a NaN or infinite colour channel counts as 0, what lies outside [0, 1] is limited to it; in kLinearHdr LimitHdr takes it. With
// MotionUpsampling::kStatic depth and motion may be without data.
struct RenderedFrame {
  ImageView color;
  ImageView depth;
  MotionView motion;
  float jitter_x = 0;  // render pixels, in [-1, 1]
  float jitter_y = 0;
  bool cut = false;  // shares nothing with the frame before
};

// Defaults are those of kPipeline (runtime/pipeline.h) where the build contains one value alone.
struct SuperResolutionOptions {
  int render_width = 0, render_height = 0;
  int output_width = 0, output_height = 0;  // 1 to 4 times render, in each axis
  HistoryForm form = kPipeline.sr.form.value_or(HistoryForm::kAdaptive);
  bool history = kPipeline.sr.history.value_or(true);  // false: every frame from itself alone
  ColorClamp clamp = kPipeline.sr.clamp.value_or(ColorClamp::kVariance);
  DepthMeasure depth = kPipeline.sr.depth.value_or(DepthMeasure::kRelative);
  MotionUpsampling motion = kPipeline.sr.motion.value_or(MotionUpsampling::kEdgeAware);
  // Takes quantisation out of the motion (runtime/motion_filter.h).
  bool motion_filter = kPipeline.sr.motion_filter.value_or(false);
  CurrentFrame current = kPipeline.sr.current.value_or(CurrentFrame::kBilinear);
  WarpOptions warp;  // the filter of the history
  // RGBA8, RGBA16F or RGBA32F.
  PixelFormat history_format = kPipeline.sr.history_format.value_or(PixelFormat::kRgba16F);
  ColorEncoding encoding = kPipeline.sr.encoding.value_or(ColorEncoding::kDisplay);
  Parameters parameters;
  float gate_width = 0;    // of every gate, relative to its threshold, in [0, 1]; 0 is what ships
  bool reference = false;  // run the plain version of every pass

  bool IsValid(std::string* why = nullptr) const;
};

// What frame generation needs beside the colour, on the output grid; views that stay valid until the next Process.
struct OutputGeometry {
  ImageView depth;    // R32F, in [0, kFarthestDepth]
  MotionView motion;  // output pixels
  // DisplayedFrame::cut: the frame was the first, a cut, or the first after Reset. Its motion leads
  // to no frame that was shown.
  bool cut = false;
};

class SuperResolution {
 public:
  // Allocates every buffer that Process needs: Process itself allocates nothing. Options must be valid; executor outlives the
  // object. The same bits for any executor.
  SuperResolution(const SuperResolutionOptions& options, Executor& executor);
  ~SuperResolution();

  // The next frame. Not to be called by two threads at a time. Sizes must be those of the options and formats those of RenderedFrame (IsProcessable); `out` is RGBA8,
  // RGBA16F or RGBA32F on the output grid, alpha is set to 1.
  void Process(const RenderedFrame& frame, const MutableImageView& out);
  bool IsProcessable(const RenderedFrame& frame, const MutableImageView& out,
                     std::string* why) const;

  // Depth and motion of the last frame, upsampled as step 1 does (kStatic: kFarthestDepth and 0); motion is NaN where there is none.
  // Computed on the first call after Process, whose buffers are allocated by the first call of all.
  OutputGeometry Geometry();

  // Forgets the history: the next frame is treated as a cut.
  void Reset();
  // New parameters and gate width from the next frame on; both valid.
  void SetParameters(const Parameters& parameters, float gate_width = 0);

  // Of the last frame. Tiles are disoccluded where some of their history is not valid.
  FrameTiles Tiles() const;

  // Bytes of all buffers; those that the options have no use for are not there.
  std::size_t MemoryBytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warplut
