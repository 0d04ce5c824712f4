// Vertices, drawing and reading of projected meshes, per target.
#if defined(WARPLUT_RUNTIME_PEERS_MESH_PROJECTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_PEERS_MESH_PROJECTION_INL_H_
#undef WARPLUT_RUNTIME_PEERS_MESH_PROJECTION_INL_H_
#else
#define WARPLUT_RUNTIME_PEERS_MESH_PROJECTION_INL_H_
#endif

#include "runtime/peers/generation/mesh_projection.h"
#include "runtime/peers/generation/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

// InverseOf.
HWY_INLINE Floats InverseDepths(Floats depth) {
  const FloatTag d;
  const auto inverse = hn::Div(hn::Set(d, 1.0f), hn::Max(depth, hn::Set(d, kLeastDepth)));
  return hn::IfThenElseZero(hn::Lt(depth, hn::Set(d, kFarthestDepth)), inverse);
}

// SteepestPixel.
inline PixelIndex SteepestOf(const GenerationJob& job, int x0, int x1, int y0, int y1) {
  const FloatTag d;
  const IntTag di;
  const int chunks = (x1 - x0 + kLanes - 1) / kLanes;
  if (x0 + chunks * kLanes + 1 > job.width()) return SteepestPixel(job.depth1, x0, x1, y0, y1);
  PixelIndex steepest{x0, y0};
  float most = 0;
  for (int x = x0; x < x1; x += kLanes) {
    const auto inverse = [&](int column, int row) HWY_ATTR {
      return InverseDepths(CleanDepths(hn::LoadU(d, job.depth1.Row<float>(row) + column)));
    };
    const auto counted = hn::FirstN(d, static_cast<std::size_t>(x1 - x));
    auto best = hn::Zero(d);
    auto best_row = hn::Zero(di);
    auto here = inverse(x, y0);
    for (int y = y0; y < y1; ++y) {
      const auto below = inverse(x, std::min(y + 1, job.height() - 1));
      const auto right = hn::Sub(inverse(x + 1, y), here), down = hn::Sub(below, here);
      const auto gradient = hn::Add(hn::Mul(right, right), hn::Mul(down, down));
      const auto better = hn::And(counted, hn::Gt(gradient, best));
      best = hn::IfThenElse(better, gradient, best);
      best_row = hn::IfThenElse(hn::RebindMask(di, better), hn::Set(di, y), best_row);
      here = below;
    }
    if (hn::AllFalse(d, hn::And(hn::Gt(best, hn::Zero(d)), hn::Ge(best, hn::Set(d, most))))) {
      continue;
    }
    alignas(64) float values[kLanes];
    alignas(64) std::int32_t rows[kLanes];
    hn::Store(best, d, values);
    hn::Store(best_row, di, rows);
    for (int i = 0; i < kLanes; ++i) {
      const bool first = values[i] == most && rows[i] < steepest.y;
      if (!(values[i] > most || (most > 0 && first))) continue;
      most = values[i];
      steepest = {x + i, rows[i]};
    }
  }
  return steepest;
}

// PointMap::Apply.
struct MappedPoints {
  Floats x, y, w;

  HWY_INLINE MappedPoints(const PointMap& map, Floats px, Floats py, Floats g) {
    const FloatTag d;
    const auto row = [&](std::size_t r) HWY_ATTR {
      const float* m = map.m.data() + 4 * r;
      const auto plane = hn::Add(hn::Mul(hn::Set(d, m[0]), px), hn::Mul(hn::Set(d, m[1]), py));
      return hn::Add(plane, hn::Add(hn::Set(d, m[2]), hn::Mul(hn::Set(d, m[3]), g)));
    };
    w = row(2);
    x = hn::Div(row(0), w);
    y = hn::Div(row(1), w);
  }
};

// Depth and motion of frame 1 at pixels of any order.
class SourcePixels {
 public:
  explicit SourcePixels(const GenerationJob& job)
      : job_(job),
        depths_(job.depth1.Row<float>(0)),
        depth_stride_(static_cast<std::int32_t>(job.depth1.stride / 4)),
        motions_(job.motion1.Row(0)),
        motion_stride_(static_cast<std::int32_t>(job.motion1.stride / 4)) {}

