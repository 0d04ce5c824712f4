// runtime/peers/sr/lanczos_samples.h on vectors, per target.
#if defined(WARPLUT_RUNTIME_PEERS_LANCZOS_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_PEERS_LANCZOS_SAMPLES_INL_H_
#undef WARPLUT_RUNTIME_PEERS_LANCZOS_SAMPLES_INL_H_
#else
#define WARPLUT_RUNTIME_PEERS_LANCZOS_SAMPLES_INL_H_
#endif

#include "runtime/peers/sr/neighbourhood-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

HWY_INLINE Floats MotionLengths(const SrJob& job, int x, int y) {
  const FloatTag d;
  if (!job.HasHistory()) return hn::Zero(d);
  const Columns nearest(job.x.nearest(), x);
  const int j = job.y.nearest()[y];
  const auto mx = hn::Mul(nearest.At(job.planes.motion_x.Row(j)), hn::Set(d, job.x.scale()));
  const auto my = hn::Mul(nearest.At(job.planes.motion_y.Row(j)), hn::Set(d, job.y.scale()));
  const auto length = hn::Sqrt(hn::MulAdd(mx, mx, hn::Mul(my, my)));
  const auto largest = hn::Set(d, std::numeric_limits<float>::max());
  return hn::IfThenElseZero(hn::Le(length, largest), length);
}

// `length` in units of `whole`, limited to [0, 1].
HWY_INLINE Floats ShareOf(Floats length, float whole) {
  return Limit(hn::Mul(length, hn::Set(FloatTag(), 1.0f / whole)));
}

HWY_INLINE Floats HistoryWeights(Floats validity, Floats weight, Floats length) {
  const FloatTag d;
  const auto towards = [](Floats from, Floats to, Floats t)
                           HWY_ATTR { return hn::Min(from, Mix(from, to, t)); };
  const auto base =
      towards(validity, hn::Mul(hn::Set(d, kMovingSamples), weight), ShareOf(length, kStillMotion));
  return towards(base, weight, ShareOf(length, kBoxMotion));
}

// The weights of the samples around kLanes pixels: Kernel()(d^2) of the colour; of the box a
// product of one factor for each axis.
template <class Kernel>
class LanczosWeights {
 public:
  HWY_INLINE LanczosWeights(const SrJob& job, const Kernel& kernel, int x, int y)
      : kernel_(kernel), length_(MotionLengths(job, x, y)) {
    const FloatTag d;
    const auto curve = hn::MulAdd(hn::Set(d, kMovingCurve - kStillCurve),
                                  ShareOf(length_, kCurveMotion), hn::Set(d, kStillCurve));
    const auto offset = hn::LoadU(d, job.x.offset() + x);
    for (int i = -1; i <= 1; ++i) {
      const auto dx = hn::Sub(offset, hn::Set(d, static_cast<float>(i)));
      const float dy = job.y.offset()[y] - static_cast<float>(i);
      columns_[i + 1] = hn::Exp(d, hn::Mul(curve, hn::Mul(dx, dx)));
      rows_[i + 1] = hn::Exp(d, hn::Mul(curve, hn::Set(d, dy * dy)));
    }
  }

  HWY_INLINE SampleWeightVectors operator()(int di, int dj, Floats dx, Floats dy) const {
    return {kernel_(hn::MulAdd(dx, dx, hn::Mul(dy, dy))), hn::Mul(columns_[di + 1], rows_[dj + 1])};
  }
  HWY_INLINE Floats length() const { return length_; }

 private:
  Kernel kernel_;
  Floats length_;
  Floats columns_[3], rows_[3];
};

// The colour of the samples within their range and `slack` around, and its weight; 0 where there is
// none.
HWY_INLINE Floats UpsampledColor(const Neighbourhoods& n, float slack, float scale, Colors& color) {
  const FloatTag d;
  const auto counts = hn::Gt(n.weight, hn::Set(d, kLeastWeight));
  const auto inverse =
      hn::Div(hn::Set(d, 1.0f), hn::IfThenElse(counts, n.weight, hn::Set(d, 1.0f)));
  for (int c = 0; c < 3; ++c) {
    color.c[c] = Clamp(hn::Mul(n.color.c[c], inverse), hn::Sub(n.low.c[c], hn::Set(d, slack)),
                       hn::Add(n.high.c[c], hn::Set(d, slack)));
  }
  return hn::IfThenElseZero(counts, hn::Mul(n.weight, hn::Set(d, scale)));
}

// Where the history leaves the range [low, high] in some channel.
HWY_INLINE hn::Mask<FloatTag> LeavesRange(const Floats (&history)[3], const Colors& low,
                                          const Colors& high) {
  const FloatTag d;
  const auto slack = hn::Set(d, kRangeSlack);
  auto leaves = hn::Gt(hn::Sub(low.c[0], history[0]), slack);
  for (int c = 0; c < 3; ++c) {
    leaves = hn::Or(leaves, hn::Or(hn::Gt(hn::Sub(low.c[c], history[c]), slack),
                                   hn::Gt(hn::Sub(history[c], high.c[c]), slack)));
  }
  return leaves;
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
