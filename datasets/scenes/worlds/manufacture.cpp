// Boards, signs, pictures and sheet metal.
#include "datasets/scenes/hash.h"
#include "datasets/scenes/material_patterns.h"
#include "datasets/scenes/pattern.h"

namespace warplut::scenes {

Surface Planks(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const float x = uv.x() / m.size, wx = w / m.size;
  const auto board =
      Hash(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(x))), seed);
  const float body = Pulse(x - 0.04f, 0.96f, wx);
  const float contrast = CellContrast(m.size, w);
  // Grain runs along the board.
  const Vec2f along(uv.x() * 60, uv.y() * 3 + 17 * Unit(board));
  const Height grain = Fbm(along, 60 * w, 5, 0.8f, board);
  const Height coarse = Fbm(along * 0.2f, 12 * w, 4, 0.8f, board + 1);
  const float tone = 1 + contrast * 0.5f * (Unit(Hash(board)) - 0.5f);
  Surface s{.albedo = Mix(m.b, m.a * tone, body) * (1 + 0.35f * grain.value + 0.4f * coarse.value),
            .gloss = 0.1f};
  s.slope = Vec2f(0.04f * grain.dx, 0);
  return s;
}

Surface Sign(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const float ink = m.text->Ink(uv / m.size, w / m.size);
  const Height wear = Fbm(uv * 5, 5 * w, 8, 0.75f, seed);
  const Rgb paint = Mix(m.a, m.b, ink);
  return {.albedo = paint * (1 + 0.15f * wear.value), .gloss = 0.2f};
}

Surface Poster(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const Vec2f p = uv / m.size;
  const float wp = w / m.size;
  const Height warp = Fbm(p * 1.5f, 1.5f * wp, 7, 0.7f, seed);
  Rgb paint = Mix(m.a, m.b, Saturate(0.5f + warp.value));
  for (std::uint32_t k = 0; k < 6; ++k) {
    const std::uint32_t h = Hash(seed, k);
    const Rgb colour(0.05f + 0.8f * Unit(Hash(h, 1U)), 0.05f + 0.7f * Unit(Hash(h, 2U)),
                     0.05f + 0.7f * Unit(Hash(h, 3U)));
    const Vec2f centre(Unit(Hash(h, 4U)) * 1.6f, Unit(Hash(h, 5U)) * 1.2f);
    const float size = 0.08f + 0.3f * Unit(Hash(h, 6U));
    const Vec2f d = p - centre;
    float shape = 0;
    if (h % 3 == 0) {
      shape = Step(size - d.norm(), wp);
      shape *= 0.35f + 0.65f * Pulse(d.norm() / 0.03f, 0.5f, wp / 0.03f);
    } else if (h % 3 == 1) {
      shape = Step(size - std::abs(d.x()), wp) * Step(0.5f * size - std::abs(d.y()), wp);
      shape *= 0.3f + 0.7f * Checker(d / 0.035f, wp / 0.035f);
    } else {
      const float slant = d.x() * 0.8f + d.y() * 0.6f;
      shape = Step(0.1f * size - std::abs(slant), wp);
    }
    paint = Mix(paint, colour, 0.9f * shape);
  }
  const Height canvas = Fbm(uv * 60, 60 * w, 4, 0.9f, seed + 11);
  return {.albedo = paint * (1 + 0.25f * canvas.value),
          .slope = 0.02f * Vec2f(canvas.dx, canvas.dy)};
}

Surface Metal(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const Height brushed = Fbm(Vec2f(uv.x() * 4, uv.y() * 160), 160 * w, 3, 0.8f, seed);
  const Height spots = Fbm(uv * 3, 3 * w, 9, 0.75f, seed + 1);
  const float rust = SmoothStep(0.25f, 0.7f, spots.value);
  Surface s{.albedo = Mix(m.a * (1 + 0.3f * brushed.value), m.b, rust), .gloss = 0.7f * (1 - rust)};
  s.slope = Vec2f(0, 0.001f * brushed.dy);
  return s;
}

Surface Stripes(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const float across = (uv.x() + uv.y()) / m.size;
  const float band = Pulse(across, 0.5f, 1.4f * w / m.size);
  const Height wear = Fbm(uv * 8, 8 * w, 7, 0.8f, seed);
  const float chipped = SmoothStep(0.35f, 0.6f, wear.value);
  const Rgb paint = Mix(m.b, m.a, band) * (1 + 0.2f * wear.value);
  return {.albedo = Mix(paint, Rgb(0.22f, 0.16f, 0.12f), chipped), .gloss = 0.3f * (1 - chipped)};
}

Surface Corrugated(const Material& m, Vec2f uv, float w, std::uint32_t seed) {
  const float phase = static_cast<float>(2 * kPi) * uv.x() / m.size;
  const float visible = CellContrast(m.size, w);
  const Height rust = Fbm(uv.cwiseProduct(Vec2f(2.5f, 0.8f)), 2.5f * w, 9, 0.78f, seed);
  const float bare = SmoothStep(0.2f, 0.6f, rust.value);
  Surface s{.albedo = Mix(m.a, m.b, bare) * (1 + 0.25f * rust.value), .gloss = 0.3f * (1 - bare)};
  s.slope = Vec2f(0.9f * visible * std::sin(phase), 0);
  return s;
}

}  // namespace warplut::scenes
