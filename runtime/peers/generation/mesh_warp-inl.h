// Drawing and reading of the mesh, per target.
#if defined(WARPLUT_RUNTIME_PEERS_MESH_WARP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_PEERS_MESH_WARP_INL_H_
#undef WARPLUT_RUNTIME_PEERS_MESH_WARP_INL_H_
#else
#define WARPLUT_RUNTIME_PEERS_MESH_WARP_INL_H_
#endif

#include "runtime/generation/motion/target_motion-inl.h"
#include "runtime/peers/generation/mesh_warp.h"
#include "runtime/peers/generation/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

using namespace generation::HWY_NAMESPACE;

// Vertices (x, y) to (x + kLanes - 1, y), moved.
struct VertexRow {
  Floats x, y, z;

  HWY_INLINE VertexRow(const GenerationJob& job, const MotionView& forward, int vx, int vy) {
    const FloatTag d;
    Floats dx, dy;
    hn::LoadInterleaved2(d, forward.Row(vy) + 2 * vx, dx, dy);
    x = hn::Add(PixelNumbers(vx), dx);
    y = hn::Add(hn::Set(d, static_cast<float>(vy)), dy);
    z = CleanDepths(hn::LoadU(d, job.depth1.Row<float>(vy) + vx));
  }
};

// Draws the quads (x, y) to (x + kLanes - 1, y), all inside; false where one covers more than 2 x 2
// pixel centres: then nothing is drawn.
HWY_INLINE bool DrawQuads(const GenerationJob& job, const MotionView& forward,
                          const DepthTolerance& tolerance, int x, int y, RowRange target,
                          const KeyView& keys) {
  const FloatTag d;
  const IntTag di;
  const UnsignedTag du;
  const VertexRow v00(job, forward, x, y), v10(job, forward, x + 1, y);
  const VertexRow v01(job, forward, x, y + 1), v11(job, forward, x + 1, y + 1);
  const auto least = [](Floats a, Floats b, Floats c, Floats e)
                         HWY_ATTR { return hn::Min(hn::Min(a, b), hn::Min(c, e)); };
  const auto most = [](Floats a, Floats b, Floats c, Floats e)
                        HWY_ATTR { return hn::Max(hn::Max(a, b), hn::Max(c, e)); };
  // Any lane that is not finite makes the sum so.
  const auto sums = hn::Add(hn::Add(hn::Add(v00.x, v10.x), hn::Add(v01.x, v11.x)),
                            hn::Add(hn::Add(v00.y, v10.y), hn::Add(v01.y, v11.y)));
  if (!hn::AllTrue(d, IsFiniteVector(sums))) return false;
  const auto left = least(v00.x, v10.x, v01.x, v11.x), top = least(v00.y, v10.y, v01.y, v11.y);
  const auto first_x = hn::Ceil(left), first_y = hn::Ceil(top);
  const auto last_x = most(v00.x, v10.x, v01.x, v11.x);
  const auto last_y = most(v00.y, v10.y, v01.y, v11.y);
  const auto two = hn::Set(d, 2.0f);
  const auto wide =
      hn::Or(hn::Ge(last_x, hn::Add(first_x, two)), hn::Ge(last_y, hn::Add(first_y, two)));
  if (!hn::AllFalse(d, wide)) return false;

  const auto nearest = least(v00.z, v10.z, v01.z, v11.z);
  const auto farthest = most(v00.z, v10.z, v01.z, v11.z);
  const auto slack =
      hn::Add(hn::Set(d, tolerance.absolute),
              hn::Mul(hn::Set(d, tolerance.relative), hn::Max(nearest, hn::Set(d, 1e-12f))));
  const auto extent = hn::Max(hn::Sub(last_x, left), hn::Sub(last_y, top));
  const auto stretched = hn::And(hn::Gt(extent, hn::Set(d, kLeastStretch)),
                                 hn::Gt(hn::Abs(hn::Sub(nearest, farthest)), slack));
  const auto stretched_bit =
      hn::IfThenElseZero(hn::RebindMask(du, stretched), hn::Set(du, 0x80000000u));
  const auto quad = hn::BitCast(du, Numbers(y * job.width() + x));
  const auto low_y = hn::Set(d, static_cast<float>(target.first));
  const auto end_y = hn::Set(d, static_cast<float>(target.last));
  const auto width = hn::Set(d, static_cast<float>(job.width()));
  const auto zero = hn::Zero(d);
  for (int oy = 0; oy < 2; ++oy) {
    const auto qy = hn::Add(first_y, hn::Set(d, static_cast<float>(oy)));
    const auto row = hn::And(hn::Le(qy, last_y), hn::And(hn::Ge(qy, low_y), hn::Lt(qy, end_y)));
    if (hn::AllFalse(d, row)) continue;
    for (int ox = 0; ox < 2; ++ox) {
      const auto qx = hn::Add(first_x, hn::Set(d, static_cast<float>(ox)));
      const auto here =
          hn::And(row, hn::And(hn::Le(qx, last_x), hn::And(hn::Ge(qx, zero), hn::Lt(qx, width))));
      if (hn::AllFalse(d, here)) continue;
      const auto around = [&](const VertexRow& v) HWY_ATTR {
        return VectorPair{hn::Sub(v.x, qx), hn::Sub(v.y, qy)};
      };
      const VectorPair p00 = around(v00), p10 = around(v10), p01 = around(v01), p11 = around(v11);
      const auto px = hn::ConvertTo(di, hn::IfThenElseZero(here, qx));
      const auto py = hn::ConvertTo(di, hn::IfThenElseZero(here, qy));
      for (int lower = 0; lower < 2; ++lower) {
        const TriangleWeights weights =
            lower == 0 ? TriangleWeights(p00, p10, p01) : TriangleWeights(p11, p01, p10);
        const auto kept = hn::And(here, weights.inside);
        if (hn::AllFalse(d, kept)) continue;
        const auto mean =
            lower == 0 ? weights.Of(v00.z, v10.z, v01.z) : weights.Of(v11.z, v01.z, v10.z);
        const auto depth = hn::Min(hn::Max(mean, nearest), farthest);
        const auto high = hn::Or(hn::BitCast(du, hn::Add(depth, zero)), stretched_bit);
        const auto low =
            hn::Add(hn::ShiftLeft<1>(quad), hn::Set(du, static_cast<std::uint32_t>(lower)));
        Keep(kept, px, py, high, low, keys);
      }
    }
  }
  return true;
}

