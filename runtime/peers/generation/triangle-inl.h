// Triangles on vectors, per target.
#if defined(WARPLUT_RUNTIME_PEERS_TRIANGLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_PEERS_TRIANGLE_INL_H_
#undef WARPLUT_RUNTIME_PEERS_TRIANGLE_INL_H_
#else
#define WARPLUT_RUNTIME_PEERS_TRIANGLE_INL_H_
#endif

#include "runtime/generation/motion/geometry-inl.h"
#include "runtime/peers/generation/triangle.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

using namespace generation::HWY_NAMESPACE;
using UnsignedTag = hn::RebindToUnsigned<FloatTag>;
using Unsigned = hn::Vec<UnsignedTag>;

struct VectorPair {
  Floats x, y;
};

// Triangle::At of kLanes triangles.
struct TriangleWeights {
  Floats a, b, c, area;
  FloatMask inside;

  HWY_INLINE TriangleWeights(VectorPair pa, VectorPair pb, VectorPair pc) {
    const FloatTag d;
    const auto zero = hn::Zero(d);
    const auto cross = [](VectorPair u, VectorPair v)
                           HWY_ATTR { return hn::Sub(hn::Mul(u.x, v.y), hn::Mul(u.y, v.x)); };
    a = cross(pb, pc);
    b = cross(pc, pa);
    c = cross(pa, pb);
    area = hn::Add(hn::Add(a, b), c);
    const auto front = hn::And(hn::And(hn::Ge(a, zero), hn::Ge(b, zero)),
                               hn::And(hn::Ge(c, zero), hn::Gt(area, zero)));
    const auto back = hn::And(hn::And(hn::Le(a, zero), hn::Le(b, zero)),
                              hn::And(hn::Le(c, zero), hn::Lt(area, zero)));
    inside = hn::Or(front, back);
  }

  // The weighted mean.
  HWY_INLINE Floats Of(Floats va, Floats vb, Floats vc) const {
    const auto sum = hn::Add(hn::Add(hn::Mul(a, va), hn::Mul(b, vb)), hn::Mul(c, vc));
    return hn::Div(sum, area);
  }
};

// Makes the keys of those of the pixels (x, y) to (x + kLanes - 1, y) that `kept` marks the lesser
// of themselves and (high, low).
HWY_INLINE void KeepRow(FloatMask kept, int x, int y, Unsigned high, Unsigned low,
                        const KeyView& keys) {
  const UnsignedTag du;
  auto* halves = reinterpret_cast<std::uint32_t*>(keys.Row(y) + x);
  Unsigned kept_low, kept_high;
  hn::LoadInterleaved2(du, halves, kept_low, kept_high);
  const auto less =
      hn::Or(hn::Lt(high, kept_high), hn::And(hn::Eq(high, kept_high), hn::Lt(low, kept_low)));
  const auto lesser = hn::And(hn::RebindMask(du, kept), less);
  hn::StoreInterleaved2(hn::IfThenElse(lesser, low, kept_low),
                        hn::IfThenElse(lesser, high, kept_high), du, halves);
}

// Makes the keys of those of kLanes pixels that `kept` marks the lesser of themselves and (high,
// low).
HWY_INLINE void Keep(FloatMask kept, Ints px, Ints py, Unsigned high, Unsigned low,
                     const KeyView& keys) {
  const FloatTag d;
  const IntTag di;
  const UnsignedTag du;
  const auto first = static_cast<int>(hn::FindKnownFirstTrue(d, kept));
  alignas(64) std::int32_t xs[kLanes], ys[kLanes];
  hn::Store(px, di, xs);
  hn::Store(py, di, ys);
  const int base = xs[first] - first;
  const auto follows = hn::And(hn::Eq(hn::Sub(px, hn::Iota(di, 0)), hn::Set(di, base)),
                               hn::Eq(py, hn::Set(di, ys[first])));
  const auto apart = hn::AndNot(hn::RebindMask(d, follows), kept);
  if (hn::AllFalse(d, apart) && base >= 0 && base + kLanes <= keys.width) {
    KeepRow(kept, base, ys[first], high, low, keys);
    return;
  }
  alignas(64) std::uint32_t highs[kLanes], lows[kLanes];
  alignas(64) float marks[kLanes];
  hn::Store(high, du, highs);
  hn::Store(low, du, lows);
  hn::Store(hn::IfThenElseZero(kept, hn::Set(d, 1.0f)), d, marks);
  for (int i = 0; i < kLanes; ++i) {
    if (marks[i] == 0) continue;
    SplatKey& key = keys.Row(ys[i])[xs[i]];
    key = std::min(key, SplatKey{highs[i]} << 32 | lows[i]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
