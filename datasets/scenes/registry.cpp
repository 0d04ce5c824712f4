#include <array>

#include "datasets/scenes/builtin.h"
#include "datasets/scenes/scene_renderer.h"

namespace warplut {
namespace {

constexpr std::array<SceneInfo, 11> kScenes = {{
    {"still", "nothing moves but the jitter: what accumulation alone can reach",
     SceneUse::kTraining},
    {"courtyard", "static camera, moving and turning objects in front of brick and lettering",
     SceneUse::kTraining},
    {"street", "camera pans while it travels: facades, wires and signs over large sub-pixel motion",
     SceneUse::kTraining},
    {"meadow", "foliage and alpha-tested leaves in the wind, a walking camera over terrain",
     SceneUse::kTraining},
    {"machinery", "fast thin objects: spokes, rods, wires and woven fences", SceneUse::kTraining},
    {"plaza", "moving shadows and changing light on surfaces that stand still",
     SceneUse::kTraining},
    {"penumbra", "soft shadows pass over a flat wall: light that changes with every sample",
     SceneUse::kFault},
    {"rims", "bright rims of a pixel's width before dark, swaying slowly: beads along thin lines",
     SceneUse::kFault},
    {"gallery", "a large mirror: motion of the reflected point", SceneUse::kHeldOut},
    {"harbour", "camera cuts between takes of rigging, containers and water", SceneUse::kHeldOut},
    {"colonnade", "near columns pass the camera: wide disocclusion of fine detail",
     SceneUse::kHeldOut},
}};

}  // namespace

std::string_view Name(SceneUse use) {
  switch (use) {
    case SceneUse::kTraining:
      return "training";
    case SceneUse::kHeldOut:
      return "held-out";
    case SceneUse::kFault:
      return "fault";
  }
  return "";
}

std::span<const SceneInfo> Scenes() { return kScenes; }

namespace scenes {

std::span<const Builder> Builders() {
  static constexpr std::array<Builder, kScenes.size()> kBuilders = {
      Still,    Courtyard, Street,  Meadow,  Machinery, Plaza,
      Penumbra, Rims,      Gallery, Harbour, Colonnade};
  return kBuilders;
}

}  // namespace scenes
}  // namespace warplut