inline void DrawRow(const GenerationJob& job, const MotionView& forward, int y, RowRange target,
                    const KeyView& keys) {
  if (y + 1 >= job.height()) return;
  const DepthTolerance tolerance(job);
  const int quads = job.width() - 1;
  int x = 0;
  for (; x + kLanes <= quads; x += kLanes) {
    if (DrawQuads(job, forward, tolerance, x, y, target, keys)) continue;
    for (int i = 0; i < kLanes; ++i) DrawQuad(job, forward, tolerance, x + i, y, target, keys);
  }
  for (; x < quads; ++x) DrawQuad(job, forward, tolerance, x, y, target, keys);
}

// MeshMotionAt of kLanes pixels whose keys are triangles that are not stretched.
HWY_INLINE VectorPair ConnectedMotion(const GenerationJob& job, const Arrivals& arrivals,
                                      Unsigned source, int x, int y) {
  const FloatTag d;
  const IntTag di;
  const auto width = hn::Set(di, job.width());
  const auto lower = hn::BitCast(di, hn::And(source, hn::Set(UnsignedTag(), 1u)));
  const auto quad = hn::BitCast(di, hn::ShiftRight<1>(source));
  // The row by a quotient that may be off by one.
  auto row = hn::ConvertTo(
      di, hn::Mul(hn::ConvertTo(d, quad), hn::Set(d, 1.0f / static_cast<float>(job.width()))));
  auto column = hn::Sub(quad, hn::Mul(row, width));
  const auto before = hn::Lt(column, hn::Zero(di));
  row = hn::IfThenElse(before, hn::Sub(row, hn::Set(di, 1)), row);
  column = hn::IfThenElse(before, hn::Add(column, width), column);
  const auto behind = hn::Not(hn::Lt(column, width));
  row = hn::IfThenElse(behind, hn::Add(row, hn::Set(di, 1)), row);
  column = hn::IfThenElse(behind, hn::Sub(column, width), column);

  const float* displacements = arrivals.forward.xy;
  const auto left = hn::Sub(hn::ConvertTo(d, column), PixelNumbers(x));
  const auto top = hn::Sub(hn::ConvertTo(d, row), hn::Set(d, static_cast<float>(y)));
  const auto one = hn::Set(d, 1.0f);
  // Corner (right, down) of each quad: its displacement, and its place around the pixel.
  const auto corner = [&](Ints right, Ints down, VectorPair& displacement) HWY_ATTR {
    const auto index = hn::ShiftLeft<1>(hn::Add(quad, hn::Add(right, hn::Mul(down, width))));
    displacement.x = hn::GatherIndex(d, displacements, index);
    displacement.y = hn::GatherIndex(d, displacements + 1, index);
    const auto vx =
        hn::IfThenElse(hn::RebindMask(d, hn::Gt(right, hn::Zero(di))), hn::Add(left, one), left);
    const auto vy =
        hn::IfThenElse(hn::RebindMask(d, hn::Gt(down, hn::Zero(di))), hn::Add(top, one), top);
    return VectorPair{hn::Add(vx, displacement.x), hn::Add(vy, displacement.y)};
  };
  const auto upper = hn::Sub(hn::Set(di, 1), lower);
  VectorPair da, db, dc;
  const VectorPair a = corner(lower, lower, da);
  const VectorPair b = corner(upper, lower, db);
  const VectorPair c = corner(lower, upper, dc);
  const TriangleWeights weights(a, b, c);
  return {weights.Of(da.x, db.x, dc.x), weights.Of(da.y, db.y, dc.y)};
}

