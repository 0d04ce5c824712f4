// Things that several scenes use: a palette of materials, and meshes made of them. Props stand on y
// = 0 around the origin and face +z.
#pragma once

#include <cstdint>

#include "datasets/scenes/hash.h"
#include "datasets/scenes/world.h"

namespace warplut::scenes {

// Material numbers in a world; colours vary with the seed.
struct Palette {
  int brick, roof, plaster, stone, paving, asphalt, planks, facade, ground, rock, bark, leaf, blade,
      metal, dark;
  int stripes, checker, sheet, lattice, lamp, white;
};

Palette AddPalette(World& world, std::uint64_t seed);

// A house with a pitched roof along x, a plinth and a cornice.
Mesh House(const Palette& p, float width, float height, float depth, int wall);
// A flat-roofed block with ledges between the storeys.
Mesh Block(const Palette& p, float width, float height, float depth, int wall);
Mesh LampPost(const Palette& p, float height);
// A panel on two posts; the lettering faces +z, planks the other way.
Mesh SignBoard(const World& world, const Palette& p, int sign, float clearance);
// A panel with lettering alone, centred on the origin, both faces lettered.
Mesh Panel(const World& world, int sign);
Mesh Tree(const Palette& p, Random random, float height);
Mesh Bush(const Palette& p, Random random, float radius);
// Blades of grass, scattered over a disc.
Mesh Grass(const Palette& p, Random random, int blades, float radius, float height);
// Woven wire between posts, along x, centred.
Mesh Fence(const Palette& p, float length, float height);
// Upright bars between rails, along x, centred.
Mesh Railing(const Palette& p, float length, float height, float spacing);
Mesh Crate(const Palette& p, float side);
// A wheel in the plane of x and y, centred on the origin, with thin spokes.
Mesh Wheel(float radius, int spokes, float thickness, int rim, int spoke);
// A fluted column with base and capital.
Mesh Column(const Palette& p, float radius, float height);

}  // namespace warplut::scenes
