// Trajectories of repeated warps: the protocols that filters are trained on and judged by.
//
// A trajectory is a list of displacements v in pixels, x right, y down; warp i replaces image x by
// x(p - v[i]). A filter depends on the fraction of v alone. The whole part is chosen so
// that the image stays within a pixel of where it began. At each horizon the displacements add up
// to exactly zero, so that the image should then be the one that it began with: an exact reference.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace warplut {

enum class Offsets : std::uint8_t { kHalf, kRandom, kPan };

constexpr const char* Name(Offsets offsets) {
  return offsets == Offsets::kHalf ? "half" : offsets == Offsets::kRandom ? "random" : "pan";
}

// How filters are compared: by what is left after so many warps.
struct Protocol {
  int warps = 6;  // even where offsets are half
  Offsets offsets = Offsets::kHalf;
};

// Components in (-1, 1), multiples of a step of MakeTrajectory.
struct Displacement {
  double x = 0;
  double y = 0;
};

// The displacements of horizons.back() warps.
//   kHalf    (1/2, 1/2) and (-1/2, -1/2) in turn; every horizon must be even.
//   kRandom  fractions uniform on the multiples of 1 / steps, but for the last warp before each
//            horizon, which returns to the start. With steps = kNodes every offset is a node; a
//            large one stands for any offset.
//   kPan     one and the same fraction at every warp: what a camera does that turns at constant
//            speed. A filter that moves the image by a little more or less than asked drifts here,
//            while random offsets hide it. Let g be the greatest common divisor of the horizons.
//            Where g is a multiple of kNodes, the fraction is that of a random node, and steps must
//            be a multiple of kNodes. Any other g must be at least 2: the fraction is j / g with j
//            uniform on 0..g - 1 in each axis, but not 0 in both, whatever `steps` is.
// Displacements are counted in whole steps, whose sums are exact: 1 / g for a pan off the nodes,
// 1 / steps otherwise. Each component is the double next to its count of steps.
// Horizons are ascending and at least 1. The same arguments give the same trajectory on every
// machine.
std::vector<Displacement> MakeTrajectory(Offsets offsets, std::span<const int> horizons, int steps,
                                         std::uint64_t seed);

}  // namespace warplut
