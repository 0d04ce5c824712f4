// What is asked of the comparison of rays on the screen.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/peers/rays/screen_mesh.h"

namespace warplut {

struct ReflectionSettings {
  int width = 960, height = 540;
  int frame = 0;      // of the scene's clock, 30 per second
  int step = 4;       // pixels between rays, in each axis
  double within = 4;  // pixels: a hit so near to the true one is found
  std::vector<int> tiles = {4, 8, 16};
  // Shares of the depth.
  std::vector<double> thicknesses = {0.01, 0.05, 0.25};
  float tear = peers::ScreenMeshOptions().tear;
  std::uint64_t seed = 1;

  // Otherwise *why (if not null) names the setting and its range.
  bool IsValid(std::string* why = nullptr) const;
};

}  // namespace warplut
