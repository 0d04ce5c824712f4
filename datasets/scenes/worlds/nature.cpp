// Ground, bark, leaves, grass and water.
#include "datasets/scenes/hash.h"
#include "datasets/scenes/material_patterns.h"
#include "datasets/scenes/pattern.h"

namespace warplut::scenes {
namespace {

// The leaf that belongs to the cell of a point, in its own axes: x across, y along, in units of its
// half length. Rows of cells are shifted at random; some cells are bare.
struct LeafCell {
  Vec2f at;
  std::uint32_t hash;
  float half_length;  // in cells
};

LeafCell FindLeaf(const Material& m, Vec2f uv) {
  const Vec2f p = uv / m.size;
  const std::int32_t row = Floor(p.y());
  const std::uint32_t row_hash = Hash(static_cast<std::uint32_t>(row), m.seed);
  const float x = p.x() + Unit(row_hash);
  const std::int32_t column = Floor(x);
  const std::uint32_t hash = Hash(static_cast<std::uint32_t>(column), row_hash);
  const float half = 0.30f + 0.12f * Unit(Hash(hash, 4U));
  const Vec2f centre(0.42f + 0.16f * Unit(Hash(hash, 1U)), 0.42f + 0.16f * Unit(Hash(hash, 2U)));
  const Vec2f d =
      (Vec2f(x - static_cast<float>(column), p.y() - static_cast<float>(row)) - centre) / half;
  const float angle = static_cast<float>(2 * kPi) * Unit(Hash(hash, 3U));
  const float c = std::cos(angle), s = std::sin(angle);
  return {{c * d.x() + s * d.y(), c * d.y() - s * d.x()}, hash, half};
}

}  // namespace

Surface Ground(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const Height patch = Fbm(uv * 0.15f, 0.15f * w, 9, 0.72f, seed);
  const Height blades = Fbm(uv * 18, 18 * w, 6, 0.95f, seed + 4);
  const float grass = SmoothStep(-0.25f, 0.35f, patch.value + 0.25f * blades.value);
  Surface s{.albedo = Mix(m.a, m.b, grass) * (1 + 0.45f * blades.value)};
  s.slope = 0.06f * Vec2f(blades.dx, blades.dy);
  return s;
}

Surface Bark(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const Height ridges = Fbm(Vec2f(uv.x() * 22, uv.y() * 4), 22 * w, 6, 0.85f, seed);
  Surface s{.albedo = Mix(m.b, m.a, SmoothStep(-0.5f, 0.4f, ridges.value))};
  s.slope = Vec2f(0.5f * ridges.dx, 0.2f * ridges.dy);
  return s;
}

Surface Leaf(const Material& m, Vec2f uv, float w, std::uint32_t) {
  const LeafCell leaf = FindLeaf(m, uv);
  const float wl = w / (m.size * leaf.half_length);
  const float veins = Pulse(leaf.at.y() * 4 + 1.6f * std::abs(leaf.at.x()), 0.3f, 4 * wl);
  const float rib = Step(0.06f - std::abs(leaf.at.x()), wl);
  const float tone = 0.65f + 0.7f * Unit(Hash(leaf.hash, 5U));
  const Rgb green = Mix(m.a, m.b, Unit(Hash(leaf.hash, 6U)));
  const float pale = std::max(rib, 0.35f * veins);
  return {.albedo = green * (tone * (1 + 0.7f * pale)),
          .slope = Vec2f(0.6f * leaf.at.x(), 0.3f * leaf.at.y()),
          .gloss = 0.15f,
          .translucency = 0.45f};
}

bool LeafCovers(const Material& m, Vec2f uv) {
  constexpr float kBare = 0.18f, kHalfWidth = 0.5f;
  const LeafCell leaf = FindLeaf(m, uv);
  const float y = leaf.at.y();
  // A pointed ellipse.
  return Unit(leaf.hash) >= kBare && std::abs(y) < 1 &&
         std::abs(leaf.at.x()) < kHalfWidth * (1 - y * y) * (1 - 0.25f * y);
}

Surface Blade(const Material& m, Vec2f uv, float, std::uint32_t seed) {
  const float tone = 0.7f + 0.6f * Unit(seed);
  return {
      .albedo = Mix(m.a, m.b, Saturate(1.6f * uv.y())) * tone, .gloss = 0.1f, .translucency = 0.4f};
}

Surface Water(const Material& m, Vec2f uv, float w, std::uint32_t seed, float time) {
  const Height swell = Fbm(uv * 0.5f + Vec2f(0.35f, 0.2f) * time, 0.5f * w, 4, 0.6f, seed);
  const Height ripple = Fbm(uv * 2.5f - Vec2f(0.6f, 0.9f) * time, 2.5f * w, 6, 0.62f, seed + 1);
  Surface s{.albedo = m.a, .gloss = 1};
  s.slope = 0.10f * Vec2f(swell.dx, swell.dy) + 0.035f * Vec2f(ripple.dx, ripple.dy);
  return s;
}

}  // namespace warplut::scenes
