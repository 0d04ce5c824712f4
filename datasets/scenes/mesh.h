// Triangle meshes and the builders that the scenes are made from.
//
// Texture coordinates are metres on the surface, so that a footprint in metres is one in texture
// space.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "datasets/scenes/linear.h"

namespace warplut::scenes {

struct Mesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;  // per vertex, unit
  std::vector<Vec2f> uvs;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<int> materials;  // per triangle

  // Appends a vertex and returns its index.
  std::uint32_t Add(const Vec3f& position, const Vec3f& normal, const Vec2f& uv);
  void AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, int material);
  // A rectangle from its corner and two edges; u along the first edge, v along the second, from (0,
  // 0). It faces right x up.
  void AddQuad(const Vec3f& corner, const Vec3f& right, const Vec3f& up, int material);
  // An axis-aligned box; side faces have v up.
  void AddBox(const Vec3f& low, const Vec3f& high, int side, int top);
  void AddBox(const Vec3f& low, const Vec3f& high, int material) {
    AddBox(low, high, material, material);
  }
  // A cylinder from a to b that may taper, `sides` around, without caps: poles, wires, trunks.
  void AddTube(const Vec3f& a, const Vec3f& b, float radius_a, float radius_b, int sides,
               int material);
  // A wire that hangs between a and b with this much sag at the middle, as a parabola.
  void AddWire(const Vec3f& a, const Vec3f& b, float sag, float radius, int material);
  void AddSphere(const Vec3f& centre, float radius, int rings, int material);
  // A ring around the z axis: the rim of a wheel.
  void AddTorus(float radius, float tube, int segments, int material);
  // A disc or cap around the z axis at height z, facing +z.
  void AddDisc(float z, float radius, int segments, int material);
  // Ground over [-half, half]^2, cells x cells quads, at height(x, z).
  void AddTerrain(float half, int cells, const std::function<float(float, float)>& height,
                  int material);
};

}  // namespace warplut::scenes
