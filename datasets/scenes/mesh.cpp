#include "datasets/scenes/mesh.h"

namespace warplut::scenes {
namespace {

// Two unit directions that with n form a right-handed frame.
void Frame(const Vec3f& n, Vec3f& s, Vec3f& t) {
  s = (std::abs(n.y()) < 0.9f ? Vec3f::UnitY() : Vec3f::UnitX()).cross(n).normalized();
  t = n.cross(s);
}

}  // namespace

std::uint32_t Mesh::Add(const Vec3f& position, const Vec3f& normal, const Vec2f& uv) {
  positions.push_back(position);
  normals.push_back(normal);
  uvs.push_back(uv);
  return static_cast<std::uint32_t>(positions.size() - 1);
}

void Mesh::AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, int material) {
  triangles.push_back({a, b, c});
  materials.push_back(material);
}

void Mesh::AddQuad(const Vec3f& corner, const Vec3f& right, const Vec3f& up, int material) {
  const Vec3f n = right.cross(up).normalized();
  const float w = right.norm(), h = up.norm();
  const auto a = Add(corner, n, {0, 0}), b = Add(corner + right, n, {w, 0});
  const auto c = Add(corner + right + up, n, {w, h}), d = Add(corner + up, n, {0, h});
  AddTriangle(a, b, c, material);
  AddTriangle(a, c, d, material);
}

void Mesh::AddBox(const Vec3f& low, const Vec3f& high, int side, int top) {
  const Vec3f d = high - low;
  const Vec3f x(d.x(), 0, 0), y(0, d.y(), 0), z(0, 0, d.z());
  AddQuad(low + z, x, y, side);
  AddQuad(low + x, -x, y, side);
  AddQuad(low, z, y, side);
  AddQuad(low + x + z, -z, y, side);
  AddQuad(low + y + z, x, -z, top);
  AddQuad(low, x, z, top);
}

void Mesh::AddTube(const Vec3f& a, const Vec3f& b, float radius_a, float radius_b, int sides,
                   int material) {
  const Vec3f axis = b - a;
  Vec3f s, t;
  Frame(axis.normalized(), s, t);
  const auto first = static_cast<std::uint32_t>(positions.size());
  for (int i = 0; i <= sides; ++i) {
    const float angle = kTau * static_cast<float>(i) / static_cast<float>(sides);
    const Vec3f n = std::cos(angle) * s + std::sin(angle) * t;
    const float u = angle * std::max(radius_a, radius_b);
    Add(a + radius_a * n, n, {u, 0});
    Add(b + radius_b * n, n, {u, axis.norm()});
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(sides); ++i) {
    const std::uint32_t k = first + 2 * i;
    AddTriangle(k, k + 2, k + 3, material);
    AddTriangle(k, k + 3, k + 1, material);
  }
}

void Mesh::AddWire(const Vec3f& a, const Vec3f& b, float sag, float radius, int material) {
  constexpr int kSegments = 16;
  Vec3f last = a;
  for (int i = 1; i <= kSegments; ++i) {
    const float t = static_cast<float>(i) / kSegments;
    const Vec3f next = a + t * (b - a) - Vec3f(0, 4 * sag * t * (1 - t), 0);
    AddTube(last, next, radius, radius, 5, material);
    last = next;
  }
}

void Mesh::AddSphere(const Vec3f& centre, float radius, int rings, int material) {
  const int columns = 2 * rings;
  const auto first = static_cast<std::uint32_t>(positions.size());
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j <= columns; ++j) {
      const float theta = 0.5f * kTau * static_cast<float>(i) / static_cast<float>(rings);
      const float phi = kTau * static_cast<float>(j) / static_cast<float>(columns);
      const Vec3f n(std::sin(theta) * std::sin(phi), -std::cos(theta),
                    std::sin(theta) * std::cos(phi));
      Add(centre + radius * n, n, {radius * phi, radius * theta});
    }
  }
  const auto stride = static_cast<std::uint32_t>(columns + 1);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(rings); ++i) {
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(columns); ++j) {
      const std::uint32_t k = first + i * stride + j;
      AddTriangle(k, k + 1, k + stride + 1, material);
      AddTriangle(k, k + stride + 1, k + stride, material);
    }
  }
}

void Mesh::AddTorus(float radius, float tube, int segments, int material) {
  constexpr std::uint32_t kAround = 8;
  const auto first = static_cast<std::uint32_t>(positions.size());
  for (int i = 0; i <= segments; ++i) {
    const float phi = kTau * static_cast<float>(i) / static_cast<float>(segments);
    const Vec3f out(std::cos(phi), std::sin(phi), 0);
    for (std::uint32_t j = 0; j <= kAround; ++j) {
      const float theta = kTau * static_cast<float>(j) / kAround;
      const Vec3f n = std::cos(theta) * out + std::sin(theta) * Vec3f::UnitZ();
      Add(radius * out + tube * n, n, {radius * phi, tube * theta});
    }
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(segments); ++i) {
    for (std::uint32_t j = 0; j < kAround; ++j) {
      const std::uint32_t k = first + i * (kAround + 1) + j;
      AddTriangle(k, k + kAround + 1, k + kAround + 2, material);
      AddTriangle(k, k + kAround + 2, k + 1, material);
    }
  }
}

void Mesh::AddDisc(float z, float radius, int segments, int material) {
  const auto centre = Add({0, 0, z}, Vec3f::UnitZ(), {0, 0});
  for (int i = 0; i <= segments; ++i) {
    const float phi = kTau * static_cast<float>(i) / static_cast<float>(segments);
    const Vec2f p(radius * std::cos(phi), radius * std::sin(phi));
    const auto k = Add({p.x(), p.y(), z}, Vec3f::UnitZ(), p);
    if (i > 0) AddTriangle(centre, k - 1, k, material);
  }
}

void Mesh::AddTerrain(float half, int cells, const std::function<float(float, float)>& height,
                      int material) {
  const auto first = static_cast<std::uint32_t>(positions.size());
  const float step = 2 * half / static_cast<float>(cells);
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const float x = -half + step * static_cast<float>(j),
                  z = -half + step * static_cast<float>(i);
      const float e = 0.5f * step;
      const Vec3f n(height(x - e, z) - height(x + e, z), 2 * e,
                    height(x, z - e) - height(x, z + e));
      Add({x, height(x, z), z}, n.normalized(), {x, -z});
    }
  }
  const auto stride = static_cast<std::uint32_t>(cells + 1);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(cells); ++i) {
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(cells); ++j) {
      const std::uint32_t k = first + i * stride + j;
      AddTriangle(k, k + stride, k + stride + 1, material);
      AddTriangle(k, k + stride + 1, k + 1, material);
    }
  }
}

}  // namespace warplut::scenes
