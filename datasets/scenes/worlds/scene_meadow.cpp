// A meadow with trees in the wind; the camera walks through it.
#include "datasets/scenes/builtin.h"
#include "datasets/scenes/pattern.h"
#include "datasets/scenes/worlds/props.h"

namespace warplut::scenes {

World Meadow(std::uint64_t seed) {
  World world;
  const Palette p = AddPalette(world, seed);
  Random random(seed, 4);
  const std::uint32_t relief = random.Bits();
  const auto height = [relief](float x, float z) {
    const float far_away = SmoothStep(25, 120, std::hypot(x, z));
    return 0.8f * Fbm({x * 0.07f, z * 0.07f}, 0, 4, 0.45f, relief).value +
           26 * far_away * (0.35f + Fbm({x * 0.02f, z * 0.02f}, 0, 5, 0.5f, relief + 9).value);
  };
  Mesh ground;
  ground.AddTerrain(160, 320, height, p.ground);
  world.Place(world.AddMesh(std::move(ground)));
  // A sway about the foot, in the direction of the wind.
  const auto plant = [&](int mesh, double x, double z, double scale, double bend, double rate) {
    const double y = height(static_cast<float>(x), static_cast<float>(z)),
                 phase = random(0, 6.28) + 0.4 * x;
    const Transform place = Translate(x, y, z);
    world.Place(mesh, TurnY(random(0, 6.28)) * Scale(scale), [=](double t) {
      const double lean =
          bend * (std::sin(rate * t + phase) + 0.4 * std::sin(2.7 * rate * t + 2 * phase));
      return place * Turn(Vec3d(0.35, 0, -0.94), lean);
    });
  };
  const int trees[] = {world.AddMesh(Tree(p, Random(seed, 8), 6)),
                       world.AddMesh(Tree(p, Random(seed, 9), 8))};
  for (int i = 0; i < 44; ++i) {
    const double angle = random(-1.3, 1.3), r = random(9, 90);
    const double x = r * std::sin(angle), z = 4 - r * std::cos(angle);
    if (std::abs(x) < 1.5) continue;
    plant(trees[i % 2], x, z, random(0.7, 1.4), 0.012, 1.9);
  }
  const int bushes[] = {world.AddMesh(Bush(p, Random(seed, 10), 0.7f)),
                        world.AddMesh(Bush(p, Random(seed, 11), 1.0f))};
  for (int i = 0; i < 50; ++i) {
    const double x = random(-22, 22);
    if (std::abs(x) > 1.2) plant(bushes[i % 2], x, random(-45, 3), random(0.5, 1.3), 0.03, 2.6);
  }
  const int tufts[] = {world.AddMesh(Grass(p, Random(seed, 12), 170, 0.7f, 0.5f)),
                       world.AddMesh(Grass(p, Random(seed, 13), 150, 0.7f, 0.34f)),
                       world.AddMesh(Grass(p, Random(seed, 14), 110, 0.6f, 0.75f))};
  for (int i = 0; i < 500; ++i) {
    const double z = 5 - 26 * random(0, 1) * random(0.2, 1);
    const double x = random(-1, 1) * (3 + 0.7 * (5 - z));
    plant(tufts[std::abs(x) < 0.8 ? 1 : i % 3], x, z, random(0.6, 1.2), 0.07, 3.1);
  }
  Mesh rock;
  rock.AddSphere(Vec3f::Zero(), 1, 24, p.rock);
  for (Vec3f& v : rock.positions)
    v *= 1 + 0.5f * Fbm({v.x() * 1.3f + v.z(), v.y() * 1.7f - v.z()}, 0, 4, 0.5f, relief + 3).value;
  const int rock_mesh = world.AddMesh(std::move(rock));
  for (int i = 0; i < 24; ++i) {
    const double x = random(-14, 14), z = random(-30, 2);
    world.Place(rock_mesh, Translate(x, height(static_cast<float>(x), static_cast<float>(z)), z) *
                               TurnY(random(0, 6)) * Turn(Vec3d::UnitX(), 1.3) *
                               Scale(random(0.15, 0.8)));
  }
  const int sign = world.AddSign("TRAIL 7\nLAKE 2.4 KM\nHUT  5.1 KM", Rgb(0.42f, 0.30f, 0.16f),
                                 Rgb(0.06f, 0.04f, 0.03f), 0.012f);
  world.Place(world.AddMesh(SignBoard(world, p, sign, 0.9f)),
              Translate(-1.5, height(-1.5f, 0), 0) * TurnY(0.3));
  world.Place(world.AddMesh(Fence(p, 14, 1.2f)), Translate(8, height(8, -9), -9) * TurnY(-0.5));
  world.camera = [height](double t, int) {
    const double z = 4 - 1.8 * t, x = 0.4 * std::sin(0.6 * t);
    const double y =
        height(static_cast<float>(x), static_cast<float>(z)) + 1.55 + 0.035 * std::sin(11 * t);
    const double yaw = 0.25 * std::sin(0.8 * t + 0.5);
    return LookAt(
        {x, y, z},
        Vec3d(x, y, z) + Vec3d(std::sin(yaw), -0.1 + 0.006 * std::sin(11 * t + 1), -std::cos(yaw)),
        60, 0.006 * std::sin(5.5 * t));
  };
  world.light = [seed](double) {
    Light light;
    light.to_sun = SunDirection(36, 70);
    light.haze = 0.005f;
    light.seed = Hash(static_cast<std::uint32_t>(seed), 14U);
    return light;
  };
  return world;
}

}  // namespace warplut::scenes
