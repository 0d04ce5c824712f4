#include "runtime/peers/rays/screen_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/peers/generation/mesh_projection.h"

namespace warplut::peers {
namespace {

constexpr int kGreatestTile = 64;

// Where the ray goes behind a triangle; a negative number if it does not.
double CrossingOf(const ScreenRay& ray, const ScreenMesh::Triangle3& corners) {
  const auto& [a, b, c] = corners;
  const double bx = b.x - a.x, by = b.y - a.y, bg = b.g - a.g;
  const double cx = c.x - a.x, cy = c.y - a.y, cg = c.g - a.g;
  const double area = bx * cy - by * cx;
  if (area == 0) return -1;
  // The inverse depth of the plane is a.g + gx (x - a.x) + gy (y - a.y).
  const double gx = (bg * cy - by * cg) / area, gy = (bx * cg - bg * cx) / area;
  const double ahead = ray.from.g - a.g - gx * (ray.from.x - a.x) - gy * (ray.from.y - a.y);
  const double approach = gx * ray.by.x + gy * ray.by.y - ray.by.g;
  if (!(approach > 0)) return -1;
  const double t = ahead / approach;
  if (!(t >= ray.begin && t <= ray.end)) return -1;
  const ScreenRay::Point p = ray.At(t);
  const auto around = [&](const ScreenRay::Point& corner) {
    return Vector{static_cast<float>(corner.x - p.x), static_cast<float>(corner.y - p.y)};
  };
  return Triangle{around(a), around(b), around(c)}.At().inside ? t : -1;
}

}  // namespace

bool ScreenMeshOptions::IsValid(std::string* why) const {
  std::string fault;
  if (tile < VertexGrid::kLeastTile || tile > kGreatestTile) {
    fault = "The tile is " + std::to_string(tile) + "; expected " +
            std::to_string(VertexGrid::kLeastTile) + " to " + std::to_string(kGreatestTile) +
            " pixels.";
  } else if (!(tear > 0 && std::isfinite(tear))) {
    fault = "The tear is " + std::to_string(tear) + "; expected a finite number above 0.";
  }
  if (why != nullptr && !fault.empty()) *why = fault;
  return fault.empty();
}

ScreenMesh::ScreenMesh(const ImageView& depth, const ScreenMeshOptions& options)
    : depth_(depth),
      options_(options),
      columns_(VertexGrid::Count(depth.width, options.tile)),
      rows_(VertexGrid::Count(depth.height, options.tile)),
      tile_columns_((depth.width + options.tile - 1) / options.tile),
      tile_rows_((depth.height + options.tile - 1) / options.tile) {
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      vertices_.push_back(PlaceVertex(column, row));
    }
  }
  tiles_.resize(static_cast<std::size_t>(tile_columns_) * static_cast<std::size_t>(tile_rows_),
                {std::numeric_limits<float>::infinity(), 0, {}});
  for (int row = 0; row + 1 < rows_; ++row) {
    for (int column = 0; column + 1 < columns_; ++column) {
      const Quad quad = MakeQuad(column, row);
      for (int y = quad.top; y <= quad.bottom; ++y) {
        for (int x = quad.left; x <= quad.right; ++x) {
          Tile& tile = tiles_[static_cast<std::size_t>(y) * tile_columns_ + x];
          for (const std::array<float, 3>& inverse : quad.inverse) {
            const auto [least, greatest] = std::minmax({inverse[0], inverse[1], inverse[2]});
            tile.least = std::min(tile.least, least);
            tile.greatest = std::max(tile.greatest, greatest);
          }
          tile.quads.push_back(static_cast<std::uint32_t>(quads_.size()));
        }
      }
      quads_.push_back(quad);
    }
  }
}

ScreenMesh::Vertex ScreenMesh::PlaceVertex(int column, int row) const {
  const auto begins = [&](int index, int size) {
    return size <= options_.tile ? 0 : index * options_.tile;
  };
  const int x0 = begins(column, depth_.width), y0 = begins(row, depth_.height);
  const PixelIndex n = SteepestPixel(depth_, x0, std::min(x0 + options_.tile, depth_.width), y0,
                                     std::min(y0 + options_.tile, depth_.height));
  auto [front, back] = VertexPixelsAround(depth_, n);
  const float x = Anchored(static_cast<float>(front.x), column, columns_, depth_.width);
  const float y = Anchored(static_cast<float>(front.y), row, rows_, depth_.height);
  // An anchored vertex shows another pixel, and has its depth.
  const auto pixel = [](float at, int size) {
    return std::clamp(static_cast<int>(at), 0, size - 1);
  };
  const PixelIndex shown{pixel(x + 0.5f, depth_.width), pixel(y + 0.5f, depth_.height)};
  if (shown.x != front.x || shown.y != front.y) front = back = shown;
  const float near = InverseOf(DepthAt(depth_, front.x, front.y));
  const float far = InverseOf(DepthAt(depth_, back.x, back.y));
  const bool is_torn = near > far * (1 + options_.tear);
  return {x + 0.5f, y + 0.5f, near, is_torn ? far : near};
}

