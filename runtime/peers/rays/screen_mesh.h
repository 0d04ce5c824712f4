// A ray against the mesh of mesh projection, at rest (runtime/peers/generation/mesh_projection.h):
// triangles in place of pixels (docs/METHODS.md).
//
// Each tile of `tile` pixels has the vertex that mesh projection gives it: at F, the nearest of the
// 3 x 3 pixels around the steepest one, anchored at the border of the screen in the first and last
// row and column. A vertex whose B, the farthest of these pixels, is not alike in depth is torn: it
// has both depths. Each triangle takes there F or B, so that the inverse depths of its corners
// differ least; of equal choices that with more of F. So the mesh ends at the edge of an object
// and goes on behind. Triangles are planes in position and inverse depth, as in the world.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/image_view.h"
#include "runtime/parameters.h"
#include "runtime/peers/rays/screen_ray.h"

namespace warplut::peers {

struct ScreenMeshOptions {
  int tile = 16;                                         // pixels, 4 to 64
  float tear = Parameters().generation_depth_threshold;  // depths are alike up to 1 + tear, > 0

  // Otherwise *why (if not null) names the option and its range.
  bool IsValid(std::string* why = nullptr) const;
};

class ScreenMesh {
 public:
  // `depth` is R32F, not empty, and outlives the mesh; options are valid.
  ScreenMesh(const ImageView& depth, const ScreenMeshOptions& options);

  // Where the ray first goes behind a triangle, from in front of it, near the pixel there: their
  // depths differ by a factor of at most 1 + thickness. Tile after tile: a tile whose triangles are
  // all nearer or all farther than the ray is passed; else those that the tiles before did not test
  // are tested. thickness >= 0; infinity takes every pixel that has a depth.
  ScreenHit Trace(const ScreenRay& ray, double thickness) const;
  // Tests every triangle: the same, but for rounding where a ray passes the corner of a tile.
  ScreenHit TraceReference(const ScreenRay& ray, double thickness) const;

  // Positions and inverse depths of the corners of triangle i.
  using Triangle3 = std::array<ScreenRay::Point, 3>;
  int Triangles() const { return 2 * static_cast<int>(quads_.size()); }
  Triangle3 TriangleAt(int i) const;

 private:
  struct Vertex {
    float x, y;
    float front, back;  // inverse depths; the same where it is not torn
  };
  // Tiles that a quad reaches, first and last in each axis, and the inverse depths of its corners.
  struct Quad {
    int left, right, top, bottom;
    std::array<std::array<float, 3>, 2> inverse;
  };
  struct Tile {
    float least, greatest;  // inverse depths of its triangles
    std::vector<std::uint32_t> quads;
  };

  Vertex PlaceVertex(int column, int row) const;
  Quad MakeQuad(int column, int row) const;
  void TestQuad(const ScreenRay& ray, double thickness, std::uint32_t quad, ScreenHit& hit) const;

  ImageView depth_;
  ScreenMeshOptions options_;
  int columns_, rows_;  // of vertices
  int tile_columns_, tile_rows_;
  std::vector<Vertex> vertices_;
  std::vector<Quad> quads_;
  std::vector<Tile> tiles_;
};

}  // namespace warplut::peers
