// A clip of a built-in scene, and clips whose references are what the pipeline itself shows.
#pragma once

#include <memory>
#include <string>

#include "datasets/scenes/scene_renderer.h"
#include "train/replay/image_views.h"
#include "train/replay/mode_run.h"

namespace warplut {

struct SceneClipOptions {
  std::string scene = "street";
  int width = 128, height = 96;  // of the output
  double scale = 2;
  int frames = 6;
};

inline Clip SceneClip(const SceneClipOptions& options = {}) {
  const SceneRenderer renderer(options.scene, {.width = options.width,
                                               .height = options.height,
                                               .scale = options.scale,
                                               .frames = options.frames,
                                               .samples = 4});
  Clip clip;
  clip.name = options.scene;
  clip.render = {renderer.render_width(), renderer.render_height()};
  clip.output = {options.width, options.height};
  for (int i = 0; i < options.frames; ++i) {
    const Frame frame = renderer.Render(i);
    ClipFrame& out = clip.frames.emplace_back();
    out.number = i;
    out.cut = frame.cut;
    out.jitter = frame.jitter;
    out.color = ToBuffer(frame.color, PixelFormat::kRgba32F);
    out.depth = ToBuffer(frame.depth, PixelFormat::kR32F);
    out.motion = ToMotionBuffer(frame.motion);
    out.reference = ToBuffer(frame.reference, PixelFormat::kRgba32F);
    out.reference_depth = ToBuffer(frame.reference_depth, PixelFormat::kR32F);
    out.reference_motion = ToMotionBuffer(frame.reference_motion);
  }
  return clip;
}

// Replaces the references by what super resolution shows with these parameters. For methods without
// generation.
inline Clip WithShownReferences(const Clip& clip, ModeRunOptions options,
                                const Parameters& parameters, Executor& executor) {
  Clip shown = SceneClip({.scene = clip.name,
                          .width = clip.output.width,
                          .height = clip.output.height,
                          .scale = static_cast<double>(clip.output.width) / clip.render.width,
                          .frames = static_cast<int>(clip.frames.size())});
  options.super_resolution.parameters = parameters;
  RunMode(clip, options, executor, [&](const ShownFrame& frame) {
    shown.frames[static_cast<std::size_t>(frame.frame)].reference =
        ToBuffer(ToImage(frame.image), PixelFormat::kRgba32F);
  });
  return shown;
}

}  // namespace warplut
