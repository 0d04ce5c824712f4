// A yard of machines: spinning wheels, rods, wires, woven fences.
#include "datasets/scenes/builtin.h"
#include "datasets/scenes/worlds/props.h"

namespace warplut::scenes {

World Machinery(std::uint64_t seed) {
  World world;
  const Palette p = AddPalette(world, seed);
  Random random(seed, 5);
  Mesh hall;
  hall.AddQuad({-40, 0, 20}, {80, 0, 0}, {0, 0, -60}, p.asphalt);
  hall.AddBox({-16, 0, -14}, {16, 7, -13.5f}, p.sheet, p.metal);
  hall.AddBox({-16, 7, -14.2f}, {16, 7.4f, -13.3f}, p.stripes);
  hall.AddBox({-12, 0, -13.4f}, {-8, 3.2f, -13.2f}, p.planks);
  for (int i = 0; i < 6; ++i) {
    const float x = -13.5f + 5.4f * static_cast<float>(i);
    hall.AddTube({x, 0, -11}, {x, 8, -11}, 0.13f, 0.13f, 12, p.metal);
    // Braces between the posts.
    if (i < 5) {
      hall.AddTube({x, 5, -11}, {x + 5.4f, 8, -11}, 0.035f, 0.035f, 8, p.metal);
      hall.AddTube({x, 8, -11}, {x + 5.4f, 5, -11}, 0.035f, 0.035f, 8, p.metal);
      hall.AddTube({x, 8, -11}, {x + 5.4f, 8, -11}, 0.06f, 0.06f, 8, p.metal);
    }
  }
  for (int i = 0; i < 9; ++i) {
    const float y = 5.6f + 0.22f * static_cast<float>(i);
    hall.AddWire({-16, y, -10.5f + 0.6f * static_cast<float>(i)},
                 {16, y + 0.5f, -12 + 0.5f * static_cast<float>(i)}, 0.8f, 0.009f, p.dark);
  }
  for (const float x : {-5.f, 0.f, 5.f})
    hall.AddBox({x - 0.9f, 0, -6.6f}, {x + 0.9f, 0.7f, -5.4f}, p.stripes, p.metal);
  world.Place(world.AddMesh(std::move(hall)));
  // Wheels, small and fast to large and slow.
  struct Spin {
    double x, y, z, radius, rate;
    int spokes;
  };
  const Spin spins[] = {{-5, 2.0, -6, 1.5, 3.1, 16},    {0, 1.8, -6, 1.2, -5.3, 9},
                        {5, 2.2, -6, 1.7, 2.3, 24},     {-2.4, 1.1, -4, 0.45, 11, 6},
                        {2.3, 1.2, -3.6, 0.5, -8.5, 7}, {0.2, 4.4, -9, 1.9, 1.4, 36},
                        {-8.5, 3, -9, 1.6, -2.1, 20},   {9, 3.4, -9, 2.0, 1.7, 28}};
  for (const Spin& spin : spins) {
    const int wheel = world.AddMesh(Wheel(static_cast<float>(spin.radius), spin.spokes, 0.011f,
                                          p.metal, random.Below(2) ? p.dark : p.white));
    const double phase = random(0, 6);
    world.Place(wheel, Transform::Identity(), [spin, phase](double t) {
      return Translate(spin.x, spin.y, spin.z) * Turn(Vec3d::UnitZ(), spin.rate * t + phase);
    });
    Mesh leg;
    const auto y = static_cast<float>(spin.y);
    leg.AddTube({0, -y, -0.25f}, {0, 0, -0.25f}, 0.05f, 0.05f, 8, p.metal);
    world.Place(world.AddMesh(std::move(leg)), Translate(spin.x, spin.y, spin.z));
  }
  // Rods that a crank drives up and down.
  Mesh rod;
  rod.AddTube({0, -1.2f, 0}, {0, 1.2f, 0}, 0.02f, 0.02f, 8, p.metal);
  rod.AddBox({-0.1f, -0.1f, -0.1f}, {0.1f, 0.1f, 0.1f}, p.stripes);
  const int rod_mesh = world.AddMesh(std::move(rod));
  for (int i = 0; i < 14; ++i) {
    const double x = -6.5 + i, rate = 5 + 0.4 * i;
    world.Place(rod_mesh, Transform::Identity(), [=](double t) {
      return Translate(x, 1.7 + 0.5 * std::sin(rate * t + 0.7 * i), -8) *
             Turn(Vec3d::UnitZ(), 0.15 * std::cos(rate * t + 0.7 * i));
    });
  }
  // A sweep with a hanging hook.
  Mesh arm;
  arm.AddTube({0, 0, 0}, {4.5f, 0, 0}, 0.05f, 0.03f, 8, p.stripes);
  arm.AddTube({4.4f, 0, 0}, {4.4f, -2.2f, 0}, 0.007f, 0.007f, 5, p.dark);
  arm.AddBox({4.25f, -2.5f, -0.15f}, {4.55f, -2.2f, 0.15f}, p.stripes);
  world.Place(world.AddMesh(std::move(arm)), Transform::Identity(),
              [](double t) { return Translate(-1, 4.2, -6.8) * TurnY(1.3 * t + 2.5); });
  const int warning = world.AddSign("DANGER\nROTATING PARTS\nKEEP OUT - ZONE 5",
                                    Rgb(0.75f, 0.58f, 0.05f), Rgb(0.03f, 0.03f, 0.03f), 0.011f);
  world.Place(world.AddMesh(Panel(world, warning)), Translate(-1.9, 1.0, -1.55));
  const int fence = world.AddMesh(Fence(p, 7.5f, 1.35f));
  world.Place(fence, Translate(-4.1, 0, -1.6));
  world.Place(fence, Translate(5.2, 0, -1.9) * TurnY(-0.2));
  const int crate = world.AddMesh(Crate(p, 1.0f));
  for (int i = 0; i < 4; ++i)
    world.Place(crate, Translate(7 + random(0, 2), 0, -5 - 1.6 * i) * TurnY(random(0, 1)));
  world.camera = [](double t, int) {
    return LookAt({0.5 + 0.7 * std::sin(0.7 * t), 1.75, 2.2 - 0.3 * std::sin(0.5 * t)},
                  {0.2 * std::sin(0.7 * t + 1), 2.2, -7}, 62);
  };
  world.light = [seed](double) {
    Light light;
    light.to_sun = SunDirection(52, -30);
    light.cloud = 0.75f;
    light.seed = Hash(static_cast<std::uint32_t>(seed), 15U);
    return light;
  };
  return world;
}

}  // namespace warplut::scenes
