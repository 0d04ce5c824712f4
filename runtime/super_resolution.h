// Super resolution: rendered frames with jitter -> frames on the output grid, with a history that a
// filter warps.
//
// Notation: s = output / render size in each axis; q an output pixel with centre P (output pixels);
// sample (i, j) of the render grid lies at output position
// ((i + 1/2 + jitter_x) s_x, (j + 1/2 + jitter_y) s_y).
//
// A frame takes four steps for each q (docs/SUPER_RESOLUTION.md):
//   1. Geometry. Motion m and depth at q come from the render samples around P / s: bilinear inside
//      surfaces, those of the nearest surface at depth edges.
//   2. Prediction. q^w is the history at P - m, by the filter. It is valid where P - m lies in the
//      image, there is no cut, and the depth at q lies at most T_D behind the range of the 4 x 4
//      depths around P - m one frame ago. kAbsolute also rejects depth before that range.
//   3. Limit. q^w is limited to the colour box at P, which is bilinear among the boxes of the
//      samples around it; a sample's box is that of its 3 x 3 samples. Where history is not valid,
//      or partly (gate_width > 0), the rest is the current frame alone, interpolated at P with its
//      jitter.
//   4. Update. The new samples enter in one of three forms:
//        kSample    q = share * mean(w s) / mean(w) + (1 - share) q^w over the samples within one
//                   render pixel, share = BlendShare(a, mean w): equation 2 of the paper in the
//                   form that keeps constants.
//        kResidual  q = q^w + share * r(P). r(P) is bilinear among the differences of the samples
//                   from the warped history at their own positions (by Catmull-Rom);
//                   share = BlendShare(a, SampleWeight(b, distance of the nearest sample)).
//        kAdaptive  the residual form, which passes by degrees into a blend with the current frame
//                   alone where the samples alias (runtime/sr/aliasing.h).
//      Each share is multiplied by the validity of the history.
//
// A reactive mask (RenderedFrame::reactive) multiplies the validity of step 2 by 1 - r. r is the
// greatest of the four samples of the mask around P / s, and of the 4 x 4 samples of the mask of
// the frame before around the position that the history comes from: what a reactive sample left in
// the history is as little trusted as what it covers.
//
// Without history (first frame, cut, options.history false) step 2 finds nothing valid.
// MotionUpsampling::kStatic leaves out steps 1 and 2: q^w is the history at P and valid, and
// neither motion nor depth is read.
// q is limited to [0, 1] before it is stored. In linear HDR all steps work on codes
// (runtime/color_encoding.h), and q is limited to the brightest of the 4 x 4 samples around P, or
// to the code of kUnlimitedHdr if that is more.
// Subnormals are flushed to zero, in colour, depth and motion (runtime/float_environment.h).
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
#include "runtime/peers.h"
#include "runtime/pipeline.h"
#include "runtime/warp.h"

