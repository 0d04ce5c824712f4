// A room of pictures with a wall of mirror and a mirror that swings.
#include "datasets/scenes/builtin.h"
#include "datasets/scenes/worlds/props.h"

namespace warplut::scenes {

World Gallery(std::uint64_t seed) {
  World world;
  const Palette p = AddPalette(world, seed);
  Random random(seed, 7);
  const int mirror =
      world.AddMaterial({.pattern = Pattern::kMirror, .a = Rgb(0.88f, 0.92f, 0.90f)});
  Mesh room;
  room.AddQuad({-7, 0, 7}, {14, 0, 0}, {0, 0, -14}, p.checker);
  room.AddBox({-7.3f, 0, -7.3f}, {7.3f, 4, -7}, p.plaster, p.white);
  room.AddBox({-7.3f, 0, 7}, {7.3f, 4, 7.3f}, p.brick, p.white);
  room.AddBox({-7.3f, 0, -7}, {-7, 4, 7}, p.plaster, p.white);
  room.AddBox({7, 0, -7}, {7.3f, 4, 7}, p.brick, p.white);
  // The roof is open, with beams.
  for (int i = 0; i < 6; ++i) {
    const float z = -6 + 2.4f * static_cast<float>(i);
    room.AddBox({-7.3f, 4, z - 0.1f}, {7.3f, 4.25f, z + 0.1f}, p.planks);
  }
  room.AddQuad({-2.6f, 0.4f, -6.95f}, {5.2f, 0, 0}, {0, 3, 0}, mirror);
  for (const float x : {-2.7f, 2.6f})
    room.AddBox({x, 0.3f, -7}, {x + 0.1f, 3.5f, -6.88f}, p.planks);
  for (const float y : {0.3f, 3.4f})
    room.AddBox({-2.7f, y, -7}, {2.7f, y + 0.1f, -6.88f}, p.planks);
  world.Place(world.AddMesh(std::move(room)));
  const auto hang = [&](double x, double z, double turn, double width) {
    const int picture = world.AddMaterial(
        {.pattern = Pattern::kPoster,
         .a = Rgb(static_cast<float>(random(0.1, 0.8)), static_cast<float>(random(0.1, 0.7)),
                  static_cast<float>(random(0.1, 0.7))),
         .b = Rgb(static_cast<float>(random(0.02, 0.4)), static_cast<float>(random(0.02, 0.4)),
                  static_cast<float>(random(0.02, 0.5))),
         .size = static_cast<float>(width / 1.6),
         .seed = random.Bits()});
    const auto w = static_cast<float>(width), h = 0.75f * static_cast<float>(width);
    Mesh mesh;
    mesh.AddBox({-w / 2 - 0.07f, -0.07f, 0}, {w / 2 + 0.07f, h + 0.07f, 0.04f}, p.dark);
    mesh.AddQuad({-w / 2, 0, 0.045f}, {w, 0, 0}, {0, h, 0}, picture);
    world.Place(world.AddMesh(std::move(mesh)), Translate(x, 1.3, z) * TurnY(turn));
  };
  for (int i = 0; i < 4; ++i) {
    hang(-6.98, -5 + 3.1 * i, kPi / 2, random(1.2, 2.0));
    hang(6.98, -5 + 3.1 * i, -kPi / 2, random(1.2, 2.0));
    hang(-4.8 + 3.2 * i, 6.98, kPi, random(1.2, 2.0));
  }
  hang(-4.8, -6.98, 0, 1.8);
  hang(4.8, -6.98, 0, 1.8);
  const int label = world.AddSign("ROOM 9\nWORKS OF LIGHT\nDO NOT TOUCH", Rgb(0.70f, 0.68f, 0.62f),
                                  Rgb(0.05f, 0.05f, 0.06f), 0.011f);
  world.Place(world.AddMesh(SignBoard(world, p, label, 0.8f)),
              Translate(2.3, 0, -3.2) * TurnY(0.3));
  // The back of this one is read in the mirror.
  const int banner = world.AddSign("MIRRORED\n0123456789", Rgb(0.10f, 0.16f, 0.36f),
                                   Rgb(0.78f, 0.75f, 0.60f), 0.03f);
  world.Place(world.AddMesh(Panel(world, banner)), Transform::Identity(), [](double t) {
    return Translate(-1.6 + 0.5 * std::sin(1.4 * t), 2.3, -3.6) * TurnY(0.35 * std::sin(1.9 * t));
  });
  Mesh ball;
  ball.AddSphere(Vec3f::Zero(), 0.4f, 32, p.stripes);
  world.Place(world.AddMesh(std::move(ball)), Transform::Identity(), [](double t) {
    const double x = 2 * std::sin(1.3 * t);
    return Translate(x, 0.4, -4.9) * Turn(Vec3d::UnitZ(), -x / 0.4);
  });
  const int wheel = world.AddMesh(Wheel(0.55f, 10, 0.012f, p.metal, p.dark));
  world.Place(wheel, Transform::Identity(), [](double t) {
    return Translate(0.6, 1.7, -2.9) * TurnY(0.5) * Turn(Vec3d::UnitZ(), 1.8 * t);
  });
  // A cheval glass that swings about its upright.
  Mesh glass;
  glass.AddQuad({-0.6f, 0.3f, 0.02f}, {1.2f, 0, 0}, {0, 1.9f, 0}, mirror);
  glass.AddBox({-0.66f, 0.22f, -0.03f}, {0.66f, 2.28f, 0.015f}, p.planks);
  world.Place(world.AddMesh(std::move(glass)), Transform::Identity(), [](double t) {
    return Translate(-3.7, 0, -4.2) * TurnY(0.7 + 0.3 * std::sin(1.1 * t));
  });
  const int column = world.AddMesh(Column(p, 0.28f, 4));
  for (const double x : {-3.6, 3.6}) {
    for (const double z : {1.0, 5.0}) world.Place(column, Translate(x, 0, z));
  }
  world.camera = [](double t, int) {
    return LookAt({0.5 + 1.2 * std::sin(0.8 * t), 1.65, 0.6 - 0.5 * t / (1 + 0.2 * std::abs(t))},
                  {-0.4 + 0.6 * std::sin(0.6 * t + 1), 1.6, -6}, 60);
  };
  world.light = [seed](double) {
    Light light;
    light.to_sun = SunDirection(58, 25);
    light.ground = Rgb(0.34f, 0.30f, 0.26f);
    light.haze = 0;
    light.seed = Hash(static_cast<std::uint32_t>(seed), 17U);
    return light;
  };
  world.far_plane = 100;
  return world;
}

}  // namespace warplut::scenes
