// A flat wall that soft shadows pass over. Nothing moves but the light.
#include <array>
#include <memory>

#include "datasets/scenes/builtin.h"
#include "datasets/scenes/hash.h"

namespace warplut::scenes {
namespace {

// A round shadow on the wall: dark within `inner` of its centre, gone from `outer` on.
struct Blot {
  Vec2f start, speed, swing;  // metres, metres per second, metres
  float rate;                 // of the swing, radians per second
  float inner, outer;         // metres
  float depth;                // the part of the sun that it takes

  float Hides(const Vec3f& point, float time) const {
    const Vec2f centre = start + time * speed + std::sin(rate * time) * swing;
    const float distance = (Vec2f(point.x(), point.y()) - centre).norm();
    return depth * (1 - SmoothStep(inner, outer, distance));
  }
};

// A slanted band: the shadow of a pole.
struct Band {
  Vec2f across;  // unit
  float start, speed, inner, outer, depth;

  float Hides(const Vec3f& point, float time) const {
    const float distance = std::abs(across.dot(Vec2f(point.x(), point.y())) - start - time * speed);
    return depth * (1 - SmoothStep(inner, outer, distance));
  }
};

constexpr int kBlots = 5, kBands = 2;

struct Shadows {
  std::array<Blot, kBlots> blots;
  std::array<Band, kBands> bands;

  float Reaching(const Vec3f& point, float time) const {
    float share = 1;
    for (const Blot& blot : blots) share *= 1 - blot.Hides(point, time);
    for (const Band& band : bands) share *= 1 - band.Hides(point, time);
    return share;
  }
};

}  // namespace

World Penumbra(std::uint64_t seed) {
  World world;
  Random random(seed, 31);
  const auto some = [&random](double low, double high) {
    return static_cast<float>(random(low, high));
  };
  // All of its detail is on the render grid too: errors are those of the light.
  const int wash = world.AddMaterial({.pattern = Pattern::kWash,
                                      .a = Rgb(0.62f, 0.56f, 0.46f),
                                      .b = Rgb(0.34f, 0.33f, 0.36f),
                                      .size = 0.3f,
                                      .seed = random.Bits()});
  Mesh wall;
  wall.AddQuad({-9, -6, 0}, {18, 0, 0}, {0, 12, 0}, wash);
  world.Place(world.AddMesh(std::move(wall)));

  auto shadows = std::make_shared<Shadows>();
  for (Blot& blot : shadows->blots) {
    const float inner = some(0.1, 0.5);
    blot = {.start = {some(-3.5, 3.5), some(-2, 2)},
            .speed = {some(-0.5, 0.5), some(-0.3, 0.3)},
            .swing = {some(0.3, 0.9), some(0.2, 0.6)},
            .rate = some(0.8, 2.2),
            .inner = inner,
            .outer = inner + some(0.4, 1.1),
            .depth = some(0.5, 0.95)};
  }
  shadows->bands = {{{.across = {0.93f, 0.37f},
                      .start = -4,
                      .speed = some(0.9, 1.3),
                      .inner = 0.05f,
                      .outer = 0.4f,
                      .depth = 0.8f},
                     {.across = {0.8f, -0.6f},
                      .start = 3.5f,
                      .speed = some(-0.7, -0.4),
                      .inner = 0.12f,
                      .outer = 0.7f,
                      .depth = 0.6f}}};
  world.camera = [](double, int) { return LookAt({0, 0, 6}, {0, 0, 0}, 50); };
  world.light = [seed, shadows](double t) {
    Light light;
    light.to_sun = SunDirection(35, 25);
    light.seed = Hash(static_cast<std::uint32_t>(seed), 31U);
    light.reaching = [shadows, time = static_cast<float>(t)](const Vec3f& point) {
      return shadows->Reaching(point, time);
    };
    return light;
  };
  world.far_plane = 40;
  return world;
}

}  // namespace warplut::scenes
