// What the camera sees through a position of the image: colour, depth, motion.
#pragma once

#include <optional>
#include <vector>

#include "datasets/scenes/tracer.h"
#include "datasets/scenes/view.h"
#include "datasets/scenes/world.h"

namespace warplut::scenes {

// A camera path: from the eye to what is seen, by way of at most one mirror.
struct Path {
  Vec3d direction;  // of the last segment, unit
  Vec3d point;      // end of the last segment, unless sky
  Hit hit;          // at the end; object -1: sky
  double length = 0;
  // The mirror, when there is one.
  Hit mirror;
  Vec3d mirror_point = Vec3d::Zero();
  Vec3d mirror_normal = Vec3d::Zero();
};

// The ray that a mirror in place of a surface reflects, and what it meets.
struct Reflection {
  Vec3d origin, direction;  // unit direction
  Hit hit;                  // object -1: sky
  Vec3d point;              // that is hit
  bool is_visible = false;  // to the camera, and from the side that is hit
};

// One frame of a world. Positions are (u, v) in [0, 1]^2 as in Lens; the methods may run in any
// threads.
class Integrator {
 public:
  // time: of the frame, seconds; since_previous: from the frame before, of the same take, to it;
  // shot: the take. aspect: width / height. footprint: angle over which textures are averaged,
  // radians.
  Integrator(const World& world, const Tracer& tracer, double time, double since_previous, int shot,
             double aspect, double footprint);

  Path Follow(const Vec2d& position) const;
  // A mirror about the interpolated normal of the surface at the position. The ray begins over the
  // surface by the width of the footprint at its depth. Nothing where the camera sees the sky.
  std::optional<Reflection> Reflect(const Vec2d& position) const;
  // Radiance along the path.
  Rgb Radiance(const Path& path) const;
  // View depth over far, clamped to 1; of the mirror's surface if there is a mirror.
  float Depth(const Path& path) const;
  // Where the end of the path was seen in the frame before; nothing when behind the camera.
  std::optional<Vec2d> Previous(const Path& path) const;

 private:
  struct Placed {
    Transform now, before, from_now;
    float scale = 1;
  };
  struct Point;  // a hit, interpolated

  Point Interpolate(const Hit& hit, const Vec3d& direction) const;
  const Material& MaterialOf(const Hit& hit) const;
  Rgb Shade(const Path& path) const;
  // A point or direction of an object, now, taken to the frame before.
  Vec3d PointBefore(int object, const Vec3d& point) const;
  Vec3d DirectionBefore(int object, const Vec3d& direction) const;

  const World& world_;
  double time_;
  float footprint_;
  Light light_;
  Lens lens_, lens_before_;
  std::vector<Placed> placed_;
  Tracer::Moment moment_;
};

}  // namespace warplut::scenes
