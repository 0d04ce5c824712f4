// Mesh projection (docs/METHODS.md): every tile of frame 1 has one vertex, where depth changes
// most; the vertices are moved, and the mesh between them is drawn into the generated frame.
//
// A pixel p of frame 1 moves as its depth and the cameras say (PointCarrier), or without cameras by
// its linear motion. All places are counted in pixels from the centre of the first one.
//
// Vertices. The tile's vertex is the pixel of the largest squared gradient of inverse depth,
//   (g(x + 1, y) - g(x, y))^2 + (g(x, y + 1) - g(x, y))^2,
// of equal ones the first in reading order. Of the 3 x 3 pixels around it F is the nearest to the
// camera and B the farthest. The vertex is where F moves to and shows F. If F and B keep their
// direction and come to be more than mesh_tensile pixels apart, it shows B: the foreground is not
// stretched over what it uncovers. The first and the last vertices of each axis are anchored at the
// border of the frame and show it.
//
// Pixels. A triangle that covers a pixel centre q shows there u, affine between its vertices. The
// depth of frame 1 at u, moved, is compared: the nearest wins. Then the point that q itself shows,
// with that depth, is carried back to frame 1, to v. If frame 1 is alike in depth at u and v
// (DepthTolerance), and v is more than mesh_shear pixels from u, q shows v.
// Distances are the larger ones of both axes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "runtime/camera_motion.h"
#include "runtime/generation/motion/target_motion.h"
#include "runtime/peers/generation/triangle.h"

namespace warplut::peers {

// Vertices farther out, in pixels, are not drawn.
inline constexpr float kFarthestVertex = 2.0f * kLargestSize;

struct MeshVertex {
  Vector at, shows;
};

// The vertices of a job, in the buffer that splats have for displacements. Each row begins with the
// least and the greatest row of pixels that its vertices reach.
class VertexGrid {
 public:
  static constexpr int kLeastTile = 4;
  static constexpr int kFloats = 4;  // of a vertex: at, shows; and at the beginning of a row

  template <class Motion>
  VertexGrid(const GenerationJob& job, const Motion& buffer)
      : tile_(TileOf(job)),
        columns_(Count(job.width(), tile_)),
        rows_(Count(job.height(), tile_)),
        floats_(const_cast<float*>(buffer.xy)) {}

  // Bytes that the vertices of the smallest tile take.
  static std::size_t Bytes(int width, int height) {
    return sizeof(float) * kFloats * static_cast<std::size_t>(Count(width, kLeastTile) + 1) *
           static_cast<std::size_t>(Count(height, kLeastTile));
  }
  static int TileOf(const GenerationJob& job) {
    return static_cast<int>(job.options.parameters.mesh_tile + 0.5f);
  }

  // Vertices along an axis: one for each tile, and at least the two borders.
  static int Count(int size, int tile) { return std::max(2, (size + tile - 1) / tile); }

  int tile() const { return tile_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }

  float* floats() const { return floats_; }
  float* Row(int row) const { return floats_ + std::ptrdiff_t{kFloats} * row * stride(); }
  // Of rows, in vertices; where a vertex is among all.
  int stride() const { return columns_ + 1; }
  std::uint32_t Index(int column, int row) const {
    return static_cast<std::uint32_t>(row * stride() + column + 1);
  }
  MeshVertex At(std::uint32_t index) const {
    const float* v = floats_ + std::size_t{kFloats} * index;
    return {{v[0], v[1]}, {v[2], v[3]}};
  }
  void Set(int column, int row, const MeshVertex& vertex) const {
    float* v = floats_ + std::size_t{kFloats} * Index(column, row);
    v[0] = vertex.at.x;
    v[1] = vertex.at.y;
    v[2] = vertex.shows.x;
    v[3] = vertex.shows.y;
  }

