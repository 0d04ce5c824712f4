// The vector kernel of the perspective motion model.
#if defined(WARPLUT_RUNTIME_GENERATION_PERSPECTIVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_GENERATION_PERSPECTIVE_INL_H_
#undef WARPLUT_RUNTIME_GENERATION_PERSPECTIVE_INL_H_
#else
#define WARPLUT_RUNTIME_GENERATION_PERSPECTIVE_INL_H_
#endif

#include "runtime/generation/motion/geometry-inl.h"
#include "runtime/generation/motion/surface_before.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::generation {
namespace HWY_NAMESPACE {

// SurfaceBefore of kLanes pixels.
struct SurfacesBefore {
  Floats motion_x, motion_y, ratio, gate;
};

// The four pixels of frame 0 around kLanes positions.
struct SurfaceTaps {
  Floats weight[4], depth[4], motion_x[4], motion_y[4];
  FloatMask counts[4];  // the motion is finite

  HWY_INLINE SurfaceTaps(const GenerationJob& job, Floats u, Floats v) {
    const FloatTag d;
    const IntTag di;
    const auto left = hn::ConvertTo(di, u), top = hn::ConvertTo(di, v);
    const auto one = hn::Set(d, 1.0f);
    const auto fx = hn::Sub(u, hn::ConvertTo(d, left)), fy = hn::Sub(v, hn::ConvertTo(d, top));
    const auto gx = hn::Sub(one, fx), gy = hn::Sub(one, fy);
    weight[0] = hn::Mul(gx, gy);
    weight[1] = hn::Mul(fx, gy);
    weight[2] = hn::Mul(gx, fy);
    weight[3] = hn::Mul(fx, fy);
    const auto next = [&](Ints i, int size) HWY_ATTR {
      return hn::Min(hn::Add(i, hn::Set(di, 1)), hn::Set(di, size - 1));
    };
    const auto right = next(left, job.width()), bottom = next(top, job.height());
    alignas(64) float mx[kLanes], my[kLanes], depths[kLanes];
    for (int k = 0; k < 4; ++k) {
      const auto x = k % 2 == 0 ? left : right, y = k / 2 == 0 ? top : bottom;
      const TwoRuns runs(x, y, job.width());
      GatherPixels(job.motion0, x, y, runs, mx, my);
      GatherPixels(job.depth0, x, y, runs, depths);
      motion_x[k] = hn::Load(d, mx);
      motion_y[k] = hn::Load(d, my);
      depth[k] = CleanDepths(hn::Load(d, depths));
      counts[k] = hn::And(IsFiniteVector(motion_x[k]), IsFiniteVector(motion_y[k]));
    }
  }
};

// FindSurfaceBefore of pixels [x, x + kLanes) of row y, whose depth is clean; whatever where the
// motion is not finite.
HWY_INLINE SurfacesBefore FindSurfacesBefore(const GenerationJob& job, int x, float y, Floats mx,
                                             Floats my, Floats depth1) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  const auto xs = PixelNumbers(x);
  const auto inside = FindNearest(job, xs, y, hn::Neg(mx), hn::Neg(my)).inside;
  const auto limited = [&](Floats p, int size) HWY_ATTR {
    const auto last = hn::Set(d, static_cast<float>(size - 1));
    return hn::Min(hn::Max(hn::IfThenElseZero(inside, p), zero), last);
  };
  const SurfaceTaps taps(job, limited(hn::Sub(xs, mx), job.width()),
                         limited(hn::Sub(hn::Set(d, y), my), job.height()));
  auto anchor = hn::Set(d, kNoArrivalDepth);
  for (int k = 0; k < 4; ++k) {
    const auto nearer =
        hn::Lt(hn::Abs(hn::Sub(taps.depth[k], depth1)), hn::Abs(hn::Sub(anchor, depth1)));
    const auto is_anchor = hn::And(hn::And(hn::Gt(taps.weight[k], zero), taps.counts[k]), nearer);
    anchor = hn::IfThenElse(is_anchor, taps.depth[k], anchor);
  }
  const auto not_zero = [&](Floats depth)
                            HWY_ATTR { return hn::Max(depth, hn::Set(d, kLeastSurfaceDepth)); };
  auto total = zero, inverse = zero, sum_x = zero, sum_y = zero;
  for (int k = 0; k < 4; ++k) {
    const auto tolerance = hn::Mul(hn::Set(d, kSurfaceTolerance), hn::Min(taps.depth[k], anchor));
    const auto alike =
        hn::And(taps.counts[k], hn::Le(hn::Abs(hn::Sub(taps.depth[k], anchor)), tolerance));
    const auto weight = hn::IfThenElseZero(alike, taps.weight[k]);
    total = hn::Add(total, weight);
    const auto nearness = hn::Div(not_zero(anchor), not_zero(taps.depth[k]));
    inverse = hn::Add(inverse, hn::IfThenElseZero(alike, hn::Mul(weight, nearness)));
    sum_x = hn::Add(sum_x, hn::IfThenElseZero(alike, hn::Mul(weight, taps.motion_x[k])));
    sum_y = hn::Add(sum_y, hn::IfThenElseZero(alike, hn::Mul(weight, taps.motion_y[k])));
  }
  const auto one = hn::Set(d, 1.0f);
  const auto share = hn::Div(one, total);
  const auto depth0 = hn::Min(hn::Mul(hn::Div(total, inverse), anchor), hn::Set(d, kFarthestDepth));
  const auto difference = DepthDifferences(DepthOf(job.options), depth0, depth1);
  const auto gate = Gates(hn::Abs(difference), job.depth_threshold(), job.options.gate_width);
  const auto found = hn::And(inside, hn::And(hn::Gt(total, zero), hn::Gt(gate, zero)));
  const auto ratio = hn::Div(not_zero(depth0), not_zero(depth1));
  return {hn::IfThenElse(found, hn::Mul(share, sum_x), mx),
          hn::IfThenElse(found, hn::Mul(share, sum_y), my), hn::IfThenElse(found, ratio, one),
          hn::IfThenElseZero(found, gate)};
}

