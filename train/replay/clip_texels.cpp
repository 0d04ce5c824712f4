#include "train/replay/clip_texels.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "datasets/error.h"

namespace warplut {
namespace {

struct Texel {
  int x = 0, y = 0;
};

int Nearest(double jitter, int scale) {
  return std::clamp(static_cast<int>(std::floor(scale * (0.5 + jitter))), 0, scale - 1);
}

// The pixels (scale.x i + texel.x, scale.y j + texel.y) of `from`.
ImageBuffer TakePixels(const ImageView& from, GridSize render, Texel scale, Texel texel) {
  ImageBuffer buffer(render.width, render.height, from.format);
  const auto bytes = static_cast<std::size_t>(BytesPerPixel(from.format));
  const MutableImageView to = buffer.view();
  for (int y = 0; y < render.height; ++y) {
    for (int x = 0; x < render.width; ++x) {
      std::memcpy(to.At(x, y), from.At(scale.x * x + texel.x, scale.y * y + texel.y), bytes);
    }
  }
  return buffer;
}

MotionBuffer TakeMotion(const MotionView& from, GridSize render, Texel scale, Texel texel) {
  MotionBuffer buffer(render.width, render.height);
  const MutableMotionView to = buffer.view();
  for (int y = 0; y < render.height; ++y) {
    const float* row = from.Row(scale.y * y + texel.y);
    for (int x = 0; x < render.width; ++x) {
      const float* m = row + 2 * (scale.x * x + texel.x);
      to.Row(y)[2 * x] = m[0] / static_cast<float>(scale.x);
      to.Row(y)[2 * x + 1] = m[1] / static_cast<float>(scale.y);
    }
  }
  return buffer;
}

void CheckClip(const Clip& clip, Texel scale) {
  if (scale.x * clip.render.width != clip.output.width ||
      scale.y * clip.render.height != clip.output.height) {
    throw Error(fmt::format(
        "the sequence '{}' has {} x {} rendered and {} x {} wanted; texels of the reference need a "
        "whole scale",
        clip.name, clip.render.width, clip.render.height, clip.output.width, clip.output.height));
  }
  for (const ClipFrame& frame : clip.frames) {
    if (frame.reference.view().width == 0 || frame.reference_depth.view().width == 0 ||
        frame.reference_motion.view().width == 0) {
      throw Error(fmt::format(
          "frame {} of '{}' has not all of reference, reference_depth and reference_motion; texels "
          "are taken of these",
          frame.number, clip.name));
    }
  }
}

}  // namespace

void TakeTexels(Clip& clip) {
  const Texel scale = {clip.output.width / clip.render.width,
                       clip.output.height / clip.render.height};
  CheckClip(clip, scale);
  const bool jittered = std::any_of(
      clip.frames.begin(), clip.frames.end(),
      [](const ClipFrame& frame) { return frame.jitter.x != 0 || frame.jitter.y != 0; });
  tbb::parallel_for(std::size_t{0}, clip.frames.size(), [&](std::size_t i) {
    ClipFrame& frame = clip.frames[i];
    const int turn = static_cast<int>(i) % (scale.x * scale.y);
    const Texel texel =
        jittered ? Texel{Nearest(frame.jitter.x, scale.x), Nearest(frame.jitter.y, scale.y)}
                 : Texel{turn % scale.x, turn / scale.x};
    frame.color = TakePixels(frame.reference.view(), clip.render, scale, texel);
    frame.depth = TakePixels(frame.reference_depth.view(), clip.render, scale, texel);
    frame.motion = TakeMotion(frame.reference_motion.view(), clip.render, scale, texel);
    frame.jitter = {(texel.x + 0.5) / scale.x - 0.5, (texel.y + 0.5) / scale.y - 0.5};
  });
}

}  // namespace warplut
