// The built-in scenes: each function builds a world; the seed varies placement and textures.
#pragma once

#include <cstdint>
#include <span>

#include "datasets/scenes/world.h"

namespace warplut::scenes {

World Still(std::uint64_t seed);
World Courtyard(std::uint64_t seed);
World Street(std::uint64_t seed);
World Meadow(std::uint64_t seed);
World Machinery(std::uint64_t seed);
World Plaza(std::uint64_t seed);
World Penumbra(std::uint64_t seed);
World Rims(std::uint64_t seed);
World Gallery(std::uint64_t seed);
World Harbour(std::uint64_t seed);
World Colonnade(std::uint64_t seed);

using Builder = World (*)(std::uint64_t seed);

// In the order of Scenes().
std::span<const Builder> Builders();

}  // namespace warplut::scenes
