// Procedural materials: what a surface reflects at a point, averaged over a footprint.
#pragma once

#include <cstdint>

#include "datasets/scenes/linear.h"
#include "datasets/scenes/worlds/text.h"

namespace warplut::scenes {

enum class Pattern {
  kPlain,       // a, slightly mottled
  kBrick,       // bricks a in mortar b, size: length of a brick; roof tiles and cobbles too
  kPlaster,     // a with stains of b and fine grain
  kPaving,      // slabs a, joints b, size: side of a slab
  kAsphalt,     // a with grit of b
  kPlanks,      // boards a with gaps b along v, size: width of a board
  kFacade,      // wall a, window frames b, size: width of a window bay
  kSign,        // ground a, lettering b, size: width of a font texel
  kPoster,      // a picture of bands, discs and rules in colours a and b, size: its scale
  kGround,      // meadow floor: earth a, grass b
  kRock,        // a, b in layers, rough
  kBark,        // a with ridges along v
  kLeaf,        // card of leaves, cut out, size: side of a cell with one leaf
  kBlade,       // blade of grass, from a at the root to b at the tip (v = 1 m)
  kMetal,       // brushed along u
  kStripes,     // diagonal stripes a and b, size: period
  kChecker,     // squares a and b, size: side
  kCorrugated,  // sheet a with folds along v and rust b, size: period
  kWater,       // ripples that travel with time
  kMirror,      // reflects; a tints
  kLattice,     // woven wire a, cut out, size: side of a mesh
  kLamp,        // emits a
  kWash,        // a and b in soft clouds, without detail, size: that of a cloud
};

struct Material {
  Pattern pattern = Pattern::kPlain;
  Rgb a = Rgb(0.5f, 0.5f, 0.5f);
  Rgb b = Rgb(0.2f, 0.2f, 0.2f);
  float size = 1;  // metres
  std::uint32_t seed = 0;
  const Text* text = nullptr;  // of kSign

  bool CutOut() const { return pattern == Pattern::kLeaf || pattern == Pattern::kLattice; }
};

// What the light sees. slope tilts the normal: derivatives of the relief along u and v.
struct Surface {
  Rgb albedo = Rgb(0.5f, 0.5f, 0.5f);
  Vec2f slope = Vec2f::Zero();
  float gloss = 0;         // weight of the highlight and of the reflected sky
  float translucency = 0;  // share of the light from behind
  Rgb emission = Rgb(0, 0, 0);
};

// uv and footprint in metres; variation tells instances of a mesh apart; time in seconds moves the
// water only.
Surface Evaluate(const Material& material, Vec2f uv, float footprint, std::uint32_t variation,
                 float time);

// Whether a cut-out material has substance at uv.
bool Covers(const Material& material, Vec2f uv);

}  // namespace warplut::scenes
