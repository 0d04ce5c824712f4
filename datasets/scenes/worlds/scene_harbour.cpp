// A harbour in three takes with camera cuts between them.
#include "datasets/scenes/builtin.h"
#include "datasets/scenes/worlds/props.h"

namespace warplut::scenes {
namespace {

// A mast with shrouds and yards.
Mesh Boat(const Palette& p) {
  Mesh mesh;
  constexpr float kLength = 9, kBeam = 1.4f, kMast = 10;
  constexpr int kRibs = 14;
  // The hull: two sides that meet at bow and stern.
  for (const float side : {-1.f, 1.f}) {
    for (int i = 0; i < kRibs; ++i) {
      const auto rib = [&](int k, float y) {
        const float s = 2 * static_cast<float>(k) / kRibs - 1;
        const float half = kBeam * (1 - s * s) * (0.75f + 0.25f * y);
        return Vec3f(s * kLength / 2, y + 0.25f * s * s, side * half);
      };
      const Vec3f a = rib(i, -0.5f), b = rib(i + 1, -0.5f), c = rib(i + 1, 0.9f), d = rib(i, 0.9f);
      const Vec3f n = side * (b - a).cross(d - a).normalized();
      const auto u = [](const Vec3f& v) { return Vec2f(v.y(), v.x()); };
      const auto ia = mesh.Add(a, n, u(a)), ib = mesh.Add(b, n, u(b)), ic = mesh.Add(c, n, u(c)),
                 id = mesh.Add(d, n, u(d));
      mesh.AddTriangle(ia, ib, ic, p.planks);
      mesh.AddTriangle(ia, ic, id, p.planks);
    }
  }
  mesh.AddQuad({-0.3f * kLength, 0.6f, 0.55f * kBeam}, {0.6f * kLength, 0, 0},
               {0, 0, -1.1f * kBeam}, p.planks);
  mesh.AddBox({-2.2f, 0.6f, -0.6f}, {-0.4f, 1.5f, 0.6f}, p.white);
  mesh.AddTube({0.3f, 0.6f, 0}, {0.3f, kMast, 0}, 0.09f, 0.04f, 10, p.planks);
  mesh.AddTube({0.3f, 1.7f, 0}, {-3.6f, 1.9f, 0}, 0.05f, 0.04f, 8, p.planks);
  mesh.AddTube({0.3f, 7, -1.3f}, {0.3f, 7, 1.3f}, 0.03f, 0.03f, 8, p.planks);
  for (const float z : {-1.2f, 1.2f}) {
    for (const float x : {-0.6f, 0.f, 0.6f})
      mesh.AddTube({0.3f + x, 0.9f, z}, {0.3f, 9.4f, 0}, 0.009f, 0.009f, 5, p.dark);
    for (int k = 1; k < 12; ++k) {
      const float t = 0.07f * static_cast<float>(k), y = 0.9f + 8.5f * t;
      mesh.AddTube({-0.3f + 0.6f * t, y, z * (1 - t)}, {0.9f - 0.6f * t, y, z * (1 - t)}, 0.006f,
                   0.006f, 4, p.dark);
    }
  }
  mesh.AddTube({kLength / 2, 1.1f, 0}, {0.3f, 9.8f, 0}, 0.009f, 0.009f, 5, p.dark);
  mesh.AddTube({-kLength / 2, 1.1f, 0}, {0.3f, 9.8f, 0}, 0.009f, 0.009f, 5, p.dark);
  return mesh;
}

// A trussed tower with a jib.
Mesh Crane(const Palette& p) {
  Mesh mesh;
  constexpr float kHalf = 0.7f;
  constexpr int kStoreys = 9;
  for (const float x : {-kHalf, kHalf}) {
    for (const float z : {-kHalf, kHalf})
      mesh.AddTube({x, 0, z}, {x, 18, z}, 0.07f, 0.07f, 8, p.stripes);
  }
  for (int i = 0; i < kStoreys; ++i) {
    const float y = 2 * static_cast<float>(i), flip = i % 2 ? kHalf : -kHalf;
    for (const float s : {-kHalf, kHalf}) {
      mesh.AddTube({flip, y, s}, {-flip, y + 2, s}, 0.035f, 0.035f, 6, p.metal);
      mesh.AddTube({s, y, flip}, {s, y + 2, -flip}, 0.035f, 0.035f, 6, p.metal);
      mesh.AddTube({-kHalf, y, s}, {kHalf, y, s}, 0.035f, 0.035f, 6, p.metal);
    }
  }
  for (int i = 0; i < 12; ++i) {
    const float x = -3 + 1.2f * static_cast<float>(i);
    mesh.AddTube({x, 18, 0.4f}, {x + 1.2f, 18, -0.4f}, 0.03f, 0.03f, 6, p.metal);
    mesh.AddTube({x, 18, 0}, {x + 0.6f, 18.9f, 0}, 0.03f, 0.03f, 6, p.metal);
    mesh.AddTube({x + 0.6f, 18.9f, 0}, {x + 1.2f, 18, 0}, 0.03f, 0.03f, 6, p.metal);
  }
  for (const float z : {-0.4f, 0.4f})
    mesh.AddTube({-3, 18, z}, {11.4f, 18, z}, 0.05f, 0.05f, 8, p.stripes);
  mesh.AddTube({-3, 18.9f, 0}, {11.4f, 18.9f, 0}, 0.05f, 0.05f, 8, p.stripes);
  mesh.AddTube({9.5f, 18, 0}, {9.5f, 8, 0}, 0.015f, 0.015f, 5, p.dark);
  mesh.AddBox({8.6f, 6.8f, -0.5f}, {10.4f, 8, 0.5f}, p.sheet);
  return mesh;
}

}  // namespace

World Harbour(std::uint64_t seed) {
  World world;
  const Palette p = AddPalette(world, seed);
  Random random(seed, 8);
  const int water = world.AddMaterial(
      {.pattern = Pattern::kWater, .a = Rgb(0.03f, 0.07f, 0.08f), .seed = random.Bits()});
  Mesh site;
  site.AddQuad({-250, -1, 250}, {500, 0, 0}, {0, 0, -500}, water);
  site.AddBox({-60, -2, 2}, {60, 0, 40}, p.stone, p.paving);
  site.AddBox({-60, -2, -60}, {60, 0.2f, -34}, p.stone, p.asphalt);
  for (int i = 0; i < 16; ++i) {
    const float x = -30 + 4 * static_cast<float>(i);
    site.AddTube({x, 0, 2.6f}, {x, 0.55f, 2.6f}, 0.16f, 0.20f, 14, p.dark);
  }
  world.Place(world.AddMesh(std::move(site)));
  const char* const kLines[] = {"NORDSEE LINE\nNSLU 402318 4", "ORIENT CARGO\n22G1 - 30480 KG",
                                "ATLAS\nATLU 771 025 9"};
  for (int i = 0; i < 6; ++i) {
    Material paint = world.materials[p.sheet];
    paint.a = Rgb(static_cast<float>(random(0.06, 0.55)), static_cast<float>(random(0.06, 0.35)),
                  static_cast<float>(random(0.05, 0.4)));
    paint.seed = random.Bits();
    const int sheet = world.AddMaterial(paint);
    const int sign = world.AddSign(kLines[i % 3], paint.a * 0.8f, Rgb(0.76f, 0.75f, 0.72f), 0.035f);
    Mesh box;
    box.AddBox({-3, 0, -1.2f}, {3, 2.6f, 1.2f}, sheet);
    const Vec2f size = world.SignSize(sign);
    box.AddQuad({-2.8f, 1.2f, 1.22f}, {size.x(), 0, 0}, {0, size.y(), 0}, sign);
    for (const float x : {-3.f, 3.f})
      box.AddBox({x - 0.06f, -0.02f, -1.24f}, {x + 0.06f, 2.64f, 1.24f}, p.metal);
    const int mesh = world.AddMesh(std::move(box));
    for (int k = 0; k < 4; ++k) {
      world.Place(mesh, Translate(-24 + 8.2 * i + random(-0.4, 0.4), 0.2 + 2.65 * (k % 2),
                                  -38 - 4 * (k / 2)) *
                            TurnY(random(-0.03, 0.03)));
      if (k < 2)
        world.Place(mesh, Translate(10 + 6.4 * (i / 2), 2.65 * k, 8 + 3.2 * (i % 2)) *
                              TurnY(random(-0.03, 0.03)));
    }
  }
  const int boat = world.AddMesh(Boat(p));
  for (int i = 0; i < 7; ++i) {
    const double x = -22 + 8 * i, z = random(-14, -2), turn = random(-0.5, 0.5) + (i % 2 ? kPi : 0),
                 phase = random(0, 6);
    world.Place(boat, Transform::Identity(), [=](double t) {
      return Translate(x, -0.9 + 0.12 * std::sin(1.3 * t + phase), z) * TurnY(turn) *
             Turn(Vec3d::UnitX(), 0.06 * std::sin(1.1 * t + phase));
    });
  }
  const int crane = world.AddMesh(Crane(p));
  for (int i = 0; i < 3; ++i)
    world.Place(crane, Translate(-20 + 18 * i, 0.2, -36) * TurnY(random(-1, 1)));
  const int notice = world.AddSign("PIER 4\nALL VISITORS REPORT\nTO HARBOUR MASTER",
                                   Rgb(0.70f, 0.70f, 0.66f), Rgb(0.05f, 0.10f, 0.30f), 0.016f);
  world.Place(world.AddMesh(SignBoard(world, p, notice, 1.0f)),
              Translate(-2.6, 0, 4.2) * TurnY(0.35));
  world.Place(world.AddMesh(Railing(p, 16, 1.1f, 0.14f)), Translate(3, 0, 2.2));
  world.Place(world.AddMesh(Fence(p, 10, 1.8f)), Translate(12, 0, 6) * TurnY(0.1));
  const int block = world.AddMesh(Block(p, 14, 9, 8, p.facade));
  for (int i = 0; i < 5; ++i) world.Place(block, Translate(-34 + 17 * i, 0.2, -54));
  world.shots = 3;
  world.camera = [](double t, int shot) {
    if (shot == 0) return LookAt({-1 + 0.8 * t, 1.8, 7.5}, {-1.5 + 1.6 * t, 2.2, -10}, 58);
    if (shot == 1) return LookAt({22 - 1.2 * t, 4.5, 5}, {11, 1.8 + 0.2 * t, 4}, 50);
    return LookAt({-14, 3 + 0.6 * t, -18 + 0.5 * t}, {-4 + 2.0 * t, 6, -38}, 60);
  };
  world.light = [seed](double) {
    Light light;
    light.to_sun = SunDirection(34, 40);
    light.haze = 0.004f;
    light.seed = Hash(static_cast<std::uint32_t>(seed), 18U);
    return light;
  };
  world.far_plane = 400;
  return world;
}

}  // namespace warplut::scenes