// Displacements of pixels [x, x + kLanes) of row y; takes those that pass the camera, or end
// nowhere finite, from `moves`.
HWY_INLINE void PerspectiveDisplacements(const GenerationJob& job, int x, float y, Floats mx,
                                         Floats my, Floats depth1, Floats& dx, Floats& dy,
                                         FloatMask& moves) {
  const FloatTag d;
  const auto before = FindSurfacesBefore(job, x, y, mx, my, CleanDepths(depth1));
  const auto one = hn::Set(d, 1.0f);
  const auto ratio = before.ratio;
  const float time = job.time();
  const auto depth = hn::Add(ratio, hn::Mul(hn::Set(d, time), hn::Sub(one, ratio)));
  moves = hn::And(moves, hn::Ge(depth, hn::Set(d, kLeastDepthRatio)));
  const auto twice = hn::Mul(hn::Set(d, 2.0f), ratio);
  const auto depth_before = hn::Sub(twice, one);
  const auto gate = hn::IfThenElseZero(hn::Gt(depth_before, hn::Zero(d)), before.gate);
  const auto now_weight = hn::Set(d, 1.0f - time * time);
  const auto before_weight = hn::Set(d, 0.5f * time * (time - 1.0f));
  const auto displacement = [&](Floats m1, Floats m0) HWY_ATTR {
    const auto steady = hn::Mul(twice, m1);
    const auto bend = hn::Sub(hn::Mul(depth_before, hn::Add(m1, m0)), steady);
    const auto moved = hn::Add(steady, hn::Mul(gate, bend));
    const auto sum =
        hn::Add(hn::Mul(now_weight, hn::Mul(ratio, m1)), hn::Mul(before_weight, moved));
    return hn::Div(hn::Neg(sum), depth);
  };
  dx = displacement(mx, before.motion_x);
  dy = displacement(my, before.motion_y);
  moves = hn::And(moves, hn::And(IsFiniteVector(dx), IsFiniteVector(dy)));
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::generation
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
