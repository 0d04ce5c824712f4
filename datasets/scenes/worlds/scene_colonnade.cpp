// A camera that tracks past near columns, with fine detail behind them.
#include "datasets/scenes/builtin.h"
#include "datasets/scenes/worlds/props.h"

namespace warplut::scenes {

World Colonnade(std::uint64_t seed) {
  World world;
  const Palette p = AddPalette(world, seed);
  Random random(seed, 9);
  Mesh garden;
  garden.AddQuad({-80, 0, -0.6f}, {160, 0, 0}, {0, 0, -80}, p.ground);
  garden.AddBox({-80, -0.2f, -0.6f}, {80, 0.08f, 6}, p.stone, p.checker);
  garden.AddBox({-80, 0, -17}, {80, 3.2f, -16.6f}, p.brick, p.stone);
  garden.AddQuad({-80, 0.02f, -5}, {160, 0, 0}, {0, 0, -2}, p.paving);
  world.Place(world.AddMesh(std::move(garden)));
  const int near_column = world.AddMesh(Column(p, 0.17f, 3.6f));
  for (int i = -14; i <= 30; ++i) world.Place(near_column, Translate(1.35 * i, 0.08, -0.3));
  const int railing = world.AddMesh(Railing(p, 1.2f, 0.9f, 0.1f));
  for (int i = -14; i <= 30; i += 2) world.Place(railing, Translate(1.35 * (i + 0.5), 0.08, -0.3));
  const int bush = world.AddMesh(Bush(p, Random(seed, 16), 0.6f));
  const int tree = world.AddMesh(Tree(p, Random(seed, 17), 5));
  const int tuft = world.AddMesh(Grass(p, Random(seed, 18), 200, 0.7f, 0.35f));
  for (int i = 0; i < 40; ++i) {
    world.Place(bush, Translate(random(-22, 40), 0, random(-15.5, -8)) * TurnY(random(0, 6)) *
                          Scale(random(0.6, 1.4)));
    if (i % 2)
      world.Place(tree, Translate(random(-22, 40), 0, random(-15, -8)) * TurnY(random(0, 6)) *
                            Scale(random(0.7, 1.3)));
  }
  for (int i = 0; i < 300; ++i)
    world.Place(tuft, Translate(random(-16, 34), 0, random(-4.8, -1.4)) * TurnY(random(0, 6)) *
                          Scale(random(0.5, 1)));
  const int house = world.AddMesh(House(p, 12, 7.5f, 9, p.facade));
  for (int i = 0; i < 6; ++i) world.Place(house, Translate(-30 + 15 * i, 0, -25 - random(0, 5)));
  const char* const kNames[] = {"ROSA CANINA\nBED 12", "HERB GARDEN\nSINCE 1911",
                                "PLEASE KEEP\nTO THE PATH"};
  for (int i = 0; i < 9; ++i) {
    const int sign =
        world.AddSign(kNames[i % 3], Rgb(0.66f, 0.64f, 0.55f), Rgb(0.05f, 0.09f, 0.05f), 0.012f);
    world.Place(world.AddMesh(SignBoard(world, p, sign, 0.6f)),
                Translate(-10 + 4.4 * i, 0, -4.4) * TurnY(random(-0.3, 0.3)));
  }
  const int wheel = world.AddMesh(Wheel(0.9f, 16, 0.014f, p.metal, p.white));
  for (int i = 0; i < 5; ++i) {
    const double x = -7 + 6.5 * i, rate = random(1.5, 4);
    world.Place(wheel, Transform::Identity(),
                [=](double t) { return Translate(x, 1.6, -6.4) * Turn(Vec3d::UnitZ(), rate * t); });
  }
  world.camera = [](double t, int) {
    const double x = -3 + 2.1 * t;
    return LookAt({x, 1.65 + 0.02 * std::sin(10 * t), 1.7}, {x + 0.9 + 0.3 * std::sin(t), 1.55, -6},
                  62);
  };
  world.light = [seed](double) {
    Light light;
    light.to_sun = SunDirection(40, 48);
    light.haze = 0.004f;
    light.seed = Hash(static_cast<std::uint32_t>(seed), 19U);
    return light;
  };
  return world;
}

}  // namespace warplut::scenes