  // Whether vectors have as many lanes as a row has pixels, and indices fit 31 bits.
  static bool AreGathered(const GenerationJob& job) {
    const auto fits = [&](std::ptrdiff_t stride) {
      return std::abs(std::int64_t{stride}) / 4 * job.height() <= kMostGathered * 2;
    };
    return job.width() >= kLanes && fits(job.depth1.stride) && fits(job.motion1.stride);
  }

  // PixelAt.
  struct Pixels {
    Ints x, y;
  };
  HWY_INLINE Pixels At(VectorPair p) const {
    const FloatTag d;
    const IntTag di;
    const auto along = [&](Floats v, int size) HWY_ATTR {
      const auto pixel = hn::Floor(hn::Add(v, hn::Set(d, 0.5f)));
      const auto end = hn::Set(d, static_cast<float>(size - 1));
      return hn::ConvertTo(di, hn::Min(hn::Max(pixel, hn::Zero(d)), end));
    };
    return {along(p.x, job_.width()), along(p.y, job_.height())};
  }
  HWY_INLINE Floats Depth(const Pixels& n) const {
    const IntTag di;
    const auto index = hn::Add(hn::Mul(n.y, hn::Set(di, depth_stride_)), n.x);
    return CleanDepths(hn::GatherIndex(FloatTag(), depths_, index));
  }
  HWY_INLINE VectorPair Motion(const Pixels& n) const {
    const FloatTag d;
    const IntTag di;
    const auto index = hn::Add(hn::Mul(n.y, hn::Set(di, motion_stride_)), hn::ShiftLeft<1>(n.x));
    return {hn::GatherIndex(d, motions_, index), hn::GatherIndex(d, motions_ + 1, index)};
  }

 private:
  const GenerationJob& job_;
  const float* depths_;
  std::int32_t depth_stride_;
  const float* motions_;
  std::int32_t motion_stride_;
};

// CarryAt.
struct CarriedPoints {
  VectorPair at;
  Floats depth;
  FloatMask shown;

  HWY_INLINE CarriedPoints(const GenerationJob& job, const SourcePixels& source, VectorPair p,
                           const SourcePixels::Pixels& n, Floats source_depth) {
    const FloatTag d;
    if (job.carrier == nullptr) {
      const auto share = hn::Set(d, job.Interpolates() ? job.alpha - 1 : job.alpha);
      const VectorPair m = source.Motion(n);
      at = {hn::Add(p.x, hn::Mul(share, m.x)), hn::Add(p.y, hn::Mul(share, m.y))};
      depth = source_depth;
      shown = hn::And(IsFiniteVector(at.x), IsFiniteVector(at.y));
      return;
    }
    const MappedPoints mapped(job.carrier->forward, p.x, p.y, InverseDepths(source_depth));
    at = {mapped.x, mapped.y};
    const auto farthest = hn::Set(d, kFarthestDepth);
    const auto moved = hn::IfThenElse(hn::Lt(source_depth, farthest),
                                      hn::Mul(source_depth, mapped.w), source_depth);
    depth = hn::Min(moved, farthest);
    shown =
        hn::And(hn::Gt(mapped.w, hn::Zero(d)), hn::And(IsFiniteVector(at.x), IsFiniteVector(at.y)));
  }
};

