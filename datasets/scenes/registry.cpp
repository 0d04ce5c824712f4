#include <array>

#include "datasets/scenes/builtin.h"
#include "datasets/scenes/scene_renderer.h"

namespace warplut {
namespace {

constexpr std::array<SceneInfo, 9> kScenes = {{
    {"still", "nothing moves but the jitter: what accumulation alone can reach", true},
    {"courtyard", "static camera, moving and turning objects in front of brick and lettering",
     true},
    {"street", "camera pans while it travels: facades, wires and signs over large sub-pixel motion",
     true},
    {"meadow", "foliage and alpha-tested leaves in the wind, a walking camera over terrain", true},
    {"machinery", "fast thin objects: spokes, rods, wires and woven fences", true},
    {"plaza", "moving shadows and changing light on surfaces that stand still", true},
    {"gallery", "a large mirror: motion of the reflected point", false},
    {"harbour", "camera cuts between takes of rigging, containers and water", false},
    {"colonnade", "near columns pass the camera: wide disocclusion of fine detail", false},
}};

}  // namespace

std::span<const SceneInfo> Scenes() { return kScenes; }

namespace scenes {

std::span<const Builder> Builders() {
  static constexpr std::array<Builder, kScenes.size()> kBuilders = {
      Still, Courtyard, Street, Meadow, Machinery, Plaza, Gallery, Harbour, Colonnade};
  return kBuilders;
}

}  // namespace scenes
}  // namespace warplut
