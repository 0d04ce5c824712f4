// The search for sources in both frames, per target.
#if defined(WARPLUT_RUNTIME_PEERS_BIDIRECTIONAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_PEERS_BIDIRECTIONAL_INL_H_
#undef WARPLUT_RUNTIME_PEERS_BIDIRECTIONAL_INL_H_
#else
#define WARPLUT_RUNTIME_PEERS_BIDIRECTIONAL_INL_H_
#endif

#include "runtime/generation/motion/geometry-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::peers {
namespace HWY_NAMESPACE {

using namespace generation::HWY_NAMESPACE;

// Reprojection of kLanes pixels.
struct Reprojections {
  Floats x, y, miss;

  HWY_INLINE void Take(FloatMask where, const Reprojections& other) {
    x = hn::IfThenElse(where, other.x, x);
    y = hn::IfThenElse(where, other.y, y);
    miss = hn::IfThenElse(where, other.miss, miss);
  }
};

// Pixels x to x + kLanes of row y of the generated frame.
class Reprojector {
 public:
  HWY_INLINE Reprojector(const GenerationJob& job, int x, int y)
      : job_(job), columns_(PixelNumbers(x)), row_(static_cast<float>(y)), x_(x), y_(y) {}

  // Reproject.
  HWY_INLINE Reprojections Find(const MovingFrame& frame, const MovingFrame& other) const {
    const FloatTag d;
    const auto zero = hn::Zero(d);
    Reprojections first = Iterate(frame, zero, zero);
    const auto misses =
        hn::Not(hn::Le(first.miss, hn::Set(d, job_.options.parameters.bidir_tolerance)));
    if (hn::AllFalse(d, misses)) return first;
    Floats mx, my;
    hn::LoadInterleaved2(d, other.motion.Row(y_) + 2 * x_, mx, my);
    const auto moves = hn::And(IsFiniteVector(mx), IsFiniteVector(my));
    const auto share = hn::Set(d, frame.share);
    const Reprojections second = Iterate(frame, hn::IfThenElseZero(moves, hn::Mul(share, mx)),
                                         hn::IfThenElseZero(moves, hn::Mul(share, my)));
    first.Take(hn::And(misses, hn::Lt(second.miss, first.miss)), second);
    return first;
  }

  // The pixels at the sources.
  HWY_INLINE NearestPixels Pixels(const Reprojections& to) const {
    return FindNearest(job_, columns_, row_, hn::Neg(to.x), hn::Neg(to.y));
  }

 private:
  HWY_INLINE Reprojections Iterate(const MovingFrame& frame, Floats start_x, Floats start_y) const {
    const FloatTag d;
    const auto share = hn::Set(d, frame.share);
    Reprojections found{start_x, start_y, hn::Inf(d)};
    auto last_x = start_x, last_y = start_y;
    auto going = hn::Eq(start_x, start_x);  // all: starts are finite
    for (int i = 0; i <= kIterations; ++i) {
      const NearestPixels p = Pixels(found);
      alignas(64) float mx[kLanes], my[kLanes];
      GatherPixels(frame.motion, p.x, p.y, TwoRuns(p.x, p.y, job_.width()), mx, my);
      const auto x = hn::Load(d, mx), y = hn::Load(d, my);
      going = hn::And(hn::And(going, p.inside), hn::And(IsFiniteVector(x), IsFiniteVector(y)));
      last_x = hn::Mul(share, x);
      last_y = hn::Mul(share, y);
      if (i == kIterations) break;
      found.x = hn::IfThenElse(going, last_x, found.x);
      found.y = hn::IfThenElse(going, last_y, found.y);
    }
    const auto miss = hn::Max(hn::Abs(hn::Sub(last_x, found.x)), hn::Abs(hn::Sub(last_y, found.y)));
    return {hn::IfThenElseZero(going, found.x), hn::IfThenElseZero(going, found.y),
            hn::IfThenElse(going, miss, hn::Inf(d))};
  }

  const GenerationJob& job_;
  Floats columns_;
  float row_;
  int x_, y_;
};

// Which of two sources that count is the nearer to the camera, where they are not alike in depth.
HWY_INLINE void HideFarther(const GenerationJob& job, const NearestPixels& p0,
                            const NearestPixels& p1, FloatMask compared, FloatMask& takes0,
                            FloatMask& takes1) {
  const FloatTag d;
  const DepthTolerance tolerance(job);
  alignas(64) float depth0[kLanes], depth1[kLanes];
  GatherPixels(job.depth0, p0.x, p0.y, TwoRuns(p0.x, p0.y, job.width()), depth0);
  GatherPixels(job.depth1, p1.x, p1.y, TwoRuns(p1.x, p1.y, job.width()), depth1);
  const auto z0 = CleanDepths(hn::Load(d, depth0)), z1 = CleanDepths(hn::Load(d, depth1));
  const auto lesser = hn::Max(hn::Min(z0, z1), hn::Set(d, 1e-12f));
  const auto slack =
      hn::Add(hn::Set(d, tolerance.absolute), hn::Mul(hn::Set(d, tolerance.relative), lesser));
  const auto unlike = hn::And(compared, hn::Gt(hn::Abs(hn::Sub(z0, z1)), slack));
  const auto nearer0 = hn::Lt(z0, z1);
  takes0 = hn::Or(hn::AndNot(unlike, takes0), hn::And(unlike, nearer0));
  takes1 = hn::Or(hn::AndNot(unlike, takes1), hn::AndNot(nearer0, unlike));
}

inline void BidirectionalRow(const GenerationJob& job, int y, const MutableMotionView& from0,
                             const MutableMotionView& from1) {
  const FloatTag d;
  const bool both = job.CountsMotion0();
  const auto tolerance = hn::Set(d, job.options.parameters.bidir_tolerance);
  const auto outside = hn::Set(d, kOutside);
  int x = 0;
  for (; x + kLanes <= job.width(); x += kLanes) {
    const Reprojector reprojector(job, x, y);
    const Reprojections to1 = reprojector.Find(Frame1(job), both ? Frame0(job) : Frame1(job));
    const auto share = hn::Set(d, BackwardShare(job.alpha));
    Reprojections to0{hn::Mul(share, to1.x), hn::Mul(share, to1.y), to1.miss};
    if (both) to0 = reprojector.Find(Frame0(job), Frame1(job));
    const auto counts0 = hn::Le(to0.miss, tolerance), counts1 = hn::Le(to1.miss, tolerance);
    auto takes0 = hn::Or(counts0, hn::AndNot(counts1, hn::Le(to0.miss, to1.miss)));
    auto takes1 = hn::Or(counts1, hn::AndNot(counts0, hn::Le(to1.miss, to0.miss)));
    if (both) {
      const NearestPixels p0 = reprojector.Pixels(to0), p1 = reprojector.Pixels(to1);
      const auto compared = hn::And(hn::And(counts0, counts1), hn::And(p0.inside, p1.inside));
      HideFarther(job, p0, p1, compared, takes0, takes1);
    }
    hn::StoreInterleaved2(hn::IfThenElse(takes0, to0.x, outside),
                          hn::IfThenElse(takes0, to0.y, outside), d, from0.Row(y) + 2 * x);
    hn::StoreInterleaved2(hn::IfThenElse(takes1, to1.x, outside),
                          hn::IfThenElse(takes1, to1.y, outside), d, from1.Row(y) + 2 * x);
  }
  for (; x < job.width(); ++x) {
    const TargetMotion motion = BidirectionalMotionAt(job, x, y);
    SetMotion(from0, x, y, motion.from0);
    SetMotion(from1, x, y, motion.from1);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::peers
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
