#include <algorithm>
#include <limits>

#include "runtime/peers/generation/mesh_projection.h"

namespace warplut::peers {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

float SquaredGradient(const ImageView& depth, int x, int y) {
  const auto inverse = [&](int i, int j) {
    return InverseOf(DepthAt(depth, std::min(i, depth.width - 1), std::min(j, depth.height - 1)));
  };
  const float here = inverse(x, y);
  const float right = inverse(x + 1, y) - here, down = inverse(x, y + 1) - here;
  return right * right + down * down;
}

// The point that pixel q of the generated frame shows, carried back by the depth that the point at
// u has there; u itself where that does not lead into frame 1.
Vector CarriedBack(const GenerationJob& job, Vector q, Vector u, PixelIndex n) {
  const Carried carried = CarryAt(job, u, n);
  Vector v;
  if (job.carrier != nullptr) {
    const PointMap::Point p = job.carrier->backward.Apply(q.x, q.y, InverseOf(carried.depth));
    if (!(p.w > 0)) return u;
    v = {p.x, p.y};
  } else {
    v = q - (carried.at - u);
  }
  const bool inside = v.x >= -0.5f && v.x <= static_cast<float>(job.width()) - 0.5f &&
                      v.y >= -0.5f && v.y <= static_cast<float>(job.height()) - 0.5f;
  return inside ? v : u;
}

}  // namespace

Carried CarryAt(const GenerationJob& job, Vector p, PixelIndex n) {
  const float depth = DepthAt(job.depth1, n.x, n.y);
  if (job.carrier == nullptr) {
    const float share = job.Interpolates() ? job.alpha - 1 : job.alpha;
    const Vector at = p + share * MotionAt(job.motion1, n.x, n.y);
    return {at, depth, IsFinite(at)};
  }
  const PointMap::Point point = job.carrier->forward.Apply(p.x, p.y, InverseOf(depth));
  const Vector at{point.x, point.y};
  const bool shown = point.w > 0 && IsFinite(at);
  return {at, std::min(depth < kFarthestDepth ? depth * point.w : depth, kFarthestDepth), shown};
}

PixelIndex SteepestPixel(const ImageView& depth, int x0, int x1, int y0, int y1) {
  PixelIndex steepest{x0, y0};
  float most = 0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const float gradient = SquaredGradient(depth, x, y);
      if (!(gradient > most)) continue;
      most = gradient;
      steepest = {x, y};
    }
  }
  return steepest;
}

VertexPixels VertexPixelsAround(const ImageView& depth, PixelIndex n) {
  PixelIndex front = n, back = n;
  for (int y = std::max(n.y - 1, 0); y <= std::min(n.y + 1, depth.height - 1); ++y) {
    for (int x = std::max(n.x - 1, 0); x <= std::min(n.x + 1, depth.width - 1); ++x) {
      const float here = DepthAt(depth, x, y);
      if (here < DepthAt(depth, front.x, front.y)) front = {x, y};
      if (here > DepthAt(depth, back.x, back.y)) back = {x, y};
    }
  }
  return {front, back};
}

void PlaceVertex(const GenerationJob& job, const VertexGrid& grid, int column, int row,
                 PixelIndex n) {
  const auto [front, back] = VertexPixelsAround(job.depth1, n);
  const auto place = [](PixelIndex p) {
    return Vector{static_cast<float>(p.x), static_cast<float>(p.y)};
  };
  const Carried foreground = CarryAt(job, place(front), front);
  const Carried background = CarryAt(job, place(back), back);
  const Vector before = place(front) - place(back), after = foreground.at - background.at;
  const bool keeps_direction = before.x * after.x + before.y * after.y > 0;
  const bool apart =
      background.shown && keeps_direction && Farther(after) > job.options.parameters.mesh_tensile;
  MeshVertex vertex{foreground.shown ? foreground.at : Vector{kNan, kNan},
                    place(apart ? back : front)};
  for (Vector* at : {&vertex.at, &vertex.shows}) {
    at->x = Anchored(at->x, column, grid.columns(), job.width());
    at->y = Anchored(at->y, row, grid.rows(), job.height());
  }
  grid.Set(column, row, vertex);
}

