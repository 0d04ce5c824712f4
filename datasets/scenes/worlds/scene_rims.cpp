// Dark leaves with bright rims, and bright stalks, before a dark wall, all swaying slowly.
#include "datasets/scenes/builtin.h"
#include "datasets/scenes/hash.h"

namespace warplut::scenes {
namespace {

// A pixel of 480 x 270 at the distance of the leaves, in metres.
constexpr float kThin = 0.0207f;

// A pointed ellipse in the plane of x and y that faces +z, along y from 0 to `length`; its rim is
// kThin wide.
Mesh RimmedLeaf(float length, float width, int body, int rim) {
  constexpr int kSteps = 24;
  Mesh mesh;
  const auto outline = [&](int side, int k, float inset) {
    const float t = static_cast<float>(k) / kSteps;
    const float half = 2 * width * t * (1 - t) * (1.4f - 0.8f * t);
    const float x = std::max(half - inset, 0.0f) * static_cast<float>(side);
    return mesh.Add({x, t * length, 0}, Vec3f::UnitZ(), {x, t * length});
  };
  for (const int side : {-1, 1}) {
    for (int k = 0; k < kSteps; ++k) {
      const auto outer = outline(side, k, 0), outer_next = outline(side, k + 1, 0);
      const auto inner = outline(side, k, kThin), inner_next = outline(side, k + 1, kThin);
      const auto middle = outline(0, k, 0), middle_next = outline(0, k + 1, 0);
      mesh.AddTriangle(outer, outer_next, inner, rim);
      mesh.AddTriangle(inner, outer_next, inner_next, rim);
      mesh.AddTriangle(inner, inner_next, middle, body);
      mesh.AddTriangle(middle, inner_next, middle_next, body);
    }
  }
  return mesh;
}

}  // namespace

World Rims(std::uint64_t seed) {
  World world;
  Random random(seed, 32);
  const int body =
      world.AddMaterial({.pattern = Pattern::kPlain, .a = Rgb(0.02f, 0.035f, 0.015f), .seed = 1});
  const int rim =
      world.AddMaterial({.pattern = Pattern::kPlain, .a = Rgb(0.80f, 0.85f, 0.55f), .seed = 2});
  const int back = world.AddMaterial({.pattern = Pattern::kRock,
                                      .a = Rgb(0.035f, 0.035f, 0.05f),
                                      .b = Rgb(0.02f, 0.02f, 0.025f),
                                      .seed = random.Bits()});
  Mesh wall;
  wall.AddQuad({-12, -8, -3}, {24, 0, 0}, {0, 16, 0}, back);
  world.Place(world.AddMesh(std::move(wall)));

  // A slow sway about the foot at (x, y), with a drift that follows the wind.
  const auto plant = [&](int mesh, double x, double y, double z, double turn, double bend) {
    const double phase = random(0, 6.28), rate = random(0.5, 1.1), drift = random(0.003, 0.012);
    world.Place(mesh, Turn(Vec3d::UnitZ(), turn), [=](double t) {
      return Translate(x + drift * std::sin(0.7 * rate * t + phase), y, z) *
             Turn(Vec3d::UnitZ(), bend * std::sin(rate * t + 2 * phase));
    });
  };
  const int leaves[] = {world.AddMesh(RimmedLeaf(0.9f, 0.35f, body, rim)),
                        world.AddMesh(RimmedLeaf(1.3f, 0.3f, body, rim)),
                        world.AddMesh(RimmedLeaf(0.7f, 0.4f, body, rim))};
  for (int i = 0; i < 42; ++i) {
    plant(leaves[i % 3], random(-5, 5), random(-3, 2.2), random(-0.5, 0.5), random(-3.1, 3.1),
          i % 6 == 0 ? 0.1 : 0.005);
  }
  Mesh stalk;
  stalk.AddQuad({-kThin / 2, -3.5f, 0}, {kThin, 0, 0}, {0, 7, 0}, rim);
  const int stalk_mesh = world.AddMesh(std::move(stalk));
  for (int i = 0; i < 14; ++i) {
    const double slope = random(0.03, 0.3) * (i % 2 == 0 ? 1 : -1);
    plant(stalk_mesh, random(-4.8, 4.8), random(-1, 1), -0.8, slope + (i % 4 == 3 ? kPi / 2 : 0),
          0.002);
  }
  world.camera = [](double, int) { return LookAt({0, 0, 6}, {0, 0, 0}, 50); };
  world.light = [seed](double) {
    Light light;
    light.to_sun = SunDirection(30, -20);
    light.seed = Hash(static_cast<std::uint32_t>(seed), 32U);
    return light;
  };
  world.far_plane = 40;
  return world;
}

}  // namespace warplut::scenes
