// Brick, plaster, stone, asphalt and the fronts of houses.
#include "datasets/scenes/hash.h"
#include "datasets/scenes/material_patterns.h"
#include "datasets/scenes/pattern.h"

namespace warplut::scenes {
namespace {

std::uint32_t Cell(float x, float y, std::uint32_t seed) {
  return Hash(static_cast<std::uint32_t>(static_cast<std::int32_t>(x)),
              static_cast<std::uint32_t>(static_cast<std::int32_t>(y)), seed);
}

}  // namespace

Surface Brick(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  constexpr float kAspect = 0.34f;  // height over length
  constexpr float kJoint = 0.05f;   // width of a joint over the length
  const float x = uv.x() / m.size, y = uv.y() / (m.size * kAspect);
  const float wx = w / m.size, wy = wx / kAspect;
  const float row = std::floor(y);
  const float shifted = x + 0.5f * (row - 2 * std::floor(0.5f * row));
  const float joint_y = kJoint / kAspect;
  const float body = Pulse(shifted - kJoint, 1 - kJoint, wx) * Pulse(y - joint_y, 1 - joint_y, wy);
  const std::uint32_t cell = Cell(std::floor(shifted), row, seed);
  const float contrast = CellContrast(m.size * kAspect, w);
  const float tone = 1 + contrast * 0.55f * (Unit(cell) - 0.5f);
  const Height grain = Fbm(uv * 14, 14 * w, 7, 0.85f, seed);
  const Height stain = Fbm(uv * 0.6f, 0.6f * w, 4, 0.6f, seed + 7);
  Rgb clay = m.a * tone * Rgb(1, 1 + contrast * 0.25f * (Unit(Hash(cell)) - 0.5f), 1);
  clay *= 1 + 0.32f * grain.value;
  const Rgb mortar = m.b * (1 + 0.22f * grain.value);
  Surface s{.albedo = Mix(mortar, clay, body) * (1 + 0.35f * stain.value)};
  // The rims of a brick catch the light.
  const float fx = shifted - std::floor(shifted), fy = y - row;
  const float rim = contrast * 0.9f;
  s.slope = Vec2f(fx < 2 * kJoint ? rim : 0.f, fy < 2 * joint_y ? rim : 0.f) * body +
            0.10f * Vec2f(grain.dx, grain.dy);
  return s;
}

Surface Plaster(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const Height grain = Fbm(uv * 24, 24 * w, 6, 0.85f, seed);
  const Height stain = Fbm(uv.cwiseProduct(Vec2f(1.1f, 0.45f)), w, 8, 0.72f, seed + 3);
  const float dirt = SmoothStep(-0.15f, 0.75f, stain.value);
  // Cracks are the zero crossings of a slow noise.
  const Height crack = Fbm(uv * 0.7f, 0.7f * w, 5, 0.6f, seed + 9);
  const float width = 0.004f * 0.7f * std::sqrt(crack.dx * crack.dx + crack.dy * crack.dy);
  const float line = Saturate(width / std::max(w, 0.004f) / 0.7f) *
                     (1 - SmoothStep(width, width + 0.7f * w + 0.01f, std::abs(crack.value)));
  Surface s{.albedo = Mix(m.a, m.b, dirt) * (1 + 0.20f * grain.value) * (1 - 0.5f * line)};
  s.slope = 0.07f * Vec2f(grain.dx, grain.dy);
  return s;
}

Surface Paving(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  constexpr float kJoint = 0.035f;
  const Vec2f p = uv / m.size;
  const float wp = w / m.size;
  const float body = Pulse(p.x() - kJoint, 1 - kJoint, wp) * Pulse(p.y() - kJoint, 1 - kJoint, wp);
  const float contrast = CellContrast(m.size, w);
  const float tone =
      1 + contrast * 0.4f * (Unit(Cell(std::floor(p.x()), std::floor(p.y()), seed)) - 0.5f);
  const Height grain = Fbm(uv * 10, 10 * w, 8, 0.85f, seed);
  const Height stain = Fbm(uv * 0.35f, 0.35f * w, 5, 0.65f, seed + 5);
  Surface s{
      .albedo = Mix(m.b, m.a * tone, body) * (1 + 0.28f * grain.value) * (1 + 0.4f * stain.value),
      .gloss = 0.08f};
  s.slope = 0.06f * Vec2f(grain.dx, grain.dy);
  return s;
}

Surface Asphalt(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const Height grit = Fbm(uv * 45, 45 * w, 4, 0.95f, seed);
  const Height wear = Fbm(uv.cwiseProduct(Vec2f(0.9f, 0.25f)), w, 8, 0.7f, seed + 1);
  const float speck = SmoothStep(0.15f, 0.6f, grit.value);
  Surface s{.albedo = Mix(m.a * (1 + 0.3f * grit.value), m.b, speck) * (1 + 0.45f * wear.value),
            .gloss = 0.12f};
  s.slope = 0.03f * Vec2f(grit.dx, grit.dy);
  return s;
}

Surface Facade(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const float bay = m.size, storey = 1.25f * m.size;
  const float x = uv.x() / bay, y = uv.y() / storey;
  const float fx = x - std::floor(x), fy = y - std::floor(y);
  const float wx = w / bay, wy = w / storey;
  const std::uint32_t cell = Cell(std::floor(x), std::floor(y), seed);
  const auto inside = [&](float x0, float x1, float y0, float y1) {
    return Step(fx - x0, wx) * Step(x1 - fx, wx) * Step(fy - y0, wy) * Step(y1 - fy, wy);
  };
  const float opening = inside(0.24f, 0.76f, 0.22f, 0.80f);
  const float glass = inside(0.28f, 0.72f, 0.25f, 0.77f);
  const float bars =
      std::max(Step(0.012f - std::abs(fx - 0.5f), wx), Step(0.012f - std::abs(fy - 0.58f), wy));
  const float sill = inside(0.21f, 0.79f, 0.17f, 0.22f);
  Material wall = m;
  wall.size = 0.26f;
  wall.a = m.a;
  wall.b = m.a * 0.6f;
  Surface s = seed & 1 ? Brick(wall, uv, w, m.seed) : Plaster(wall, uv, w, m.seed);
  // A blind with slats hangs in some windows, behind the glass.
  const float drawn = 0.77f - 0.5f * Unit(Hash(cell, 3U));
  const float slats = Pulse(uv.y() / 0.055f, 0.6f, w / 0.055f);
  const float blind = Unit(cell) < 0.55f ? Step(fy - drawn, wy) : 0.f;
  const Rgb room = Rgb(0.03f, 0.035f, 0.045f) * (1 + 2 * Unit(Hash(cell, 9U)));
  const Rgb pane = Mix(room, Rgb(0.55f, 0.52f, 0.45f) * (0.35f + 0.65f * slats), blind);
  s.albedo = Mix(s.albedo, m.b, std::max(opening, sill));
  const float open_glass = glass * (1 - bars);
  s.albedo = Mix(s.albedo, pane, open_glass);
  s.slope *= 1 - opening;
  s.gloss = 0.8f * open_glass * (1 - 0.7f * blind);
  return s;
}

Surface Rock(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const Height rough = Fbm(uv * 1.7f, 1.7f * w, 10, 0.72f, seed);
  const Height layer =
      Fbm(Vec2f(uv.x() * 0.4f, uv.y() * 5 + 1.5f * rough.value), 5 * w, 6, 0.75f, seed + 2);
  Surface s{.albedo =
                Mix(m.a, m.b, SmoothStep(-0.5f, 0.5f, layer.value)) * (1 + 0.35f * rough.value)};
  s.slope = 0.20f * Vec2f(rough.dx, rough.dy);
  return s;
}

}  // namespace warplut::scenes