namespace WARPLUT_PUBLIC warplut {

// One rendered frame. All views are on the render grid.
//   color   RGBA8, RGBA16F or RGBA32F; alpha is ignored. kDisplay: NaN and infinite channels count
//           as 0, others are limited to [0, 1]. kLinearHdr: LimitHdr applies.
//   depth   R32F: view depth in units of the far plane, >= 0. NaN, negative and infinite values
//           count as kFarthestDepth.
//   motion  pixels of the render grid, from the frame before to this one, without jitter. A pixel
//           with a NaN or infinite component has no history.
// With MotionUpsampling::kStatic depth and motion may be without data.
struct RenderedFrame {
  ImageView color;
  ImageView depth;
  MotionView motion;
  float jitter_x = 0;  // render pixels, in [-1, 1]
  float jitter_y = 0;
  bool cut = false;  // shares nothing with the frame before
  // R32F, or without data: 0 everywhere. How little the motion says about the colour of a sample,
  // from 0 (as without mask) to 1 (no history): transparent surfaces and particles, animated
  // textures. NaN counts as 0, others are limited to [0, 1]. Read where
  // SuperResolutionOptions::reactive says so.
  ImageView reactive = {};
};

// Defaults are those of kPipeline (runtime/pipeline.h) for choices that the build fixes.
struct SuperResolutionOptions {
  // The largest that SetRenderSize takes, and the size until it is called.
  int render_width = 0, render_height = 0;
  int output_width = 0, output_height = 0;  // 1 to 4 times render, in each axis
  HistoryForm form = kPipeline.sr.form.value_or(HistoryForm::kAdaptive);
  bool history = kPipeline.sr.history.value_or(true);  // false: each frame from itself alone
  ColorClamp clamp = kPipeline.sr.clamp.value_or(ColorClamp::kVariance);
  DepthMeasure depth = kPipeline.sr.depth.value_or(DepthMeasure::kRelative);
  MotionUpsampling motion = kPipeline.sr.motion.value_or(MotionUpsampling::kEdgeAware);
  // Removes quantisation from the motion (runtime/motion_filter.h).
  bool motion_filter = kPipeline.sr.motion_filter.value_or(false);
  CurrentFrame current = kPipeline.sr.current.value_or(CurrentFrame::kBilinear);
  // The share of residuals that agree with those around them, as where light changes, of all output
  // pixels alike, in [0, 1] (docs/SUPER_RESOLUTION.md); 0: as other residuals, by the distance of
  // the nearest sample. Not read by kSample. No device but the processor has it.
  float coherent_share = 0;
  bool reactive = false;  // frames may have a reactive mask; allocates two planes for it
  WarpOptions warp;       // the filter of the history
  // Null, or another system (runtime/peers.h), whose limit, update and filter are taken instead.
  const SrPeer* peer = nullptr;
  // RGBA8, RGBA16F or RGBA32F.
  PixelFormat history_format = kPipeline.sr.history_format.value_or(PixelFormat::kRgba16F);
  ColorEncoding encoding = kPipeline.sr.encoding.value_or(ColorEncoding::kDisplay);
  Parameters parameters;
  float gate_width = 0;    // width of every gate, relative to its threshold, in [0, 1]; 0 ships
  bool reference = false;  // run the plain version of every pass

  bool IsValid(std::string* why = nullptr) const;
};

// Depth and motion on the output grid, as frame generation needs them. The views end at the next
// Process.
struct OutputGeometry {
  ImageView depth;    // R32F, in [0, kFarthestDepth]
  MotionView motion;  // output pixels
  // DisplayedFrame::cut: the frame was the first, a cut, or the first after Reset. Its motion leads
  // to no frame that was shown.
  bool cut = false;
};

class SuperResolution {
 public:
  // Allocates every buffer that Process needs. The options must be valid. The executor outlives the
  // object; any executor gives the same bits.
  SuperResolution(const SuperResolutionOptions& options, Executor& executor);
  ~SuperResolution();

  // Makes the next frame; allocates nothing. One thread calls it at a time. Sizes are those of the
  // options or of SetRenderSize, formats those of RenderedFrame; IsProcessable checks them. `out`
  // is RGBA8, RGBA16F or RGBA32F on the output grid; its alpha becomes 1.
  void Process(const RenderedFrame& frame, const MutableImageView& out);
  bool IsProcessable(const RenderedFrame& frame, const MutableImageView& out,
                     std::string* why) const;

  // Depth and motion of the last frame, upsampled as in step 1 (kStatic: kFarthestDepth and 0).
  // Motion is NaN where there is none. The first call after Process computes them; the first call
  // of all allocates their buffers.
  OutputGeometry Geometry();

  // Changes the size of rendered frames from the next one on (dynamic resolution). The history is
  // kept. A quarter of the output to all of it in each axis, at most the size of the options;
  // IsRenderSize checks that. Before the first frame it is as if the options had had that size, to
  // the bit. Allocates nothing, unless options.motion_filter.
  void SetRenderSize(int width, int height);
  bool IsRenderSize(int width, int height, std::string* why = nullptr) const;

  // Forgets the history: the next frame is treated as a cut.
  void Reset();
  // Sets parameters and gate width, both valid, from the next frame on.
  void SetParameters(const Parameters& parameters, float gate_width = 0);

  // Counts the tiles of the last frame. A tile is disoccluded if some of its history is not valid.
  FrameTiles Tiles() const;

  // Bytes of all buffers. Buffers without use for these options are not allocated.
  std::size_t MemoryBytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warplut
