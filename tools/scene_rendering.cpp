#include "tools/scene_rendering.h"

#include <fmt/format.h>

#include <algorithm>

#include "datasets/error.h"
#include "datasets/sequence/sequence_writer.h"
#include "train/ranks/ranks.h"

namespace warplut {

std::vector<std::string> SelectScenes(const std::string& selection) {
  std::vector<std::string> selected;
  std::string known;
  for (const SceneInfo& scene : Scenes()) {
    known += fmt::format("{}, ", scene.name);
    if (selection == "all" || selection == scene.name || selection == Name(scene.use)) {
      selected.emplace_back(scene.name);
    }
  }
  if (selected.empty()) {
    throw Error(fmt::format("'{}' is not a scene; expected {}training, held-out, fault or all.",
                            selection, known));
  }
  return selected;
}

void RenderScene(const std::string& scene, const RenderOptions& options, Streams which,
                 const std::filesystem::path& folder, const std::function<void()>& on_frame) {
  const SceneRenderer renderer(scene, options);
  Sequence sequence = StandardSequence(
      scene, 0, options.frames, {renderer.render_width(), renderer.render_height()},
      {options.width, options.height}, options.linear ? ColorSpace::kLinear : ColorSpace::kSrgb,
      which, renderer.near_plane(), renderer.far_plane());
  sequence.jitter = renderer.Jitter();
  sequence.cuts = renderer.Cuts();
  for (int index = 0; index < options.frames; ++index) {
    sequence.camera.push_back(renderer.CameraAt(index));
  }
  // The root prepares the folder, every rank writes its share of the frames, the root ends.
  Ranks& ranks = Ranks::World();
  if (ranks.IsRoot()) SequenceWriter(folder, sequence);
  ranks.Meet();
  const SequenceWriter writer(folder, sequence);
  ranks.Meet();
  for (int index = ranks.rank(); index < options.frames; index += ranks.count()) {
    on_frame();
    if (!writer.Has(index)) writer.Write(index, renderer.Render(index));
  }
  on_frame();
  ranks.Meet();
  if (ranks.IsRoot()) writer.Finish();
  ranks.Meet();
}

Streams ParseStreams(const std::vector<std::string>& names) {
  const std::vector<std::string> known = StreamNames(Streams::kAll);
  Streams streams = Streams::kNone;
  for (const std::string& name : names) {
    const auto place = std::find(known.begin(), known.end(), name);
    if (place == known.end()) {
      throw Error(fmt::format("'{}' is not a stream; expected {}.", name, fmt::join(known, ", ")));
    }
    streams = streams | static_cast<Streams>(1 << (place - known.begin()));
  }
  return streams;
}

}  // namespace warplut
