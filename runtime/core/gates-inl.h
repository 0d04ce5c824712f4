// The gates of runtime/gates.h on vectors, per target: the same formulas in the same order.
#if defined(WARPLUT_RUNTIME_GATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_GATES_INL_H_
#undef WARPLUT_RUNTIME_GATES_INL_H_
#else
#define WARPLUT_RUNTIME_GATES_INL_H_
#endif

#include "runtime/core/warp_simd-inl.h"
#include "runtime/gates.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

// Gate.
HWY_INLINE Floats Gates(Floats x, float threshold, float width) {
  const FloatTag d;
  const auto one = hn::Set(d, 1.0f);
  const float half = threshold * width;
  if (!(half > 0.0f)) return hn::IfThenElseZero(hn::Le(x, hn::Set(d, threshold)), one);
  const auto share = hn::Div(hn::Sub(hn::Set(d, threshold + half), x), hn::Set(d, half + half));
  return hn::IfThenElseZero(hn::Gt(share, hn::Zero(d)), hn::Min(share, one));
}

// DepthDifference.
HWY_INLINE Floats DepthDifferences(DepthMeasure measure, Floats a, Floats b) {
  const FloatTag d;
  if (measure == DepthMeasure::kNone) return hn::Zero(d);
  const auto difference = hn::Sub(a, b);
  if (measure == DepthMeasure::kAbsolute) return difference;
  return hn::Div(difference, hn::Max(hn::Min(a, b), hn::Set(d, 1e-12f)));
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
