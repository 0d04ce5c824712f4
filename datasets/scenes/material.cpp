#include "datasets/scenes/material.h"

#include "datasets/scenes/hash.h"
#include "datasets/scenes/material_patterns.h"
#include "datasets/scenes/pattern.h"

namespace warplut::scenes {
namespace {

Surface Plain(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const Height grain = Fbm(uv * 9, 9 * w, 6, 0.8f, seed);
  return {.albedo = m.a * (1 + 0.16f * grain.value), .gloss = 0.1f};
}

Surface Squares(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const float light = Checker(uv / m.size, w / m.size);
  const Height grain = Fbm(uv * 6, 6 * w, 7, 0.75f, seed);
  return {.albedo = Mix(m.b, m.a, light) * (1 + 0.2f * grain.value), .gloss = 0.25f};
}

Surface Wash(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const Height clouds = Fbm(uv / m.size, w / m.size, 2, 0.5f, seed);
  return {.albedo = Mix(m.a, m.b, SmoothStep(-0.5f, 0.5f, clouds.value))};
}

}  // namespace

Surface Evaluate(const Material& material, Vec2f uv, float footprint, std::uint32_t variation,
                 float time) {
  const std::uint32_t seed = Hash(material.seed, variation);
  const float w = footprint;
  switch (material.pattern) {
    case Pattern::kPlain:
      return Plain(material, uv, w, seed);
    case Pattern::kBrick:
      return Brick(material, uv, w, seed);
    case Pattern::kPlaster:
      return Plaster(material, uv, w, seed);
    case Pattern::kPaving:
      return Paving(material, uv, w, seed);
    case Pattern::kAsphalt:
      return Asphalt(material, uv, w, seed);
    case Pattern::kPlanks:
      return Planks(material, uv, w, seed);
    case Pattern::kFacade:
      return Facade(material, uv, w, seed);
    case Pattern::kSign:
      return Sign(material, uv, w, seed);
    case Pattern::kPoster:
      return Poster(material, uv, w, seed);
    case Pattern::kGround:
      return Ground(material, uv, w, seed);
    case Pattern::kRock:
      return Rock(material, uv, w, seed);
    case Pattern::kBark:
      return Bark(material, uv, w, seed);
    case Pattern::kLeaf:
      return Leaf(material, uv, w, seed);
    case Pattern::kBlade:
      return Blade(material, uv, w, seed);
    case Pattern::kMetal:
      return Metal(material, uv, w, seed);
    case Pattern::kStripes:
      return Stripes(material, uv, w, seed);
    case Pattern::kChecker:
      return Squares(material, uv, w, seed);
    case Pattern::kCorrugated:
      return Corrugated(material, uv, w, seed);
    case Pattern::kWater:
      return Water(material, uv, w, seed, time);
    case Pattern::kMirror:
      return {.albedo = material.a};
    case Pattern::kLattice:
      return {.albedo = material.a, .gloss = 0.4f};
    case Pattern::kWash:
      return Wash(material, uv, w, seed);
    case Pattern::kLamp:
      return {.albedo = Rgb(0, 0, 0), .emission = material.a};
  }
  return {};
}

bool Covers(const Material& material, Vec2f uv) {
  if (material.pattern == Pattern::kLeaf) return LeafCovers(material, uv);
  constexpr float kWire = 0.09f;  // width over the side of a mesh
  const Vec2f p =
      Vec2f(uv.x() + uv.y(), uv.x() - uv.y()) * (std::numbers::sqrt2_v<float> / 2 / material.size);
  return p.x() - std::floor(p.x()) < kWire || p.y() - std::floor(p.y()) < kWire;
}

}  // namespace warplut::scenes
