#include "datasets/scenes/sky.h"

#include "datasets/scenes/pattern.h"
#include "datasets/srgb_curve.h"

namespace warplut::scenes {
namespace {

constexpr float kUsualExposure = 0.42f;

}  // namespace

Vec3f SunDirection(double elevation, double azimuth) {
  const double e = elevation * kDegree, a = azimuth * kDegree;
  return Vec3d(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)).cast<float>();
}

Rgb SkyRadiance(const Light& light, const Vec3f& direction, float footprint) {
  const float y = direction.y();
  if (y <= 0) return Mix(light.horizon, light.ground, SmoothStep(0, 0.25f, -y));
  const float height = std::sqrt(y);
  Rgb sky = Mix(light.horizon, light.zenith, height);
  // Clouds lie on a plane; near the horizon they are compressed and fade into the haze.
  const float stretch = 1 / (y + 0.12f);
  const Vec2f p(direction.x() * stretch * 1.3f, direction.z() * stretch * 1.3f);
  const float w = footprint * stretch * stretch;
  const float density = Fbm(p, w, 9, 0.62f, light.seed).value + 1.1f * light.cloud - 0.5f;
  const float cover = SmoothStep(0, 0.55f, density) * SmoothStep(0.01f, 0.15f, y);
  const float facing = std::max(0.f, direction.dot(light.to_sun));
  const Rgb lit = light.horizon * 0.6f +
                  light.sun * (0.22f + 0.12f * facing) * (1.15f - 0.6f * Saturate(density));
  sky = Mix(sky, lit, 0.92f * cover);
  const float glow = std::pow(facing, 64.f);
  const float disc = SmoothStep(0.99990f, 0.99996f, facing) * (1 - cover);
  return sky + light.sun * (0.25f * glow + 20 * disc);
}

Rgb Ambient(const Light& light, const Vec3f& normal) {
  const Rgb upper = 0.5f * (light.zenith + light.horizon);
  const float up = 0.5f + 0.5f * normal.y();
  // The half of the sky around the sun is brighter, which keeps the faces in shadow apart.
  const float side = 0.5f + 0.5f * normal.dot(light.to_sun);
  return Mix(light.ground, upper, up) * (0.55f + 0.45f * side);
}

Rgb Haze(const Light& light, const Rgb& radiance, float distance) {
  return Mix(light.horizon, radiance, std::exp(-light.haze * distance));
}

Rgb Exposed(const Rgb& radiance, float exposure) {
  return radiance.max(0.f) * (kUsualExposure * exposure);
}

Rgb DisplayCurve(const Rgb& x) {
  const Rgb mapped = ((x * (2.51f * x + 0.03f)) / (x * (2.43f * x + 0.59f) + 0.14f)).min(1.f);
  return {SrgbCurve(mapped[0]), SrgbCurve(mapped[1]), SrgbCurve(mapped[2])};
}

}  // namespace warplut::scenes
