// A brick court under a resting camera; things roll, swing and turn in it.
#include "datasets/scenes/builtin.h"
#include "datasets/scenes/worlds/props.h"

namespace warplut::scenes {

World Courtyard(std::uint64_t seed) {
  World world;
  const Palette p = AddPalette(world, seed);
  Random random(seed, 2);
  Mesh court;
  court.AddQuad({-30, 0, 15}, {60, 0, 0}, {0, 0, -30}, p.stone);
  court.AddBox({-11, 0, -8.5f}, {11, 6, -8}, p.brick, p.stone);
  court.AddBox({-8, 0, -8}, {-7.5f, 5, 8}, p.plaster, p.stone);
  for (const float x : {-5.5f, -1.5f, 2.5f, 6.5f}) {
    court.AddBox({x - 0.8f, 1, -8.02f}, {x + 0.8f, 3.2f, -7.9f}, p.white);
    court.AddBox({x - 0.68f, 1.1f, -8.02f}, {x + 0.68f, 3.1f, -7.88f}, p.sheet);
  }
  court.AddBox({-11, 4.3f, -8.02f}, {11, 4.5f, -7.8f}, p.white);
  world.Place(world.AddMesh(std::move(court)));
  const int board =
      world.AddSign("COURTYARD CAFE\nSOUP 3.50 TEA 1.20\nBREAD & CHEESE 4.75\nOPEN 9-17 MON-SAT",
                    Rgb(0.05f, 0.06f, 0.05f), Rgb(0.75f, 0.74f, 0.68f), 0.013f);
  world.Place(world.AddMesh(SignBoard(world, p, board, 0.5f)),
              Translate(2.9, 0, -2.2) * TurnY(-0.3));
  const int name =
      world.AddSign("HOTEL 42", Rgb(0.45f, 0.06f, 0.05f), Rgb(0.80f, 0.76f, 0.62f), 0.045f);
  const int panel = world.AddMesh(Panel(world, name));
  world.Place(panel, Transform::Identity(),
              [](double t) { return Translate(-2.2, 3.1, -4.5) * TurnY(1.9 * t + 0.4); });
  const int numbers = world.AddSign("0123456789\nABCDEFGHIJ\nKLMNOPQRST", Rgb(0.72f, 0.72f, 0.70f),
                                    Rgb(0.05f, 0.05f, 0.20f), 0.02f);
  const int plate = world.AddMesh(Panel(world, numbers));
  world.Place(plate, Transform::Identity(), [](double t) {
    return Translate(0.2 + 1.6 * std::sin(1.7 * t), 1.3 + 0.2 * std::sin(2.3 * t), -2.6) *
           Turn(Vec3d::UnitZ(), 0.4 * std::sin(2.9 * t));
  });
  // A ball that rolls along x: the turn matches the way.
  Mesh ball;
  ball.AddSphere(Vec3f::Zero(), 0.45f, 32, p.checker);
  const int ball_mesh = world.AddMesh(std::move(ball));
  world.Place(ball_mesh, Transform::Identity(), [](double t) {
    const double x = 2.4 * std::sin(1.1 * t - 0.8);
    return Translate(x, 0.45, -4.2) * Turn(Vec3d::UnitZ(), -x / 0.45);
  });
  const int wheel = world.AddMesh(Wheel(0.7f, 12, 0.014f, p.metal, p.dark));
  world.Place(wheel, Transform::Identity(), [](double t) {
    return Translate(-3.6, 1.2, -3.2) * TurnY(0.3) * Turn(Vec3d::UnitZ(), -2.2 * t);
  });
  Mesh stand;
  stand.AddTube({-3.6f, 0, -3.3f}, {-3.6f, 1.2f, -3.3f}, 0.03f, 0.03f, 8, p.metal);
  stand.AddWire({-8, 4.6f, -2}, {9, 5.2f, -8}, 0.7f, 0.01f, p.dark);
  stand.AddWire({-8, 4.2f, -5}, {9, 4.8f, -8}, 0.5f, 0.01f, p.dark);
  world.Place(world.AddMesh(std::move(stand)));
  Mesh lamp;
  lamp.AddTube({0, 0, 0}, {0, -1.6f, 0}, 0.008f, 0.008f, 5, p.dark);
  lamp.AddSphere({0, -1.7f, 0}, 0.16f, 16, p.lamp);
  const int lamp_mesh = world.AddMesh(std::move(lamp));
  for (int i = 0; i < 3; ++i) {
    const double phase = random(0, 6);
    world.Place(lamp_mesh, Transform::Identity(), [i, phase](double t) {
      return Translate(-4 + 3.3 * i, 4.4, -5.2) *
             Turn(Vec3d::UnitZ(), 0.35 * std::sin(2.4 * t + phase));
    });
  }
  const int crate = world.AddMesh(Crate(p, 0.8f));
  world.Place(crate, Translate(4.3, 0, -5.6) * TurnY(0.3));
  world.Place(crate, Translate(4.1, 0.82, -5.5) * TurnY(-0.3));
  world.Place(crate, Transform::Identity(), [](double t) {
    return Translate(-5.2 + 0.9 * std::sin(0.9 * t), 0, -5.8) * TurnY(0.2);
  });
  const int bush = world.AddMesh(Bush(p, Random(seed, 4), 0.6f));
  for (int i = 0; i < 4; ++i)
    world.Place(bush, Translate(random(-7, 7), 0, -7.3) * TurnY(random(0, 6)));
  const int tree = world.AddMesh(Tree(p, Random(seed, 5), 9));
  world.Place(tree, Translate(-6, 0, -13));
  world.Place(tree, Translate(5, 0, -15) * TurnY(2));
  world.camera = [](double, int) { return LookAt({0.3, 1.7, 2.6}, {-0.2, 1.7, -6}, 58); };
  world.light = [seed](double) {
    Light light;
    light.to_sun = SunDirection(48, -38);
    light.seed = Hash(static_cast<std::uint32_t>(seed), 12U);
    return light;
  };
  return world;
}

}  // namespace warplut::scenes