ScreenMesh::Quad ScreenMesh::MakeQuad(int column, int row) const {
  Quad quad{};
  float left = vertices_[row * columns_ + column].x, right = left;
  float top = vertices_[row * columns_ + column].y, bottom = top;
  for (const bool lower : {false, true}) {
    const TriangleCorners corners = CornersOf(lower);
    std::array<const Vertex*, 3> at{};
    for (std::size_t i = 0; i < 3; ++i) {
      const PixelIndex corner = i == 0 ? corners.a : i == 1 ? corners.b : corners.c;
      at[i] = &vertices_[(row + corner.y) * columns_ + column + corner.x];
      left = std::min(left, at[i]->x);
      right = std::max(right, at[i]->x);
      top = std::min(top, at[i]->y);
      bottom = std::max(bottom, at[i]->y);
    }
    float narrowest = std::numeric_limits<float>::infinity();
    for (const unsigned backs : {0u, 1u, 2u, 4u, 3u, 5u, 6u, 7u}) {
      const auto inverse = [&](unsigned i) {
        return (backs >> i & 1) != 0 ? at[i]->back : at[i]->front;
      };
      const auto [least, greatest] = std::minmax({inverse(0), inverse(1), inverse(2)});
      if (!(greatest - least < narrowest)) continue;
      narrowest = greatest - least;
      quad.inverse[lower] = {inverse(0), inverse(1), inverse(2)};
    }
  }
  const auto tile = [&](float position, int count) {
    return std::min(static_cast<int>(position) / options_.tile, count - 1);
  };
  quad.left = tile(left, tile_columns_);
  quad.right = tile(right, tile_columns_);
  quad.top = tile(top, tile_rows_);
  quad.bottom = tile(bottom, tile_rows_);
  return quad;
}

ScreenMesh::Triangle3 ScreenMesh::TriangleAt(int i) const {
  const int quad = i / 2, column = quad % (columns_ - 1), row = quad / (columns_ - 1);
  const std::array<float, 3>& inverse = quads_[quad].inverse[i % 2];
  const TriangleCorners corners = CornersOf(i % 2 == 1);
  const auto point = [&](PixelIndex corner, float g) {
    const Vertex& vertex = vertices_[(row + corner.y) * columns_ + column + corner.x];
    return ScreenRay::Point{vertex.x, vertex.y, g};
  };
  return {point(corners.a, inverse[0]), point(corners.b, inverse[1]), point(corners.c, inverse[2])};
}

void ScreenMesh::TestQuad(const ScreenRay& ray, double thickness, std::uint32_t quad,
                          ScreenHit& hit) const {
  for (const int lower : {0, 1}) {
    ++hit.triangles;
    const double t = CrossingOf(ray, TriangleAt(static_cast<int>(2 * quad) + lower));
    if (t < 0 || (hit.is_hit && t >= hit.t)) continue;
    const ScreenRay::Point p = ray.At(t);
    const auto pixel = [](double at, int size) {
      return std::clamp(static_cast<int>(at), 0, size - 1);
    };
    const double own =
        InverseOf(DepthAt(depth_, pixel(p.x, depth_.width), pixel(p.y, depth_.height)));
    const auto [farther, nearer] = std::minmax({own, p.g});
    if (farther > 0 && nearer <= farther * (1 + thickness)) hit.Take(ray, t);
  }
}

ScreenHit ScreenMesh::Trace(const ScreenRay& ray, double thickness) const {
  ScreenHit hit;
  if (ray.IsEmpty()) return hit;
  // The tile whose triangles were tested last.
  int last_x = -1, last_y = -1;
  for (CellWalk walk(ray, depth_.width, depth_.height); !walk.IsDone(); walk.Leave(options_.tile)) {
    ++hit.cells;
    const int x = walk.x() / options_.tile, y = walk.y() / options_.tile;
    const Tile& tile = tiles_[static_cast<std::size_t>(y) * tile_columns_ + x];
    const double leaves = walk.Leaves(options_.tile);
    const auto [least, greatest] = std::minmax({ray.InverseAt(walk.t()), ray.InverseAt(leaves)});
    if (least <= tile.greatest && greatest >= tile.least) {
      for (const std::uint32_t i : tile.quads) {
        const Quad& quad = quads_[i];
        const bool is_tested = quad.left <= last_x && last_x <= quad.right && quad.top <= last_y &&
                               last_y <= quad.bottom;
        if (!is_tested) TestQuad(ray, thickness, i, hit);
      }
      last_x = x;
      last_y = y;
    }
    if (hit.is_hit && hit.t <= leaves) break;
  }
  return hit;
}

ScreenHit ScreenMesh::TraceReference(const ScreenRay& ray, double thickness) const {
  ScreenHit hit;
  if (ray.IsEmpty()) return hit;
  for (std::uint32_t quad = 0; quad < quads_.size(); ++quad) TestQuad(ray, thickness, quad, hit);
  return hit;
}

}  // namespace warplut::peers
