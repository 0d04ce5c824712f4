// A built-in scene as another exporter would have written it, with a manifest that does not know.
#pragma once

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/scenes/scene_renderer.h"
#include "datasets/sequence/sequence_writer.h"

namespace warplut {

// Frames of a scene, rendered once, and written in any convention.
class SceneFrames {
 public:
  SceneFrames(const std::string& name, int frames, int width, int height)
      : options_{.width = width, .height = height, .frames = frames, .samples = 4},
        renderer_(name, options_),
        name_(name) {
    for (int i = 0; i < frames; ++i) frames_.push_back(renderer_.Render(i));
  }

  std::vector<Frame>& frames() { return frames_; }

  // The manifest of the frames as they are.
  Sequence Stated() const {
    Sequence s = StandardSequence(
        name_, 0, options_.frames, {renderer_.render_width(), renderer_.render_height()},
        {options_.width, options_.height}, ColorSpace::kSrgb,
        Streams::kColor | Streams::kDepth | Streams::kMotion | Streams::kReference,
        renderer_.near_plane(), renderer_.far_plane());
    s.jitter = renderer_.Jitter();
    s.cuts = renderer_.Cuts();
    return s;
  }

  // Writes the frames in the convention of `truth`, with the manifest of `stated`.
  void Write(const std::filesystem::path& folder, const Sequence& truth,
             const Sequence& stated) const {
    const SequenceWriter writer(folder, truth);
    for (int i = 0; i < truth.count; ++i) {
      writer.Write(i, frames_[static_cast<std::size_t>(i)]);
    }
    WriteFile(folder / Sequence::kManifest, SequenceJson(stated));
  }

 private:
  RenderOptions options_;
  SceneRenderer renderer_;
  std::string name_;
  std::vector<Frame> frames_;
};

// `image` with the value of each pixel and channel computed.
inline Image Mapped(const Image& image, const std::function<float(int, int, int, float)>& value) {
  Image mapped = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < image.channels; ++c) {
        mapped.at(x, y, c) = value(x, y, c, image.at(x, y, c));
      }
    }
  }
  return mapped;
}

}  // namespace warplut
