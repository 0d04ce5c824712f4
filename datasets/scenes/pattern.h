// Procedural patterns, each averaged over a footprint so that nothing above the sampling rate is
// left.
//
// Coordinates and footprints are in the same unit. A footprint is the width of a box centred on the
// point.
#pragma once

#include <cstdint>

#include "datasets/scenes/linear.h"

namespace warplut::scenes {

// A value and its derivatives by x and y.
struct Height {
  float value = 0;
  float dx = 0;
  float dy = 0;
};

// Gradient noise on the unit lattice, quintic fade (Perlin 2002); about [-0.8, 0.8], mean 0.
Height Noise(Vec2f p, std::uint32_t seed);

// sum_k gain^k Noise(2^k p), k < octaves. An octave whose lattice is finer than the footprint fades
// out: whole while 2^k footprint <= 0.35, gone from 0.7 on. Gain near 1 gives equal contrast at all
// scales.
Height Fbm(Vec2f p, float footprint, int octaves, float gain, std::uint32_t seed);

// Mean over the footprint of the pulse train that is 1 where frac(x) < duty, period 1.
float Pulse(float x, float duty, float footprint);

// Mean over the footprint of the step that is 1 where x > 0.
inline float Step(float x, float footprint) {
  return Saturate(x / std::max(footprint, 1e-6f) + 0.5f);
}

// Mean of the chequerboard that is 1 where floor(x) + floor(y) is even, unit squares.
float Checker(Vec2f p, float footprint);

// How visible cells of the given size are under the footprint: 1 large, 0 smaller than the
// footprint.
inline float CellContrast(float size, float footprint) {
  return SmoothStep(0.6f, 2.f, size / footprint);
}

}  // namespace warplut::scenes
