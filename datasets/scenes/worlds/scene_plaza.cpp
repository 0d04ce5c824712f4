// A square that stands still while the light does not: a moving sun, passing clouds, shadows of
// turning things.
#include "datasets/scenes/builtin.h"
#include "datasets/scenes/worlds/props.h"

namespace warplut::scenes {

World Plaza(std::uint64_t seed) {
  World world;
  const Palette p = AddPalette(world, seed);
  Random random(seed, 6);
  Mesh square;
  square.AddQuad({-60, 0, 30}, {120, 0, 0}, {0, 0, -120}, p.paving);
  for (int i = 0; i < 5; ++i) {
    const float s = static_cast<float>(i), y = 0.16f * s;
    square.AddBox({-3.4f + 0.35f * s, y, -10.4f + 0.35f * s},
                  {3.4f - 0.35f * s, y + 0.16f, -3.6f - 0.35f * s}, p.stone);
  }
  square.AddBox({-0.7f, 0.8f, -7.7f}, {0.7f, 2.6f, -6.3f}, p.stone);
  square.AddTube({0, 2.6f, -7}, {0, 6.5f, -7}, 0.35f, 0.16f, 24, p.rock);
  square.AddSphere({0, 6.8f, -7}, 0.4f, 24, p.metal);
  world.Place(world.AddMesh(std::move(square)));
  const int plaque = world.AddSign("ERECTED 1788\nIN MEMORY OF\nTHE SURVEYORS",
                                   Rgb(0.16f, 0.13f, 0.09f), Rgb(0.58f, 0.47f, 0.22f), 0.014f);
  world.Place(world.AddMesh(Panel(world, plaque)), Translate(0, 1.8, -6.27));
  const int block = world.AddMesh(Block(p, 16, 11, 9, p.facade));
  const int house = world.AddMesh(House(p, 11, 7, 9, p.plaster));
  world.Place(block, Translate(-12, 0, -24));
  world.Place(house, Translate(4, 0, -25));
  world.Place(block, Translate(19, 0, -23) * TurnY(-0.3));
  const int column = world.AddMesh(Column(p, 0.4f, 4.2f));
  for (int i = 0; i < 4; ++i) {
    world.Place(column, Translate(-6.4, 0, -3 - 3.2 * i));
    world.Place(column, Translate(6.4, 0, -3 - 3.2 * i));
  }
  // Slow sails and a fan of slats, above and behind the camera: mostly their shadows are seen.
  const int rotor = world.AddMesh(Wheel(3.2f, 14, 0.06f, p.metal, p.white));
  world.Place(rotor, Transform::Identity(), [](double t) {
    return Translate(2.4, 6.5, -1.5) * Turn(Vec3d::UnitX(), 1.2) * Turn(Vec3d::UnitZ(), 0.9 * t);
  });
  Mesh slats;
  for (int i = 0; i < 12; ++i) {
    const float x = -2.2f + 0.4f * static_cast<float>(i);
    slats.AddBox({x, -0.02f, -1.8f}, {x + 0.12f, 0.02f, 1.8f}, p.planks);
  }
  world.Place(world.AddMesh(std::move(slats)), Transform::Identity(), [](double t) {
    return Translate(-3.2 + 1.5 * std::sin(1.2 * t), 4.8, -1) * TurnY(0.6 * t);
  });
  const int tree = world.AddMesh(Tree(p, Random(seed, 15), 6));
  for (const double x : {-9.0, 9.5}) {
    const double phase = random(0, 6);
    world.Place(tree, TurnY(random(0, 6)), [x, phase](double t) {
      return Translate(x, 0, -7) * Turn(Vec3d::UnitZ(), 0.02 * std::sin(2 * t + phase));
    });
  }
  Mesh ball;
  ball.AddSphere(Vec3f::Zero(), 0.5f, 32, p.stripes);
  world.Place(world.AddMesh(std::move(ball)), Transform::Identity(), [](double t) {
    const double x = 3.2 * std::sin(0.9 * t + 0.4);
    return Translate(x, 0.5, -1.6) * Turn(Vec3d::UnitZ(), -x / 0.5);
  });
  world.camera = [](double, int) { return LookAt({1.2, 2.1, 5.2}, {-0.3, 1.9, -7}, 56); };
  world.light = [seed](double t) {
    Light light;
    light.to_sun = SunDirection(44 + 6 * std::sin(0.5 * t), 30 + 9 * t);
    light.seed = Hash(static_cast<std::uint32_t>(seed), 16U);
    // Clouds pass before the sun.
    const auto passing =
        static_cast<float>(0.72 + 0.28 * std::sin(3.1 * t) + 0.10 * std::sin(7.3 * t + 1));
    light.sun *= passing;
    const float warm = 0.5f + 0.5f * static_cast<float>(std::sin(1.3 * t));
    light.sun *= Mix(Rgb(1, 1, 1), Rgb(1.1f, 0.92f, 0.72f), warm);
    light.horizon *= 0.8f + 0.2f * passing;
    return light;
  };
  return world;
}

}  // namespace warplut::scenes
