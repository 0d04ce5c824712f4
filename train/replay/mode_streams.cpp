// Which streams a method takes, and which a clip has.
#include "train/replay/mode_run.h"

namespace warplut {
namespace {

// Whether it is given motion and depth of its frames.
bool ReadsGeometry(const MethodInfo& method) {
  return Generates(method) && method.generator == Generator::kWarped && !method.optical_flow;
}

template <class Buffer>
bool IsOn(const Buffer& buffer, GridSize grid) {
  const auto view = buffer.view();
  return view.width == grid.width && view.height == grid.height;
}

// Whether a buffer of the render grid is there: of the size of the clip, or of any where it varies.
template <class Buffer>
bool IsRendered(const Buffer& buffer, const Clip& clip) {
  return clip.render_sizes.empty() ? IsOn(buffer, clip.render) : buffer.view().width > 0;
}

// The streams that the clip has of its first frame.
Streams LoadedStreams(const Clip& clip) {
  const ClipFrame& frame = clip.frames.front();
  Streams loaded = Streams::kNone;
  const auto add = [&](Streams stream, bool is_there) {
    if (is_there) loaded = loaded | stream;
  };
  add(Streams::kColor, IsRendered(frame.color, clip));
  add(Streams::kDepth, IsRendered(frame.depth, clip));
  add(Streams::kMotion, IsRendered(frame.motion, clip));
  add(Streams::kReference, IsOn(frame.reference, clip.output));
  add(Streams::kReferenceDepth, IsOn(frame.reference_depth, clip.output));
  add(Streams::kReferenceMotion, IsOn(frame.reference_motion, clip.output));
  return loaded;
}

}  // namespace

bool GeneratesFromReferences(const Clip& clip) {
  return GeneratesFromReferences(LoadedStreams(clip));
}

Streams NeededStreams(const MethodInfo& method, Streams available) {
  if (method.super_resolution) {
    return HasHistory(method) ? Streams::kRenderGrid | (available & Streams::kReactive)
                              : Streams::kColor;
  }
  if (GeneratesFromReferences(available)) {
    return ReadsGeometry(method) ? Streams::kOutputGrid : Streams::kReference;
  }
  return ReadsGeometry(method) ? Streams::kRenderGrid : Streams::kColor;
}

bool HasHistory(const MethodInfo& method) {
  if (!method.super_resolution) return false;
  SuperResolutionOptions options;
  method.configure_super_resolution(options);
  return options.history;
}

GridSize ShownGrid(const Clip& clip, const MethodInfo& method) {
  const bool on_output =
      method.super_resolution || (Generates(method) && GeneratesFromReferences(clip));
  return on_output ? clip.output : clip.render;
}

const char* MissingStream(const ClipFrame& frame, const Clip& clip, Streams needed) {
  const auto lacks = [&](Streams stream, bool is_there) {
    return Contains(needed, stream) && !is_there;
  };
  if (lacks(Streams::kColor, IsRendered(frame.color, clip))) return "color";
  if (lacks(Streams::kDepth, IsRendered(frame.depth, clip))) return "depth";
  if (lacks(Streams::kMotion, IsRendered(frame.motion, clip))) return "motion";
  if (lacks(Streams::kReference, IsOn(frame.reference, clip.output))) return "reference";
  if (lacks(Streams::kReferenceDepth, IsOn(frame.reference_depth, clip.output))) {
    return "reference_depth";
  }
  if (lacks(Streams::kReferenceMotion, IsOn(frame.reference_motion, clip.output))) {
    return "reference_motion";
  }
  return nullptr;
}

}  // namespace warplut
