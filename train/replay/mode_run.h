// Runs a method of the registry over a clip, as a renderer would, and passes on every frame that it
// shows.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runtime/executor.h"
#include "runtime/method.h"
#include "train/replay/clip.h"
#include "train/replay/mode_device.h"

namespace warplut {

// The least distance of alphas from 0, 1 and each other: times have a resolution of a thousandth.
inline constexpr float kAlphaStep = 0.001f;
inline constexpr int kMostGenerated = 64;

inline bool Generates(const MethodInfo& method) { return method.generation != Generation::kNone; }

struct ModeRunOptions {
  const MethodInfo* method = nullptr;
  // The clip's frames 0, every, 2 every, ... are rendered; the others serve for judging alone. The
  // clip was loaded with the same `every`.
  int every = 1;
  int generated = 1;          // frames between two rendered ones, at alpha = k / (generated + 1)
  std::vector<float> alphas;  // if not empty, these in place of `generated`: in (0, 1), ascending
  // Format of super-resolved frames; kRgba8 means kRgba16F if the clip is linear.
  PixelFormat shown_format = PixelFormat::kRgba8;
  // Templates: filter, formats, motion filter, parameters, gate width. Sizes and encoding come from
  // the clip, the rest from the method.
  SuperResolutionOptions super_resolution;
  FrameGenerationOptions generation;
  // Filters the motion of clips whose motion is quantised, whatever the templates say.
  bool filter_quantised_motion = false;
  ModeDevice* device = nullptr;  // outlives the run; null: the processor, by the run's executor

  // Whether the method can run on this clip (its streams are there, sizes fit) and on the device;
  // otherwise *why says what is missing.
  bool IsValid(const Clip& clip, std::string* why = nullptr) const;
};

// Whether `generated` and `alphas` make sense, for any clip; part of IsValid.
bool AreTimesValid(const ModeRunOptions& options, std::string* why = nullptr);

// Whether generation alone (without super resolution) takes the references of a sequence that has
// `available` as its frames: where they come with depth and motion, or the rendered frames do not.
// Otherwise it takes the rendered frames.
constexpr bool GeneratesFromReferences(Streams available) {
  return Contains(available, Streams::kReference) &&
         (Contains(available, Streams::kOutputGrid) || !Contains(available, Streams::kRenderGrid));
}

// The same for the streams that the first frame of the clip has.
bool GeneratesFromReferences(const Clip& clip);

// The streams that the method takes of a sequence that has `available`, whether it has them all or
// not.
Streams NeededStreams(const MethodInfo& method, Streams available);

// Whether the method accumulates a history, by super resolution.
bool HasHistory(const MethodInfo& method);

// The grid of the frames that the method shows of the clip.
GridSize ShownGrid(const Clip& clip, const MethodInfo& method);

// The name of a needed stream that a frame of the clip lacks, or null.
const char* MissingStream(const ClipFrame& frame, const Clip& clip, Streams needed);

// The times of generated frames, as shares of the time between two rendered ones.
std::vector<float> Alphas(const ModeRunOptions& options);

// The options that RunMode gives to the runtime: the templates with the choices of the method, the
// paper's parameters for the paper's methods, and the clip's sizes and encoding.
SuperResolutionOptions EffectiveSuperResolution(const Clip& clip, const ModeRunOptions& options);
FrameGenerationOptions EffectiveGeneration(const Clip& clip, const ModeRunOptions& options);

// One frame that was shown. `image` is valid during the call.
struct ShownFrame {
  double time = 0;  // in frames of the clip; whole numbers have a reference
  bool generated = false;
  int frame = -1;         // index in the clip if `time` is whole, else -1
  ImageView image;        // on the grid of the method, in the clip's encoding
  double seconds = 0;     // that the runtime took to make it; 0 if it was there
  FrameTiles tiles = {};  // of the passes that made it
};
using ShownFrameSink = std::function<void(const ShownFrame&)>;

// Shows frames in the order of time. Generation alone (without super resolution) takes the frames
// that GeneratesFromReferences says, by the streams of the clip. A rendered frame follows every
// generated one, except the last extrapolated ones. Extrapolation begins after the second rendered
// frame. The options must be valid. An exception of the sink ends the run.
void RunMode(const Clip& clip, const ModeRunOptions& options, Executor& executor,
             const ShownFrameSink& sink);

}  // namespace warplut