void CloseVertexRow(const VertexGrid& grid, int row) {
  float first = kFarthestVertex, last = -kFarthestVertex;
  for (int column = 0; column < grid.columns(); ++column) {
    const float y = grid.At(grid.Index(column, row)).at.y;
    if (!warplut::IsFinite(y)) continue;
    first = std::min(first, y);
    last = std::max(last, y);
  }
  grid.Row(row)[0] = first;
  grid.Row(row)[1] = last;
}

MeshTriangle::MeshTriangle(const VertexGrid& grid, std::uint32_t source) {
  const TriangleCorners corners = CornersOf(source % 2 == 1);
  const auto vertex = [&](PixelIndex corner) {
    return grid.At(source / 2 + static_cast<std::uint32_t>(corner.y * grid.stride() + corner.x));
  };
  a = vertex(corners.a);
  b = vertex(corners.b);
  c = vertex(corners.c);
}

bool MeshTriangle::IsDrawn() const {
  const auto near = [](Vector v) {
    return std::abs(v.x) <= kFarthestVertex && std::abs(v.y) <= kFarthestVertex;
  };
  return near(a.at) && near(b.at) && near(c.at);
}

RowRange MeshTriangle::Rows(RowRange target) const {
  const auto [top, bottom] = std::minmax({a.at.y, b.at.y, c.at.y});
  const auto low = static_cast<float>(target.first), high = static_cast<float>(target.last);
  return {static_cast<int>(std::clamp(std::ceil(top), low, high)),
          static_cast<int>(std::clamp(std::floor(bottom) + 1, low, high))};
}

void DrawTriangleRows(const GenerationJob& job, const MeshTriangle& triangle, std::uint32_t source,
                      RowRange rows, const KeyView& keys) {
  for (int y = rows.first; y < rows.last; ++y) {
    const ColumnRange columns = triangle.Columns(y, job.width());
    for (int x = columns.first; x <= columns.last; ++x) {
      const Vector q{static_cast<float>(x), static_cast<float>(y)};
      const Triangle::Weights weights = triangle.Around(q).At();
      if (!weights.inside) continue;
      const Vector u = triangle.Shown(weights);
      const Carried carried = CarryAt(job, u, PixelAt(job, u));
      if (!carried.shown) continue;
      SplatKey& kept = keys.Row(y)[x];
      kept = std::min(kept, MakeSplatKey(carried.depth + 0.0f, source));
    }
  }
}

TargetMotion ProjectedMotionAt(const GenerationJob& job, const VertexGrid& grid,
                               const KeyView& keys, int x, int y) {
  const Vector outside{kOutside, kOutside}, q{static_cast<float>(x), static_cast<float>(y)};
  const SplatKey key = keys.Row(y)[x];
  if (key == kNoSplat) {
    const Carried own = CarryAt(job, q, {x, y});
    return {outside, own.shown ? own.at - q : Vector{}, true};
  }
  const MeshTriangle triangle(grid, SplatSource(key));
  Vector u = triangle.Shown(triangle.Around(q).At());
  const PixelIndex n = PixelAt(job, u);
  const Vector v = CarriedBack(job, q, u, n);
  if (Farther(v - u) > job.options.parameters.mesh_shear) {
    const PixelIndex there = PixelAt(job, v);
    const bool alike = DepthTolerance(job).Alike(DepthAt(job.depth1, n.x, n.y),
                                                 DepthAt(job.depth1, there.x, there.y));
    if (alike) u = v;
  }
  return {outside, q - u};
}

void AvoidMoving(const GenerationJob& job, int y, int first, int last,
                 const MutableMotionView& from1) {
  for (int x = first; x < last; ++x) {
    const Vector m = MotionAt(from1, x, y);
    const PixelIndex n = PixelAt(job, {static_cast<float>(x) - m.x, static_cast<float>(y) - m.y});
    const int shown = job.still_column[std::ptrdiff_t{n.y} * job.width() + n.x];
    if (shown != n.x) SetMotion(from1, x, y, {m.x - static_cast<float>(shown - n.x), m.y});
  }
}

}  // namespace warplut::peers
