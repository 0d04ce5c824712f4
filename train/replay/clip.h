// Frames of a sequence in memory, in the form that the runtime takes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "datasets/sequence/sequence.h"
#include "runtime/frame_generation.h"
#include "runtime/image_buffer.h"
#include "runtime/reprojection.h"
#include "runtime/super_resolution.h"

namespace warplut {

// Buffers of streams that were not loaded are empty (0 x 0).
struct ClipFrame {
  int number = 0;
  bool cut = false;  // the first frame of a sequence too: no frame is before it
  Vec2 jitter;
  std::optional<CameraMatrices> camera;  // where the sequence has one that is valid
  ImageBuffer color, depth;
  MotionBuffer motion;
  ImageBuffer reference, reference_depth;
  MotionBuffer reference_motion;
  ImageBuffer reactive;
  // How much of each pixel the colour covers, as R = G = B; colour is premultiplied by it.
  ImageBuffer alpha, reference_alpha;

  RenderedFrame Rendered() const;    // color, depth, motion and reactive with its jitter
  DisplayedFrame Displayed() const;  // the references, as a display shows them
};

// Colour is RGBA8 where the sequence is sRGB and its files have 8 bits, else RGBA32F; so is alpha,
// and colour beside an alpha is RGBA32F.
struct Clip {
  std::string name;
  GridSize render, output;
  std::vector<GridSize> render_sizes;  // of each frame, where they vary; else empty
  ColorEncoding encoding = ColorEncoding::kDisplay;
  // The distance of depth 1 in units of the cameras' matrices, for `depth` and `reference_depth`.
  double depth_unit = 1, reference_depth_unit = 1;
  bool quantised_motion = false;  // HasQuantisedMotion, if it was asked for
  // Channels of linear colour that were above kLargestHdr or infinite, of `color` and of
  // `reference`.
  std::int64_t limited_color = 0, limited_reference = 0;
  std::vector<ClipFrame> frames;
};

// The motion that goes through the motion filter (runtime/motion_filter.h) before it is composed.
// The noise of quantisation adds up in composed motion, and the filter finds the camera of one
// frame, not that of several.
enum class MotionFiltering { kOff, kQuantised, kOn };

// Loads the streams `which` of frames [first, first + count) by index. The motion of each frame
// starts at the frame `every` before it in the sequence. It is composed along the frames between,
// so that a clip can be taken from every `every`-th frame. A frame with a cut between is a cut.
// With every > 1 motion is filtered before it is composed, as `filtering` says (kQuantised: if that
// of some frame is quantised). With every == 1 motion is not filtered here; kQuantised sets
// `quantised_motion` for the passes.
// The first frame of a sequence is a cut, whatever its motion: engines write 0 there, or the motion
// since a frame that was never shown. Linear colour beyond kLargestHdr is limited (LimitHdr) and
// counted. Errors are those of LoadFrame.
Clip LoadClip(const Sequence& sequence, int first, int count, Streams which, int every = 1,
              MotionFiltering filtering = MotionFiltering::kOff);

// Whether every frame has a camera.
bool HasCameras(const Clip& clip);

// Whether the motion of some frame is quantised (train/replay/motion_step.h): that of the render
// grid, or of the output grid where that is not loaded.
bool HasQuantisedMotion(const Clip& clip);

}  // namespace warplut
