#include "datasets/scenes/worlds/props.h"

namespace warplut::scenes {
namespace {

// A square card around a centre, in a random orientation, with texture coordinates of its own.
void AddCard(Mesh& mesh, Random& random, const Vec3f& centre, float side, const Vec3f& outward,
             int material) {
  const auto axis = [&random] {
    return Vec3d(random(-1, 1), random(-1, 1), random(-1, 1)).cast<float>().normalized().eval();
  };
  const Vec3f n = (axis() + 0.7f * outward).normalized();
  const Vec3f s = n.cross(axis()).normalized(), t = n.cross(s);
  const auto offset = Vec2d(random.Below(64), random.Below(64)).cast<float>().eval();
  const Vec3f normal = (n + outward).normalized();
  const auto corner = [&](float x, float y) {
    return mesh.Add(centre + side * ((x - 0.5f) * s + (y - 0.5f) * t), normal,
                    offset + Vec2f(x, y) * side);
  };
  const auto a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
  mesh.AddTriangle(a, b, c, material);
  mesh.AddTriangle(a, c, d, material);
}

}  // namespace

Palette AddPalette(World& world, std::uint64_t seed) {
  Random random(seed, 0x50A1);
  const auto tint = [&random](float r, float g, float b) {
    const double light = random(0.85, 1.15);
    return Rgb(static_cast<float>(r * light * random(0.9, 1.1)), static_cast<float>(g * light),
               static_cast<float>(b * light * random(0.9, 1.1)));
  };
  const auto add = [&](Pattern pattern, const Rgb& a, const Rgb& b, float size) {
    return world.AddMaterial(
        {.pattern = pattern, .a = a, .b = b, .size = size, .seed = random.Bits()});
  };
  Palette p{};
  p.brick = add(Pattern::kBrick, tint(0.36f, 0.15f, 0.10f), tint(0.46f, 0.43f, 0.38f), 0.26f);
  p.roof = add(Pattern::kBrick, tint(0.26f, 0.11f, 0.08f), tint(0.07f, 0.05f, 0.05f), 0.42f);
  p.plaster = add(Pattern::kPlaster, tint(0.62f, 0.55f, 0.42f), tint(0.34f, 0.29f, 0.24f), 1);
  p.stone = add(Pattern::kBrick, tint(0.44f, 0.41f, 0.36f), tint(0.20f, 0.19f, 0.17f), 0.62f);
  p.paving = add(Pattern::kPaving, tint(0.36f, 0.34f, 0.31f), tint(0.10f, 0.10f, 0.09f), 0.5f);
  p.asphalt = add(Pattern::kAsphalt, tint(0.10f, 0.10f, 0.11f), tint(0.30f, 0.29f, 0.28f), 1);
  p.planks = add(Pattern::kPlanks, tint(0.36f, 0.23f, 0.12f), tint(0.05f, 0.03f, 0.02f), 0.14f);
  p.facade = add(Pattern::kFacade, tint(0.50f, 0.38f, 0.28f), tint(0.66f, 0.64f, 0.58f), 2.4f);
  p.ground = add(Pattern::kGround, tint(0.22f, 0.16f, 0.09f), tint(0.13f, 0.21f, 0.05f), 1);
  p.rock = add(Pattern::kRock, tint(0.34f, 0.31f, 0.27f), tint(0.17f, 0.15f, 0.14f), 1);
  p.bark = add(Pattern::kBark, tint(0.22f, 0.16f, 0.11f), tint(0.06f, 0.045f, 0.03f), 1);
  p.leaf = add(Pattern::kLeaf, tint(0.10f, 0.24f, 0.04f), tint(0.24f, 0.30f, 0.06f), 0.11f);
  p.blade = add(Pattern::kBlade, tint(0.05f, 0.10f, 0.02f), tint(0.30f, 0.38f, 0.10f), 1);
  p.metal = add(Pattern::kMetal, tint(0.42f, 0.43f, 0.45f), tint(0.26f, 0.13f, 0.06f), 1);
  p.dark = add(Pattern::kPlain, tint(0.045f, 0.045f, 0.05f), Rgb(0, 0, 0), 1);
  p.stripes = add(Pattern::kStripes, Rgb(0.75f, 0.55f, 0.04f), Rgb(0.03f, 0.03f, 0.03f), 0.35f);
  p.checker = add(Pattern::kChecker, Rgb(0.70f, 0.68f, 0.62f), Rgb(0.05f, 0.05f, 0.06f), 0.25f);
  p.sheet = add(Pattern::kCorrugated, tint(0.10f, 0.25f, 0.36f), tint(0.24f, 0.11f, 0.05f), 0.20f);
  p.lattice = add(Pattern::kLattice, tint(0.40f, 0.41f, 0.42f), Rgb(0, 0, 0), 0.07f);
  p.lamp = add(Pattern::kLamp, Rgb(2.6f, 2.2f, 1.5f), Rgb(0, 0, 0), 1);
  p.white = add(Pattern::kPlain, tint(0.72f, 0.71f, 0.68f), Rgb(0, 0, 0), 1);
  return p;
}

Mesh House(const Palette& p, float width, float height, float depth, int wall) {
  Mesh mesh;
  const float x = width / 2, z = depth / 2, eave = 0.35f, ridge = height + 0.4f * depth;
  mesh.AddBox({-x, 0, -z}, {x, height, z}, wall);
  mesh.AddBox({-x - 0.08f, 0, -z - 0.08f}, {x + 0.08f, 0.6f, z + 0.08f}, p.stone);
  mesh.AddBox({-x - 0.1f, height - 0.18f, -z - 0.1f}, {x + 0.1f, height, z + 0.1f}, p.white);
  const float drop = 0.8f * eave;  // of the roof beyond the wall
  const Vec3f left(-x - eave, height - drop, z + eave), right(2 * x + 2 * eave, 0, 0);
  mesh.AddQuad(left, right, Vec3f(0, ridge - height + drop, -z - eave), p.roof);
  mesh.AddQuad(left + right - Vec3f(0, 0, depth + 2 * eave), -right,
               Vec3f(0, ridge - height + drop, z + eave), p.roof);
  for (const float side : {-1.f, 1.f}) {
    const auto a = mesh.Add({side * x, height, z}, {side, 0, 0}, {0, 0});
    const auto b = mesh.Add({side * x, height, -z}, {side, 0, 0}, {depth, 0});
    const auto c = mesh.Add({side * x, ridge, 0}, {side, 0, 0}, {z, ridge - height});
    mesh.AddTriangle(a, b, c, p.planks);
  }
  mesh.AddBox({0.2f * x, ridge - 0.9f, -0.35f}, {0.2f * x + 0.7f, ridge + 0.8f, 0.35f}, p.brick);
  return mesh;
}

Mesh Block(const Palette& p, float width, float height, float depth, int wall) {
  Mesh mesh;
  const float x = width / 2, z = depth / 2;
  mesh.AddBox({-x, 0, -z}, {x, height, z}, wall, p.asphalt);
  for (float y = 3; y < height; y += 6) {
    mesh.AddBox({-x - 0.12f, y - 0.12f, -z - 0.12f}, {x + 0.12f, y + 0.06f, z + 0.12f}, p.white);
  }
  mesh.AddBox({-x - 0.2f, height - 0.1f, -z - 0.2f}, {x + 0.2f, height + 0.5f, z + 0.2f}, p.stone,
              p.asphalt);
  mesh.AddTube({0.6f * x, height, 0}, {0.6f * x, height + 4, 0}, 0.03f, 0.02f, 6, p.dark);
  mesh.AddTube({0.3f * x, height + 3, 0}, {0.9f * x, height + 3, 0}, 0.015f, 0.015f, 5, p.dark);
  mesh.AddTube({0.4f * x, height + 3.5f, 0}, {0.8f * x, height + 3.5f, 0}, 0.015f, 0.015f, 5,
               p.dark);
  return mesh;
}

Mesh LampPost(const Palette& p, float height) {
  Mesh mesh;
  mesh.AddTube({0, 0, 0}, {0, height, 0}, 0.09f, 0.05f, 12, p.metal);
  mesh.AddBox({-0.18f, 0, -0.18f}, {0.18f, 0.35f, 0.18f}, p.metal);
  mesh.AddTube({0, height, 0}, {0.9f, height + 0.25f, 0}, 0.035f, 0.03f, 8, p.metal);
  mesh.AddBox({0.75f, height + 0.1f, -0.12f}, {1.25f, height + 0.22f, 0.12f}, p.dark);
  mesh.AddBox({0.8f, height + 0.07f, -0.09f}, {1.2f, height + 0.1f, 0.09f}, p.lamp);
  return mesh;
}

Mesh SignBoard(const World& world, const Palette& p, int sign, float clearance) {
  Mesh mesh;
  const Vec2f size = world.SignSize(sign);
  const float x = size.x() / 2;
  mesh.AddQuad({-x, clearance, 0.03f}, {size.x(), 0, 0}, {0, size.y(), 0}, sign);
  mesh.AddBox({-x - 0.04f, clearance - 0.04f, -0.03f},
              {x + 0.04f, clearance + size.y() + 0.04f, 0.02f}, p.planks);
  for (const float side : {-0.8f, 0.8f}) {
    mesh.AddTube({side * x, 0, -0.06f}, {side * x, clearance + size.y(), -0.06f}, 0.04f, 0.04f, 8,
                 p.metal);
  }
  return mesh;
}

Mesh Panel(const World& world, int sign) {
  Mesh mesh;
  const Vec2f size = world.SignSize(sign);
  const float x = size.x() / 2, y = size.y() / 2;
  mesh.AddQuad({-x, -y, 0.02f}, {size.x(), 0, 0}, {0, size.y(), 0}, sign);
  mesh.AddQuad({x, -y, -0.02f}, {-size.x(), 0, 0}, {0, size.y(), 0}, sign);
  return mesh;
}

Mesh Tree(const Palette& p, Random random, float height) {
  Mesh mesh;
  const float crown = 0.36f * height, middle = 0.64f * height;
  mesh.AddTube({0, -0.2f, 0}, {0, middle, 0}, 0.035f * height, 0.015f * height, 10, p.bark);
  for (int i = 0; i < 9; ++i) {
    const auto angle = static_cast<float>(random(0, kTau)),
               rise = static_cast<float>(random(0.1, 0.8));
    const Vec3f from(0, static_cast<float>(random(0.35, 0.62)) * height, 0);
    const Vec3f to = from + 0.8f * crown * Vec3f(std::cos(angle), rise, std::sin(angle));
    mesh.AddTube(from, to, 0.012f * height, 0.003f * height, 6, p.bark);
  }
  for (int i = 0; i < 260; ++i) {
    const Vec3f d = Vec3d(random(-1, 1), random(-0.8, 1), random(-1, 1)).cast<float>();
    const Vec3f out = d.normalized();
    const float r = crown * static_cast<float>(std::sqrt(random(0.15, 1)));
    AddCard(mesh, random, Vec3f(0, middle, 0) + r * out,
            0.17f * height * static_cast<float>(random(0.7, 1.2)), out, p.leaf);
  }
  return mesh;
}

Mesh Bush(const Palette& p, Random random, float radius) {
  Mesh mesh;
  for (int i = 0; i < 90; ++i) {
    const Vec3f out =
        Vec3d(random(-1, 1), random(-0.1, 1), random(-1, 1)).cast<float>().normalized();
    const float r = radius * static_cast<float>(random(0.5, 1));
    AddCard(mesh, random, r * out, 0.5f * radius, out, p.leaf);
  }
  return mesh;
}

Mesh Grass(const Palette& p, Random random, int blades, float radius, float height) {
  Mesh mesh;
  for (int i = 0; i < blades; ++i) {
    const double angle = random(0, kTau), r = radius * std::sqrt(random(0, 1)),
                 turn = random(0, kTau);
    const Vec3f root(static_cast<float>(r * std::cos(angle)), -0.05f,
                     static_cast<float>(r * std::sin(angle)));
    const Vec3f across(static_cast<float>(std::cos(turn)), 0, static_cast<float>(std::sin(turn)));
    const Vec3f lean(-across.z(), 0, across.x());
    const float tall = height * static_cast<float>(random(0.5, 1.1)),
                bend = tall * static_cast<float>(random(0.1, 0.7));
    const float width = 0.014f;
    const Vec3f normal = (lean + 0.8f * Vec3f::UnitY()).normalized();
    const Vec3f middle = root + Vec3f(0, 0.6f * tall, 0) + 0.35f * bend * lean;
    const auto a = mesh.Add(root - width * across, normal, {-width, 0});
    const auto b = mesh.Add(root + width * across, normal, {width, 0});
    const auto c = mesh.Add(middle + 0.7f * width * across, normal, {width, 0.6f * tall});
    const auto d = mesh.Add(middle - 0.7f * width * across, normal, {-width, 0.6f * tall});
    const auto e = mesh.Add(root + Vec3f(0, tall, 0) + bend * lean, normal, {0, tall});
    mesh.AddTriangle(a, b, c, p.blade);
    mesh.AddTriangle(a, c, d, p.blade);
    mesh.AddTriangle(d, c, e, p.blade);
  }
  return mesh;
}

Mesh Fence(const Palette& p, float length, float height) {
  Mesh mesh;
  const float x = length / 2;
  mesh.AddQuad({-x, 0.05f, 0}, {length, 0, 0}, {0, height - 0.1f, 0}, p.lattice);
  const int posts = std::max(1, static_cast<int>(length / 2.5f));
  for (int i = 0; i <= posts; ++i) {
    const float at = -x + length * static_cast<float>(i) / static_cast<float>(posts);
    mesh.AddTube({at, 0, 0}, {at, height, 0}, 0.03f, 0.03f, 8, p.metal);
  }
  for (const float y : {0.05f, height - 0.05f})
    mesh.AddTube({-x, y, 0}, {x, y, 0}, 0.018f, 0.018f, 6, p.metal);
  return mesh;
}

Mesh Railing(const Palette& p, float length, float height, float spacing) {
  Mesh mesh;
  const float x = length / 2;
  const int bars = std::max(1, static_cast<int>(length / spacing));
  for (int i = 0; i <= bars; ++i) {
    const float at = -x + length * static_cast<float>(i) / static_cast<float>(bars);
    mesh.AddTube({at, 0, 0}, {at, height, 0}, 0.011f, 0.011f, 6, p.dark);
  }
  for (const float y : {0.12f * height, 0.95f * height}) {
    mesh.AddBox({-x, y - 0.02f, -0.02f}, {x, y + 0.02f, 0.02f}, p.dark);
  }
  return mesh;
}

Mesh Crate(const Palette& p, float side) {
  Mesh mesh;
  const float h = side / 2, edge = 0.09f * side, out = 0.02f * side;
  mesh.AddBox({-h, 0, -h}, {h, side, h}, p.planks);
  for (const float x : {-h, h}) {
    for (const float z : {-h, h}) {
      mesh.AddBox({x - edge, -out, z - edge}, {x + edge, side + out, z + edge}, p.planks, p.metal);
    }
  }
  return mesh;
}

Mesh Wheel(float radius, int spokes, float thickness, int rim, int spoke) {
  Mesh mesh;
  mesh.AddTorus(radius, 2.2f * thickness, 64, rim);
  mesh.AddTube({0, 0, -0.1f * radius}, {0, 0, 0.1f * radius}, 0.09f * radius, 0.09f * radius, 16,
               rim);
  mesh.AddDisc(0.1f * radius, 0.09f * radius, 16, rim);
  for (int i = 0; i < spokes; ++i) {
    const float angle = kTau * static_cast<float>(i) / static_cast<float>(spokes);
    const Vec3f out(std::cos(angle), std::sin(angle), 0);
    mesh.AddTube(0.08f * radius * out, radius * out, thickness, thickness, 6, spoke);
  }
  return mesh;
}

Mesh Column(const Palette& p, float radius, float height) {
  Mesh mesh;
  const float plate = 1.35f * radius, thick = 0.35f * radius;
  mesh.AddBox({-plate, 0, -plate}, {plate, thick, plate}, p.stone);
  mesh.AddBox({-plate, height - thick, -plate}, {plate, height, plate}, p.stone);
  mesh.AddTube({0, thick, 0}, {0, height - thick, 0}, 0.9f * radius, 0.8f * radius, 40, p.white);
  constexpr int kFlutes = 18;
  for (int i = 0; i < kFlutes; ++i) {
    const float angle = kTau * static_cast<float>(i) / kFlutes;
    const Vec3f out(std::cos(angle), 0, std::sin(angle));
    mesh.AddTube(0.93f * radius * out + Vec3f(0, thick, 0),
                 0.83f * radius * out + Vec3f(0, height - thick, 0), 0.09f * radius, 0.08f * radius,
                 7, p.white);
  }
  return mesh;
}

}  // namespace warplut::scenes
