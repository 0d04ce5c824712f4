// Runs a method of the registry over a clip, as a renderer would, and hands over every frame that it shows.
#pragma once

#include <functional>
#include <string>

#include "runtime/executor.h"
#include "runtime/method.h"
#include "train/clip.h"

namespace warplut {

struct ModeRunOptions {
  const MethodInfo* method = nullptr;
  // The clip's frames 0, every, 2 every, ... are rendered; the others are only there to judge by. The clip was loaded with
  // the same `every`.
  int every = 1;
  int generated = 1;  // frames between two rendered ones, at alpha = k / (generated + 1)
  // Templates: filter, formats, motion filter, parameters, gate width. Sizes and encoding come from the clip, the rest from the method.
  SuperResolutionOptions super_resolution;
  FrameGenerationOptions generation;

  // Whether the method can run on this clip (its streams are there, sizes fit); otherwise *why says what is missing.
  bool IsValid(const Clip& clip, std::string* why = nullptr) const;
};

// One frame that was shown. `image` is valid during the call.
struct ShownFrame {
  double time = 0;  // in frames of the clip; whole numbers have a reference
  bool generated = false;
  int frame = -1;   // index in the clip if `time` is whole, else -1
  ImageView image;  // on the grid of the method, in the clip's encoding
};
using ShownFrameSink = std::function<void(const ShownFrame&)>;

// Shows frames in the order of time. Generation alone (without super resolution) takes the references as its sources, or the
// rendered frames where the clip has none. Every generated frame is followed by the rendered frame after it, save the last
// extrapolated ones. Options must be valid.
void RunMode(const Clip& clip, const ModeRunOptions& options, Executor& executor,
             const ShownFrameSink& sink);

}  // namespace warplut
