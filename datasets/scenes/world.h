// A scene as the renderer sees it: meshes placed in space and time, their materials, the light, the
// camera.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "datasets/scenes/material.h"
#include "datasets/scenes/mesh.h"
#include "datasets/scenes/sky.h"
#include "datasets/scenes/view.h"

namespace warplut::scenes {

// One placed mesh. Its transform at time t is motion(t) * placement; without motion it stands
// still.
struct Object {
  int mesh = 0;
  Transform placement = Transform::Identity();
  std::function<Transform(double)> motion;

  Transform At(double time) const { return motion ? motion(time) * placement : placement; }
};

struct World {
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<std::unique_ptr<const Text>> texts;
  std::vector<Object> objects;
  // Camera of shot `shot` at a time in seconds; frame 0 is time 0, and the frame before it is asked
  // for too.
  std::function<View(double time, int shot)> camera;
  std::function<Light(double time)> light = [](double) { return Light{}; };
  int shots = 1;  // takes of equal length, with a camera cut between
  double near_plane = 0.1;
  double far_plane = 300;

  int AddMaterial(const Material& material);
  // A panel with lettering; `texel` is the width of a font texel in metres. Returns the material.
  int AddSign(const std::string& lines, const Rgb& ground, const Rgb& ink, float texel);
  int AddMesh(Mesh mesh);
  void Place(int mesh, const Transform& placement = Transform::Identity());
  void Place(int mesh, const Transform& placement, std::function<Transform(double)> motion);
  // Width and height in metres of a sign's lettering.
  Vec2f SignSize(int material) const;
};

}  // namespace warplut::scenes
