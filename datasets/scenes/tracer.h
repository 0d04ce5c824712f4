// Ray queries against a world at one moment, by Embree.
#pragma once

#include <memory>
#include <vector>

#include "datasets/scenes/linear.h"
#include "datasets/scenes/world.h"

namespace warplut::scenes {

struct Hit {
  int object = -1;  // -1: nothing was hit
  int triangle = 0;
  float u = 0, v = 0;  // barycentric weights of the triangle's second and third vertex
  double distance = 0;
};

// The acceleration structures of a world's meshes, shared by all frames. Cut-out materials are
// tested where they are hit. The world must outlive it.
class Tracer {
 public:
  // Throws Error when Embree cannot start.
  explicit Tracer(const World& world);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  // The objects at one moment: transforms[i] places world.objects[i]. Queries may run in any
  // threads.
  class Moment {
   public:
    Moment(const Tracer& tracer, const std::vector<Transform>& transforms);
    ~Moment();
    Moment(const Moment&) = delete;
    Moment& operator=(const Moment&) = delete;

    // The nearest hit along a unit direction.
    Hit Intersect(const Vec3d& origin, const Vec3d& direction, float from = 0) const;
    bool Occluded(const Vec3f& origin, const Vec3f& direction) const;

   private:
    struct State;
    std::unique_ptr<State> state_;
  };

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warplut::scenes
