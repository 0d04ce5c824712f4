#include "datasets/scenes/integrator.h"

namespace warplut::scenes {
namespace {

std::vector<Transform> TransformsAt(const World& world, double time) {
  std::vector<Transform> transforms;
  transforms.reserve(world.objects.size());
  for (const Object& object : world.objects) transforms.push_back(object.At(time));
  return transforms;
}

Lens LensAt(const World& world, double time, int shot, double aspect) {
  return {world.camera(time, shot), aspect, world.near_plane, world.far_plane};
}

Vec3d Mirrored(const Vec3d& direction, const Vec3d& normal) {
  return direction - 2 * direction.dot(normal) * normal;
}

}  // namespace

struct Integrator::Point {
  Vec3f normal;  // unit, towards the ray's origin
  Vec2f uv;
  float facing = 1;  // cosine between normal and ray
};

Integrator::Integrator(const World& world, const Tracer& tracer, double time, double since_previous,
                       int shot, double aspect, double footprint)
    : world_(world),
      time_(time),
      footprint_(static_cast<float>(footprint)),
      light_(world.light(time)),
      lens_(LensAt(world, time, shot, aspect)),
      lens_before_(LensAt(world, time - since_previous, shot, aspect)),
      moment_(tracer, TransformsAt(world, time)) {
  placed_.reserve(world.objects.size());
  for (const Object& object : world.objects) {
    Placed placed;
    placed.now = object.At(time);
    placed.before = object.At(time - since_previous);
    placed.from_now = placed.now.inverse();
    placed.scale = static_cast<float>(std::cbrt(std::abs(placed.now.linear().determinant())));
    placed_.push_back(placed);
  }
}

const Material& Integrator::MaterialOf(const Hit& hit) const {
  return world_.materials[world_.meshes[world_.objects[hit.object].mesh].materials[hit.triangle]];
}

Integrator::Point Integrator::Interpolate(const Hit& hit, const Vec3d& direction) const {
  const Mesh& mesh = world_.meshes[world_.objects[hit.object].mesh];
  const auto& t = mesh.triangles[hit.triangle];
  const float w = 1 - hit.u - hit.v;
  const Vec3f local =
      w * mesh.normals[t[0]] + hit.u * mesh.normals[t[1]] + hit.v * mesh.normals[t[2]];
  Point point;
  point.normal = (placed_[hit.object].now.linear().cast<float>() * local).normalized();
  point.facing = -point.normal.dot(direction.cast<float>());
  if (point.facing < 0) {
    point.normal = -point.normal;
    point.facing = -point.facing;
  }
  point.uv = w * mesh.uvs[t[0]] + hit.u * mesh.uvs[t[1]] + hit.v * mesh.uvs[t[2]];
  return point;
}

Path Integrator::Follow(const Vec2d& position) const {
  Path path;
  Vec3d origin = lens_.eye();
  path.direction = lens_.Direction(position);
  path.hit = moment_.Intersect(origin, path.direction, static_cast<float>(world_.near_plane));
  if (path.hit.object < 0) return path;
  path.point = origin + path.hit.distance * path.direction;
  path.length = path.hit.distance;
  if (MaterialOf(path.hit).pattern != Pattern::kMirror) return path;
  path.mirror = path.hit;
  path.mirror_point = path.point;
  path.mirror_normal = Interpolate(path.hit, path.direction).normal.cast<double>();
  origin = path.point;
  path.direction = Mirrored(path.direction, path.mirror_normal);
  constexpr float kClear = 1e-3f;  // metres
  path.hit = moment_.Intersect(origin, path.direction, kClear);
  if (path.hit.object >= 0) {
    path.point = origin + path.hit.distance * path.direction;
    path.length += path.hit.distance;
  }
  return path;
}

std::optional<Reflection> Integrator::Reflect(const Vec2d& position) const {
  const auto near = static_cast<float>(world_.near_plane);
  const Vec3d eye = lens_.eye(), seen = lens_.Direction(position);
  const Hit first = moment_.Intersect(eye, seen, near);
  if (first.object < 0) return std::nullopt;
  const Vec3d surface = eye + first.distance * seen;
  const Vec3d normal = Interpolate(first, seen).normal.cast<double>();
  Reflection reflection;
  reflection.origin = surface + footprint_ * lens_.Depth(surface) * normal;
  reflection.direction = Mirrored(seen, normal);
  reflection.hit = moment_.Intersect(reflection.origin, reflection.direction);
  if (reflection.hit.object < 0) return reflection;
  reflection.point = reflection.origin + reflection.hit.distance * reflection.direction;
  const auto at = lens_.Project(reflection.point);
  if (!at || at->minCoeff() < 0 || at->maxCoeff() >= 1) return reflection;
  const Vec3d offset = reflection.point - eye, to_point = offset.normalized();
  const Hit nearest = moment_.Intersect(eye, to_point, near);
  constexpr double kSame = 1e-3;  // of the distance
  const bool is_nearest = nearest.object >= 0 && nearest.distance >= (1 - kSame) * offset.norm();
  const Vec3d towards = Interpolate(reflection.hit, reflection.direction).normal.cast<double>();
  reflection.is_visible = is_nearest && towards.dot(to_point) < 0;
  return reflection;
}

Rgb Integrator::Shade(const Path& path) const {
  const Vec3f direction = path.direction.cast<float>();
  if (path.hit.object < 0) return SkyRadiance(light_, direction, footprint_);
  const Point point = Interpolate(path.hit, path.direction);
  const Placed& placed = placed_[path.hit.object];
  const auto length = static_cast<float>(path.length);
  // A grazing footprint is an ellipse; the circle of the same area stands for it.
  const float width = footprint_ * length / std::sqrt(std::max(point.facing, 0.04f)) / placed.scale;
  const Surface surface =
      Evaluate(MaterialOf(path.hit), point.uv, width, static_cast<std::uint32_t>(path.hit.object),
               static_cast<float>(time_));
  Vec3f normal = point.normal;
  if (surface.slope.x() != 0 || surface.slope.y() != 0) {
    const Vec3f up = std::abs(normal.y()) < 0.95f ? Vec3f::UnitY() : Vec3f(0, 0, -1);
    const Vec3f u = up.cross(normal).normalized();
    const Vec3f v = normal.cross(u);
    normal = (normal - surface.slope.x() * u - surface.slope.y() * v).normalized();
  }
  float lit = normal.dot(light_.to_sun);
  lit = lit > 0 ? lit : -lit * surface.translucency;
  // Light that comes through a thin surface leaves on its far side.
  const float side = point.normal.dot(light_.to_sun);
  const bool reaches = surface.translucency > 0 || side > 0;
  const float clear = 1e-3f + 2e-4f * length;
  const Vec3f origin = path.point.cast<float>() + (side > 0 ? clear : -clear) * point.normal;
  const bool sunny = reaches && lit > 0 && !moment_.Occluded(origin, light_.to_sun);
  const float sun = sunny && light_.reaching ? light_.reaching(path.point.cast<float>()) : 1;
  Rgb radiance = surface.albedo * Ambient(light_, normal) + surface.emission;
  if (sunny) radiance += surface.albedo * light_.sun * (sun * lit);
  if (surface.gloss > 0) {
    const float grazing = 1 - Saturate(-normal.dot(direction));
    const float fresnel = surface.gloss * (0.04f + 0.96f * std::pow(grazing, 5.f));
    const Vec3f mirrored = direction - 2 * direction.dot(normal) * normal;
    if (fresnel > 0.02f) radiance += fresnel * SkyRadiance(light_, mirrored.cwiseAbs(), 0.05f);
    if (sunny)
      radiance += surface.gloss * 0.6f * sun * light_.sun *
                  std::pow(Saturate(mirrored.dot(light_.to_sun)), 80.f);
  }
  return Haze(light_, radiance, length);
}

Rgb Integrator::Radiance(const Path& path) const {
  Rgb radiance = Shade(path);
  if (path.mirror.object >= 0) radiance *= MaterialOf(path.mirror).a;
  return radiance;
}

float Integrator::Depth(const Path& path) const {
  const bool mirrored = path.mirror.object >= 0;
  if (!mirrored && path.hit.object < 0) return 1;
  const double depth = lens_.Depth(mirrored ? path.mirror_point : path.point) / world_.far_plane;
  return static_cast<float>(std::min(depth, 1.0));
}

Vec3d Integrator::PointBefore(int object, const Vec3d& point) const {
  const Placed& placed = placed_[object];
  return placed.before * (placed.from_now * point);
}

Vec3d Integrator::DirectionBefore(int object, const Vec3d& direction) const {
  const Placed& placed = placed_[object];
  return (placed.before.linear() * (placed.from_now.linear() * direction)).normalized();
}

std::optional<Vec2d> Integrator::Previous(const Path& path) const {
  const bool sky = path.hit.object < 0;
  if (path.mirror.object < 0) {
    if (sky) return lens_before_.ProjectFromEye(path.direction);
    return lens_before_.Project(PointBefore(path.hit.object, path.point));
  }
  // The image behind the mirror is what projects: reflect across the plane as it was.
  const Vec3d normal = DirectionBefore(path.mirror.object, path.mirror_normal);
  if (sky) return lens_before_.ProjectFromEye(Mirrored(path.direction, normal));
  const Vec3d on_plane = PointBefore(path.mirror.object, path.mirror_point);
  const Vec3d point = PointBefore(path.hit.object, path.point);
  return lens_before_.Project(point - 2 * (point - on_plane).dot(normal) * normal);
}

}  // namespace warplut::scenes
