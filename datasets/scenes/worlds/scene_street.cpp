// A street of houses; the camera travels along it and pans.
#include "datasets/scenes/builtin.h"
#include "datasets/scenes/worlds/props.h"

namespace warplut::scenes {

World Street(std::uint64_t seed) {
  World world;
  const Palette p = AddPalette(world, seed);
  Random random(seed, 3);
  Mesh road;
  road.AddQuad({-150, -0.01f, 150}, {300, 0, 0}, {0, 0, -300}, p.paving);
  road.AddQuad({-3.5f, 0.005f, 150}, {7, 0, 0}, {0, 0, -300}, p.asphalt);
  for (float z = 100; z > -140; z -= 4)
    road.AddQuad({-0.08f, 0.012f, z}, {0.16f, 0, 0}, {0, 0, -2}, p.white);
  for (const float x : {-3.6f, 3.5f}) road.AddBox({x, 0, -150}, {x + 0.12f, 0.12f, 150}, p.stone);
  world.Place(world.AddMesh(std::move(road)));
  std::vector<int> walls = {p.facade, p.brick};
  for (int i = 0; i < 3; ++i) {
    Material front = world.materials[p.facade];
    front.a = Rgb(static_cast<float>(random(0.25, 0.6)), static_cast<float>(random(0.2, 0.5)),
                  static_cast<float>(random(0.15, 0.45)));
    front.size = static_cast<float>(random(1.8, 2.8));
    front.seed = random.Bits();
    walls[0] = world.AddMaterial(front);
    const auto height = static_cast<float>(random(7, 14));
    const int block = world.AddMesh(Block(p, 11, height, 9, walls[0]));
    const int house = world.AddMesh(House(p, 10, static_cast<float>(random(5, 8)), 9, walls[0]));
    for (int k = i; k < 14; k += 3) {
      const double z = 20 - 11.3 * k;
      world.Place(block, Translate(-11.2, 0, z) * TurnY(kPi / 2));
      world.Place(house, Translate(11, 0, z + 4) * TurnY(-kPi / 2));
    }
  }
  const char* const kNames[] = {"PHARMACY",     "BOOKS & MAPS", "CAFE 24/7", "TAILOR",
                                "RADIO REPAIR", "FISH MARKET",  "CINEMA",    "BANK"};
  const int post = world.AddMesh(LampPost(p, 4.8f));
  const int tree = world.AddMesh(Tree(p, Random(seed, 7), 5.5f));
  for (int k = 0; k < 16; ++k) {
    const double z = 12 - 7.2 * k;
    world.Place(post, Translate(-4.1, 0, z));
    world.Place(post, Translate(4.1, 0, z - 3) * TurnY(kPi));
    if (k % 3 == 1) world.Place(tree, Translate(4.9, 0, z) * TurnY(random(0, 6)));
    const Rgb ground(static_cast<float>(random(0.03, 0.6)), static_cast<float>(random(0.03, 0.5)),
                     static_cast<float>(random(0.05, 0.5)));
    const bool pale = ground.sum() < 0.7f;
    const int sign = world.AddSign(
        kNames[k % 8], ground, pale ? Rgb(0.8f, 0.78f, 0.7f) : Rgb(0.03f, 0.03f, 0.05f), 0.035f);
    const int panel = world.AddMesh(Panel(world, sign));
    world.Place(panel, Translate(k % 2 ? -5.4 : 5.2, random(2.6, 3.8), z + 2));
    world.Place(panel, Translate(k % 2 ? 5.95 : -6.55, random(3.0, 4.2), z - 2) *
                           TurnY(k % 2 ? -kPi / 2 : kPi / 2));
  }
  Mesh wires;
  for (int k = 0; k < 15; ++k) {
    const float z = 12 - 7.2f * static_cast<float>(k);
    for (const float y : {4.6f, 4.4f})
      wires.AddWire({-4.1f, y, z}, {-4.1f, y, z - 7.2f}, 0.25f, 0.012f, p.dark);
    wires.AddWire({-4.1f, 4.7f, z}, {4.1f, 4.7f, z - 3}, 0.4f, 0.010f, p.dark);
  }
  world.Place(world.AddMesh(std::move(wires)));
  Mesh van;
  van.AddBox({-0.9f, 0.45f, -2.2f}, {0.9f, 2.1f, 1.0f}, p.sheet, p.metal);
  van.AddBox({-0.9f, 0.45f, 1.0f}, {0.9f, 1.5f, 2.1f}, p.metal);
  van.AddBox({-0.8f, 1.5f, 1.0f}, {0.8f, 2.0f, 1.7f}, p.dark);
  const int van_mesh = world.AddMesh(std::move(van));
  const int wheel = world.AddMesh(Wheel(0.38f, 10, 0.02f, p.dark, p.metal));
  const auto drive = [&](double x, double z, double speed) {
    const auto place = [=](double t) {
      return Translate(x, 0, z + speed * t) * TurnY(speed < 0 ? kPi : 0);
    };
    world.Place(van_mesh, Transform::Identity(), place);
    for (const double dx : {-0.92, 0.92}) {
      for (const double dz : {-1.4, 1.4}) {
        world.Place(wheel, Transform::Identity(), [=](double t) {
          return place(t) * Translate(dx, 0.43, dz) * TurnY(kPi / 2) *
                 Turn(Vec3d::UnitZ(), -std::abs(speed) * t / 0.43);
        });
      }
    }
  };
  drive(-1.8, -22, 7);
  drive(1.7, -8, -5);
  drive(2.6, -30, 0);
  world.camera = [](double t, int) {
    const Vec3d eye(0.6 + 0.3 * std::sin(0.9 * t), 1.8 + 0.03 * std::sin(9 * t), 8 - 5 * t);
    const double yaw = 0.32 + 0.75 * std::sin(0.55 * t + 0.3);
    return LookAt(eye, eye + Vec3d(std::sin(yaw), 0.06, -std::cos(yaw)), 62);
  };
  world.light = [seed](double) {
    Light light;
    light.to_sun = SunDirection(42, -58);
    light.haze = 0.006f;
    light.seed = Hash(static_cast<std::uint32_t>(seed), 13U);
    return light;
  };
  return world;
}

}  // namespace warplut::scenes
