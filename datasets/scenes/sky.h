// Light of a scene: one sun, a sky, what the ground throws back, haze.
#pragma once

#include <cstdint>
#include <functional>

#include "datasets/scenes/linear.h"

namespace warplut::scenes {

struct Light {
  Vec3f to_sun = Vec3f(0.4f, 0.7f, 0.5f).normalized();
  Rgb sun = Rgb(3.4f, 3.0f, 2.5f);         // irradiance on a surface that faces the sun, over pi
  Rgb zenith = Rgb(0.16f, 0.32f, 0.75f);   // radiance overhead
  Rgb horizon = Rgb(0.62f, 0.74f, 0.92f);  // radiance at the horizon; haze has it too
  Rgb ground = Rgb(0.20f, 0.17f, 0.14f);   // radiance from below
  float cloud = 0.5f;                      // cover, 0 none, 1 overcast
  float haze = 0.002f;                     // extinction, 1 / m
  std::uint32_t seed = 1;                  // of the clouds
  // The share of the sun, in [0, 1], that reaches a point in the world, beside what objects hide:
  // soft shadows without noise. Empty: all of it.
  std::function<float(const Vec3f& point)> reaching = {};
};

// Sun direction from elevation and azimuth (0: from +z, 90: from +x), degrees.
Vec3f SunDirection(double elevation, double azimuth);

// Radiance of the sky in a unit direction, clouds averaged over the angle `footprint` (radians).
// The sky is at infinity and does not move.
Rgb SkyRadiance(const Light& light, const Vec3f& direction, float footprint);

// Mean radiance that a surface with this unit normal gets from sky and ground.
Rgb Ambient(const Light& light, const Vec3f& normal);

// Radiance after `distance` metres of haze.
Rgb Haze(const Light& light, const Rgb& radiance, float distance);

// Radiance at the exposure of a film or a game: 1 is about as bright as white paper in the sun.
Rgb Exposed(const Rgb& radiance, float exposure);

// Exposed light to display values in [0, 1]: the ACES fit of K. Narkowicz (2015), then the sRGB
// curve.
Rgb DisplayCurve(const Rgb& exposed);

}  // namespace warplut::scenes
