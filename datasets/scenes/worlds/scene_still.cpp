// A corner of a yard in which nothing moves.
#include "datasets/scenes/builtin.h"
#include "datasets/scenes/worlds/props.h"

namespace warplut::scenes {

World Still(std::uint64_t seed) {
  World world;
  const Palette p = AddPalette(world, seed);
  Random random(seed, 1);
  Mesh yard;
  yard.AddQuad({-20, 0, 12}, {40, 0, 0}, {0, 0, -40}, p.paving);
  yard.AddBox({-9, 0, -9.4f}, {9, 5.5f, -9}, p.brick, p.stone);
  yard.AddBox({-9.4f, 0, -9}, {-9, 4.2f, 6}, p.stone);
  for (int i = 0; i < 5; ++i) {
    const float x = -7.5f + 3.4f * static_cast<float>(i);
    yard.AddBox({x, 0, -9}, {x + 0.5f, 5.7f, -8.75f}, p.stone);
  }
  yard.AddBox({3.2f, 0, -9.02f}, {4.8f, 2.4f, -8.93f}, p.planks);
  world.Place(world.AddMesh(std::move(yard)));
  const int notice =
      world.AddSign("NOTICE 17\nDELIVERIES 06:30-11:45\nRING TWICE AT GATE B\nNO PARKING - 24/7",
                    Rgb(0.70f, 0.68f, 0.60f), Rgb(0.04f, 0.05f, 0.12f), 0.016f);
  world.Place(world.AddMesh(SignBoard(world, p, notice, 1.2f)),
              Translate(-1.2, 0, -3.5) * TurnY(0.25));
  const int name = world.AddSign("BAKER & SONS\nEST. 1893", Rgb(0.05f, 0.12f, 0.10f),
                                 Rgb(0.78f, 0.62f, 0.22f), 0.035f);
  world.Place(world.AddMesh(Panel(world, name)), Translate(1.25, 3.9, -8.9));
  const int crate = world.AddMesh(Crate(p, 0.9f));
  world.Place(crate, Translate(2.3, 0, -5.6) * TurnY(0.4));
  world.Place(crate, Translate(3.3, 0, -6.3) * TurnY(-0.2));
  world.Place(crate, Translate(2.7, 0.93, -5.9) * TurnY(0.9));
  const int tree = world.AddMesh(Tree(p, Random(seed, 2), 5));
  world.Place(tree, Translate(5.8, 0, -6.5));
  world.Place(tree, Translate(-11.5, 0, -12) * TurnY(2) * Scale(1.6));
  world.Place(tree, Translate(3, 0, -14) * TurnY(4) * Scale(1.7));
  const int bush = world.AddMesh(Bush(p, Random(seed, 3), 0.8f));
  for (int i = 0; i < 5; ++i) {
    world.Place(bush,
                Translate(-8.2, 0, -7.5 + 1.9 * i) * TurnY(random(0, 6)) * Scale(random(0.7, 1.2)));
  }
  world.Place(world.AddMesh(Railing(p, 5, 1.1f, 0.13f)), Translate(4.4, 0, -3.6) * TurnY(-0.35));
  Mesh wires;
  wires.AddWire({-9, 4.1f, -2}, {9, 5.3f, -8.9f}, 0.5f, 0.012f, p.dark);
  wires.AddWire({-9, 3.9f, -3}, {9, 5.0f, -8.9f}, 0.6f, 0.012f, p.dark);
  world.Place(world.AddMesh(std::move(wires)));
  const int house = world.AddMesh(House(p, 12, 7, 9, p.facade));
  world.Place(house, Translate(-6, 0, -26));
  world.Place(house, Translate(12, 0, -30) * TurnY(0.3));
  world.camera = [](double, int) { return LookAt({1.2, 1.75, 1.6}, {-0.3, 1.75, -8}, 55); };
  world.light = [seed](double) {
    Light light;
    light.to_sun = SunDirection(38, 52);
    light.seed = Hash(static_cast<std::uint32_t>(seed), 11U);
    return light;
  };
  return world;
}

}  // namespace warplut::scenes
