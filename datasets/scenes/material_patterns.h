// The patterns behind Evaluate: w is the footprint in metres.
#pragma once

#include "datasets/scenes/material.h"

namespace warplut::scenes {

Surface Brick(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Plaster(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Paving(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Asphalt(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Facade(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Rock(const Material& m, Vec2f uv, float w, std::uint32_t seed);

Surface Planks(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Sign(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Poster(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Metal(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Stripes(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Corrugated(const Material& m, Vec2f uv, float w, std::uint32_t seed);

Surface Ground(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Bark(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Leaf(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Blade(const Material& m, Vec2f uv, float w, std::uint32_t seed);
Surface Water(const Material& m, Vec2f uv, float w, std::uint32_t seed, float time);
bool LeafCovers(const Material& m, Vec2f uv);

}  // namespace warplut::scenes