// DrawTriangleRows. A triangle that is no wider than a vector takes the columns of its box.
inline void DrawTriangles(const GenerationJob& job, const MeshTriangle& triangle,
                          std::uint32_t source, RowRange rows, const KeyView& keys) {
  if (!SourcePixels::AreGathered(job)) {
    DrawTriangleRows(job, triangle, source, rows, keys);
    return;
  }
  const FloatTag d;
  const UnsignedTag du;
  const SourcePixels pixels(job);
  const auto zero = hn::Zero(d);
  const auto set = [&](Vector v) HWY_ATTR { return VectorPair{hn::Set(d, v.x), hn::Set(d, v.y)}; };
  const VectorPair a = set(triangle.a.at), b = set(triangle.b.at), c = set(triangle.c.at);
  const VectorPair sa = set(triangle.a.shows), sb = set(triangle.b.shows);
  const VectorPair sc = set(triangle.c.shows);
  const auto [left, right] = std::minmax({triangle.a.at.x, triangle.b.at.x, triangle.c.at.x});
  const auto end = static_cast<float>(job.width() - 1);
  if (left > end || right < 0) return;
  const ColumnRange box = {static_cast<int>(std::max(std::ceil(left), 0.0f)),
                           static_cast<int>(std::min(std::floor(right), end))};
  const bool narrow = box.last - box.first < kLanes;
  for (int y = rows.first; y < rows.last; ++y) {
    const ColumnRange columns = narrow ? box : triangle.Columns(y, job.width());
    const auto qy = hn::Set(d, static_cast<float>(y));
    for (int first = columns.first; first <= columns.last; first += kLanes) {
      const int x = std::min(first, job.width() - kLanes);
      const auto qx = PixelNumbers(x);
      const auto around = [&](const VectorPair& v) HWY_ATTR {
        return VectorPair{hn::Sub(v.x, qx), hn::Sub(v.y, qy)};
      };
      const TriangleWeights weights(around(a), around(b), around(c));
      if (hn::AllFalse(d, weights.inside)) continue;
      const VectorPair u = {hn::IfThenElse(weights.inside, weights.Of(sa.x, sb.x, sc.x), zero),
                            hn::IfThenElse(weights.inside, weights.Of(sa.y, sb.y, sc.y), zero)};
      const auto n = pixels.At(u);
      const CarriedPoints carried(job, pixels, u, n, pixels.Depth(n));
      const auto kept = hn::And(weights.inside, carried.shown);
      if (hn::AllFalse(d, kept)) continue;
      KeepRow(kept, x, y, hn::BitCast(du, hn::Add(carried.depth, zero)), hn::Set(du, source), keys);
    }
  }
}

// CarriedBack of kLanes pixels that are at u.
HWY_INLINE VectorPair CarryBack(const GenerationJob& job, VectorPair q, VectorPair u,
                                const CarriedPoints& carried) {
  const FloatTag d;
  VectorPair v;
  auto inside = hn::Eq(q.x, q.x);
  if (job.carrier != nullptr) {
    const MappedPoints p(job.carrier->backward, q.x, q.y, InverseDepths(carried.depth));
    v = {p.x, p.y};
    inside = hn::Gt(p.w, hn::Zero(d));
  } else {
    v = {hn::Sub(q.x, hn::Sub(carried.at.x, u.x)), hn::Sub(q.y, hn::Sub(carried.at.y, u.y))};
  }
  const auto least = hn::Set(d, -0.5f);
  const auto right = hn::Set(d, static_cast<float>(job.width()) - 0.5f);
  const auto bottom = hn::Set(d, static_cast<float>(job.height()) - 0.5f);
  inside = hn::And(inside, hn::And(hn::And(hn::Ge(v.x, least), hn::Le(v.x, right)),
                                   hn::And(hn::Ge(v.y, least), hn::Le(v.y, bottom))));
  return {hn::IfThenElse(inside, v.x, u.x), hn::IfThenElse(inside, v.y, u.y)};
}

// ProjectedMotionAt of kLanes pixels, all of which a triangle covers.
HWY_INLINE VectorPair ProjectedMotion(const GenerationJob& job, const VertexGrid& grid,
                                      Unsigned source, int x, int y) {
  const FloatTag d;
  const IntTag di;
  const VectorPair q = {PixelNumbers(x), hn::Set(d, static_cast<float>(y))};
  const auto quad = hn::BitCast(di, hn::ShiftRight<1>(source));
  const auto lower = hn::BitCast(di, hn::And(source, hn::Set(UnsignedTag(), 1u)));
  const auto upper = hn::Sub(hn::Set(di, 1), lower);
  const auto stride = hn::Set(di, grid.stride());
  VectorPair shows[3];
  const auto corner = [&](Ints right, Ints down, VectorPair& shown) HWY_ATTR {
    const auto index = hn::ShiftLeft<2>(hn::Add(quad, hn::Add(right, hn::Mul(down, stride))));
    const float* floats = grid.floats();
    shown = {hn::GatherIndex(d, floats + 2, index), hn::GatherIndex(d, floats + 3, index)};
    return VectorPair{hn::Sub(hn::GatherIndex(d, floats, index), q.x),
                      hn::Sub(hn::GatherIndex(d, floats + 1, index), q.y)};
  };
  const VectorPair a = corner(lower, lower, shows[0]);
  const VectorPair b = corner(upper, lower, shows[1]);
  const VectorPair c = corner(lower, upper, shows[2]);
  const TriangleWeights weights(a, b, c);
  VectorPair u = {weights.Of(shows[0].x, shows[1].x, shows[2].x),
                  weights.Of(shows[0].y, shows[1].y, shows[2].y)};
  const SourcePixels pixels(job);
  const auto n = pixels.At(u);
  const auto depth = pixels.Depth(n);
  const VectorPair v = CarryBack(job, q, u, CarriedPoints(job, pixels, u, n, depth));
  const auto distance = hn::Max(hn::Abs(hn::Sub(v.x, u.x)), hn::Abs(hn::Sub(v.y, u.y)));
  const auto far = hn::Gt(distance, hn::Set(d, job.options.parameters.mesh_shear));
  if (!hn::AllFalse(d, far)) {
    const DepthTolerance tolerance(job);
    const auto there = pixels.Depth(pixels.At(v));
    const auto least = hn::Max(hn::Min(depth, there), hn::Set(d, 1e-12f));
    const auto slack =
        hn::Add(hn::Set(d, tolerance.absolute), hn::Mul(hn::Set(d, tolerance.relative), least));
    const auto corrected = hn::And(far, hn::Le(hn::Abs(hn::Sub(depth, there)), slack));
    u = {hn::IfThenElse(corrected, v.x, u.x), hn::IfThenElse(corrected, v.y, u.y)};
  }
  return {hn::Sub(q.x, u.x), hn::Sub(q.y, u.y)};
}

