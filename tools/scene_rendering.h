// A built-in scene, rendered into a sequence on disk.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "datasets/scenes/scene_renderer.h"
#include "datasets/sequence/sequence.h"

namespace warplut {

// The scenes that `selection` names: one scene, "all", "training" or "held-out". An Error names
// what was found and which scenes there are.
std::vector<std::string> SelectScenes(const std::string& selection);

// Renders the streams `which` (color is among them) of a scene into `folder`, a sequence of the
// usual layout. Frames that are there already are kept, so that an interrupted rendering goes on.
// `on_frame` is called before each frame and once at the end; what it throws leaves whole frames
// and no manifest. A collective call of Ranks::World(), whose ranks share the frames.
void RenderScene(const std::string& scene, const RenderOptions& options, Streams which,
                 const std::filesystem::path& folder, const std::function<void()>& on_frame);

// The streams of a comma-separated list of their names. An Error names what was found.
Streams ParseStreams(const std::vector<std::string>& names);

}  // namespace warplut