 private:
  int tile_, columns_, rows_;
  float* floats_;
};

// Where a point of frame 1 is in the generated frame, and its depth there.
struct Carried {
  Vector at;
  float depth;
  bool shown;  // false: behind the camera, or without motion
};

// Carries the point at p, which has the depth and, without cameras, the motion of pixel n.
Carried CarryAt(const GenerationJob& job, Vector p, PixelIndex n);

// The pixel at p, or the nearest one to it; p is finite.
inline PixelIndex PixelAt(const GenerationJob& job, Vector p) {
  const auto along = [](float v, int size) {
    return static_cast<int>(std::clamp(std::floor(v + 0.5f), 0.0f, static_cast<float>(size - 1)));
  };
  return {along(p.x, job.width()), along(p.y, job.height())};
}

inline float Farther(Vector v) { return std::max(std::abs(v.x), std::abs(v.y)); }

// Inverse of a clean depth.
inline float InverseOf(float depth) {
  return depth < kFarthestDepth ? 1.0f / std::max(depth, kLeastDepth) : 0.0f;
}

// The pixel of the largest gradient among columns [x0, x1) and rows [y0, y1).
PixelIndex SteepestPixel(const ImageView& depth, int x0, int x1, int y0, int y1);

// F and B of the vertex at the steepest pixel n.
struct VertexPixels {
  PixelIndex front, back;
};
VertexPixels VertexPixelsAround(const ImageView& depth, PixelIndex n);

// A coordinate of vertex `index` of `count` along an axis of `size` pixels: on the border for the
// first and the last.
inline float Anchored(float at, int index, int count, int size) {
  if (index == 0) return -0.5f;
  return index == count - 1 ? static_cast<float>(size) - 0.5f : at;
}

// Writes the vertex of column and row, whose tile has the steepest pixel n, to the grid.
void PlaceVertex(const GenerationJob& job, const VertexGrid& grid, int column, int row,
                 PixelIndex n);

// Rows of pixels that the vertices of a row reach, once all are placed.
void CloseVertexRow(const VertexGrid& grid, int row);

// The three vertices of a triangle; `source` is 2 * (index of the quad's upper left vertex) + (1
// for the lower right triangle).
struct MeshTriangle {
  MeshVertex a, b, c;

  MeshTriangle(const VertexGrid& grid, std::uint32_t source);
  bool IsDrawn() const;
  Triangle Around(Vector q) const { return {a.at - q, b.at - q, c.at - q}; }
  // The place of frame 1 that is shown where the weights are.
  Vector Shown(const Triangle::Weights& w) const {
    return {(w.a * a.shows.x + w.b * b.shows.x + w.c * c.shows.x) / w.area,
            (w.a * a.shows.y + w.b * b.shows.y + w.c * c.shows.y) / w.area};
  }
  RowRange Rows(RowRange target) const;
  ColumnRange Columns(int y, int width) const { return ColumnsOf(a.at, b.at, c.at, y, width); }
};

// Places the vertices of the tiles that begin at row y, if any do, by search(job, x0, x1, y0, y1),
// a SteepestPixel; returns the rows that quads between them and the next vertices may reach.
template <class Search>
RowRange PlaceVertices(const GenerationJob& job, int y, const MutableMotionView& buffer,
                       const Search& search) {
  const VertexGrid grid(job, buffer);
  const int tile = grid.tile(), first_row = y / tile;
  if (y % tile != 0) return {0, 0};
  // A frame of one tile has vertices at both borders all the same.
  const bool is_alone = job.height() <= tile;
  for (int row = first_row; row <= first_row + (is_alone ? 1 : 0); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const int x = job.width() <= tile ? 0 : column * tile;
      const PixelIndex n =
          search(job, x, std::min(x + tile, job.width()), y, std::min(y + tile, job.height()));
      PlaceVertex(job, grid, column, row, n);
    }
    CloseVertexRow(grid, row);
  }
  return {0, first_row + 1 < grid.rows() ? job.height() : 0};
}

// Draws the quads below the vertices of the tiles that begin at row y into `target`, by
// draw(job, triangle, source, rows, keys), which draws those rows of the triangle.
template <class Draw>
void DrawQuads(const GenerationJob& job, const MotionView& buffer, int y, RowRange target,
               const KeyView& keys, const Draw& draw) {
  const VertexGrid grid(job, buffer);
  const int row = y / grid.tile();
  const float top = std::min(grid.Row(row)[0], grid.Row(row + 1)[0]);
  const float bottom = std::max(grid.Row(row)[1], grid.Row(row + 1)[1]);
  if (!(top < static_cast<float>(target.last) && bottom >= static_cast<float>(target.first))) {
    return;
  }
  for (int column = 0; column + 1 < grid.columns(); ++column) {
    for (const std::uint32_t lower : {0u, 1u}) {
      const std::uint32_t source = 2 * grid.Index(column, row) + lower;
      const MeshTriangle triangle(grid, source);
      if (!triangle.IsDrawn()) continue;
      draw(job, triangle, source, triangle.Rows(target), keys);
    }
  }
}

void DrawTriangleRows(const GenerationJob& job, const MeshTriangle& triangle, std::uint32_t source,
                      RowRange rows, const KeyView& keys);

// The motion from frame 1 to the generated frame's pixel (x, y). Nothing drawn: the pixel of frame
// 1 at the same place, moved back.
TargetMotion ProjectedMotionAt(const GenerationJob& job, const VertexGrid& grid,
                               const KeyView& keys, int x, int y);

// Leads motion of columns [first, last) whose source moves on its own to the pixel that is shown in
// its place.
void AvoidMoving(const GenerationJob& job, int y, int first, int last,
                 const MutableMotionView& from1);

}  // namespace warplut::peers