// AvoidMoving of a row.
inline void AvoidMovingRow(const GenerationJob& job, int y, const MutableMotionView& from1) {
  const FloatTag d;
  const IntTag di;
  const SourcePixels pixels(job);
  int x = 0;
  for (; SourcePixels::AreGathered(job) && x + kLanes <= job.width(); x += kLanes) {
    Floats mx, my;
    hn::LoadInterleaved2(d, from1.Row(y) + 2 * x, mx, my);
    const auto n =
        pixels.At({hn::Sub(PixelNumbers(x), mx), hn::Sub(hn::Set(d, static_cast<float>(y)), my)});
    const auto index = hn::Add(hn::Mul(n.y, hn::Set(di, job.width())), n.x);
    const auto shown = hn::GatherIndex(di, job.still_column, index);
    if (!hn::AllTrue(di, hn::Eq(shown, n.x))) AvoidMoving(job, y, x, x + kLanes, from1);
  }
  AvoidMoving(job, y, x, job.width(), from1);
}

inline RowRange PlaceVertexRow(const GenerationJob& job, int y, const MutableMotionView& buffer) {
  return PlaceVertices(job, y, buffer, SteepestOf);
}

inline void DrawQuadRow(const GenerationJob& job, const MotionView& buffer, int y, RowRange target,
                        const KeyView& keys) {
  DrawQuads(job, buffer, y, target, keys, DrawTriangles);
}

inline void ProjectedMotionRow(const GenerationJob& job, const Arrivals& arrivals, int y,
                               const MutableMotionView& from0, const MutableMotionView& from1,
                               std::uint8_t* disoccluded) {
  const FloatTag d;
  const UnsignedTag du;
  const VertexGrid grid(job, arrivals.forward);
  const SplatKey* keys = arrivals.keys.Row(y);
  const auto one_by_one = [&](int x) {
    const TargetMotion motion = ProjectedMotionAt(job, grid, arrivals.keys, x, y);
    StoreMotion(job, motion, x, y, from0, from1, disoccluded);
  };
  const bool gathers = SourcePixels::AreGathered(job);
  int x = 0;
  for (; gathers && x + kLanes <= job.width(); x += kLanes) {
    Unsigned source, high;
    hn::LoadInterleaved2(du, reinterpret_cast<const std::uint32_t*>(keys + x), source, high);
    if (!hn::AllFalse(du, hn::Eq(high, hn::Set(du, 0xFFFFFFFFu)))) {
      for (int i = 0; i < kLanes; ++i) one_by_one(x + i);
      continue;
    }
    const VectorPair motion = ProjectedMotion(job, grid, source, x, y);
    hn::StoreInterleaved2(motion.x, motion.y, d, from1.Row(y) + 2 * x);
    const auto outside = hn::Set(d, kOutside);
    if (job.Interpolates()) hn::StoreInterleaved2(outside, outside, d, from0.Row(y) + 2 * x);
  }
  for (; x < job.width(); ++x) one_by_one(x);
  if (job.still_column != nullptr) AvoidMovingRow(job, y, from1);
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