inline void MeshMotionRow(const GenerationJob& job, const Arrivals& arrivals, int y,
                          const MutableMotionView& from0, const MutableMotionView& from1,
                          std::uint8_t* disoccluded) {
  const FloatTag d;
  const UnsignedTag du;
  const SplatKey* keys = arrivals.keys.Row(y);
  const bool gathers = std::int64_t{job.width()} * job.height() <= kMostGathered;
  const auto outside = hn::Set(d, kOutside);
  const auto one_by_one = [&](int x) {
    const TargetMotion motion = MeshMotionAt(job, arrivals, x, y);
    StoreMotion(job, motion, x, y, from0, from1, disoccluded);
  };
  int x = 0;
  for (; gathers && x + kLanes <= job.width(); x += kLanes) {
    Unsigned source, high;
    hn::LoadInterleaved2(du, reinterpret_cast<const std::uint32_t*>(keys + x), source, high);
    const auto others = hn::Gt(high, hn::Set(du, 0x7FFFFFFFu));
    if (!hn::AllFalse(du, others)) {
      for (int i = 0; i < kLanes; ++i) one_by_one(x + i);
      continue;
    }
    const VectorPair motion = ConnectedMotion(job, arrivals, source, x, y);
    hn::StoreInterleaved2(motion.x, motion.y, d, from1.Row(y) + 2 * x);
    if (!job.Interpolates()) continue;
    const auto p1 = FindNearest(job, PixelNumbers(x), static_cast<float>(y), hn::Neg(motion.x),
                                hn::Neg(motion.y));
    const auto share = hn::Set(d, BackwardShare(job.alpha));
    hn::StoreInterleaved2(hn::IfThenElse(p1.inside, outside, hn::Mul(share, motion.x)),
                          hn::IfThenElse(p1.inside, outside, hn::Mul(share, motion.y)), d,
                          from0.Row(y) + 2 * x);
  }
  for (; x < job.width(); ++x) one_by_one(x);
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
