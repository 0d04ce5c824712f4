// The vector kernels of the first two passes.
#if defined(WARPLUT_RUNTIME_GENERATION_SPLAT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_GENERATION_SPLAT_INL_H_
#undef WARPLUT_RUNTIME_GENERATION_SPLAT_INL_H_
#else
#define WARPLUT_RUNTIME_GENERATION_SPLAT_INL_H_
#endif

#include "runtime/generation/motion/geometry-inl.h"
#include "runtime/generation/motion/motion_model.h"
#include "runtime/generation/motion/perspective-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::generation {
namespace HWY_NAMESPACE {

// What frame 0 has where the pixels of a row were.
struct alignas(64) Frame0Pixels {
  alignas(64) float motion_x[kPixels];
  alignas(64) float motion_y[kPixels];
  alignas(64) float depth[kPixels];
  alignas(64) float inside[kPixels];  // 1, or 0 where the pixel lies outside of frame 0
};

// InterpolatedDisplacement or ExtrapolatedDisplacement.
struct DisplacementFactors {
  float first, second;
  bool interpolates;

  explicit DisplacementFactors(const GenerationJob& job)
      : first(0.5f * job.alpha),
        second(0.5f * job.alpha * job.alpha),
        interpolates(job.Interpolates()) {}

  HWY_INLINE Floats At(Floats m1, Floats m0) const {
    const FloatTag d;
    const auto bend = hn::Mul(hn::Set(d, second), hn::Sub(m1, m0));
    const auto f = hn::Set(d, first);
    if (interpolates) return hn::Sub(hn::Add(hn::Mul(f, hn::Add(m1, m0)), bend), m1);
    return hn::Add(hn::Mul(f, hn::Sub(hn::Mul(hn::Set(d, 3.0f), m1), m0)), bend);
  }
};

inline RowRange ForwardRow(const GenerationJob& job, int y, const MutableMotionView& forward) {
  const FloatTag d;
  const DisplacementFactors factors(job);
  const float fy = static_cast<float>(y);
  alignas(64) float padded_motion[2 * kPixels], padded_depth[kPixels], displaced[2 * kPixels];
  Frame0Pixels frame0;
  auto least = hn::Zero(d);
  auto most = hn::Zero(d);
  const auto store = [&](int i, FloatMask moves, Floats dx, Floats dy) HWY_ATTR {
    const auto nan = hn::Set(d, std::numeric_limits<float>::quiet_NaN());
    hn::StoreInterleaved2(hn::IfThenElse(moves, dx, nan), hn::IfThenElse(moves, dy, nan), d,
                          displaced + 2 * i);
    const auto row = hn::IfThenElseZero(moves, dy);
    least = hn::Min(least, row);
    most = hn::Max(most, row);
  };
  for (int x0 = 0; x0 < job.width(); x0 += kPixels) {
    const int count = std::min(kPixels, job.width() - x0);
    const float* motion =
        Padded(job.motion1.Row(y) + 2 * x0, 2 * count, 2 * kPixels, padded_motion);
    const float* depth = Padded(job.depth1.Row<float>(y) + x0, count, kPixels, padded_depth);
    const bool perspective = job.FollowsPerspective();
    if (job.CountsMotion0() && !perspective) {
      for (int i = 0; i < kPixels; i += kLanes) {
        Floats mx, my;
        hn::LoadInterleaved2(d, motion + 2 * i, mx, my);
        const auto p0 = FindNearest(job, PixelNumbers(x0 + i), fy, hn::Neg(mx), hn::Neg(my));
        const TwoRuns runs(p0.x, p0.y, job.width());
        GatherPixels(job.motion0, p0.x, p0.y, runs, frame0.motion_x + i, frame0.motion_y + i);
        GatherPixels(job.depth0, p0.x, p0.y, runs, frame0.depth + i);
        hn::Store(hn::IfThenElseZero(p0.inside, hn::Set(d, 1.0f)), d, frame0.inside + i);
      }
    }
    for (int i = 0; i < kPixels; i += kLanes) {
      Floats mx, my;
      hn::LoadInterleaved2(d, motion + 2 * i, mx, my);
      auto m0x = mx, m0y = my;
      auto moves = hn::And(IsFiniteVector(mx), IsFiniteVector(my));
      Floats dx, dy;
      if (perspective) {
        PerspectiveDisplacements(job, x0 + i, fy, mx, my, hn::LoadU(d, depth + i), dx, dy, moves);
        store(i, moves, dx, dy);
        continue;
      }
      if (job.CountsMotion0()) {
        const auto gx = hn::Load(d, frame0.motion_x + i);
        const auto gy = hn::Load(d, frame0.motion_y + i);
        const auto was_inside = hn::Gt(hn::Load(d, frame0.inside + i), hn::Zero(d));
        const auto counts = hn::And(was_inside, hn::And(IsFiniteVector(gx), IsFiniteVector(gy)));
        const auto difference =
            DepthDifferences(DepthOf(job.options), CleanDepths(hn::Load(d, frame0.depth + i)),
                             CleanDepths(hn::LoadU(d, depth + i)));
        const auto gate = Gates(hn::Abs(difference), job.depth_threshold(), job.options.gate_width);
        m0x = hn::IfThenElse(counts, hn::Add(mx, hn::Mul(gate, hn::Sub(gx, mx))), mx);
        m0y = hn::IfThenElse(counts, hn::Add(my, hn::Mul(gate, hn::Sub(gy, my))), my);
      }
      store(i, moves, factors.At(mx, m0x), factors.At(my, m0y));
    }
    std::memcpy(forward.Row(y) + 2 * x0, displaced,
                sizeof(float) * 2 * static_cast<std::size_t>(count));
  }
  const auto nearest = [&](float displacement) {
    const float row = std::floor(fy + displacement + 0.5f);
    return static_cast<int>(std::clamp(row, 0.0f, static_cast<float>(job.height())));
  };
  return {nearest(hn::GetLane(hn::MinOfLanes(d, least))),
          std::min(nearest(hn::GetLane(hn::MaxOfLanes(d, most))) + 1, job.height())};
}

// Makes those keys of kLanes that `arrives` marks the lesser of themselves and those of sources
// that follow each other.
HWY_INLINE void KeepNearest(FloatMask arrives, Floats depth, std::uint32_t first_source,
                            SplatKey* keys) {
  const hn::RebindToUnsigned<FloatTag> du;
  auto* halves = reinterpret_cast<std::uint32_t*>(keys);
  hn::Vec<decltype(du)> kept_source, kept_depth;
  hn::LoadInterleaved2(du, halves, kept_source, kept_depth);
  const auto bits = hn::BitCast(du, depth);
  const auto source = hn::BitCast(du, Numbers(static_cast<int>(first_source)));
  const auto less = hn::Or(hn::Lt(bits, kept_depth),
                           hn::And(hn::Eq(bits, kept_depth), hn::Lt(source, kept_source)));
  const auto nearer = hn::And(hn::RebindMask(du, arrives), less);
  hn::StoreInterleaved2(hn::IfThenElse(nearer, source, kept_source),
                        hn::IfThenElse(nearer, bits, kept_depth), du, halves);
}

inline void SplatRow(const GenerationJob& job, const MotionView& forward, int y, RowRange target,
                     const KeyView& keys) {
  const FloatTag d;
  const IntTag di;
  const float fy = static_cast<float>(y);
  alignas(64) float padded_motion[2 * kLanes], padded_depth[kLanes], depths[kLanes];
  alignas(64) std::int32_t px[kLanes], py[kLanes];
  for (int x = 0; x < job.width(); x += kLanes) {
    const int count = std::min(kLanes, job.width() - x);
    const float* motion = Padded(forward.Row(y) + 2 * x, 2 * count, 2 * kLanes, padded_motion);
    const float* depth = Padded(job.depth1.Row<float>(y) + x, count, kLanes, padded_depth);
    Floats dx, dy;
    hn::LoadInterleaved2(d, motion, dx, dy);
    const auto q = FindNearest(job, PixelNumbers(x), fy, dx, dy);
    const auto kept = hn::And(
        hn::RebindMask(di, q.inside),
        hn::And(hn::Gt(q.y, hn::Set(di, target.first - 1)), hn::Lt(q.y, hn::Set(di, target.last))));
    if (hn::AllFalse(di, kept)) continue;
    const auto clean = CleanDepths(hn::LoadU(d, depth));
    const auto source = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(job.width()) +
                        static_cast<std::uint32_t>(x);
    const TwoRuns runs(q.x, q.y, job.width());
    if (count == kLanes && hn::AllTrue(di, kept) && runs.found) {
      KeepNearest(runs.first, clean, source, keys.Row(runs.y0) + runs.x0);
      if (!hn::AllTrue(d, runs.first)) {
        KeepNearest(hn::Not(runs.first), clean, source, keys.Row(runs.y1) + runs.x1);
      }
      continue;
    }
    hn::Store(q.x, di, px);
    hn::Store(hn::IfThenElse(kept, q.y, hn::Set(di, -1)), di, py);
    hn::Store(clean, d, depths);
    for (int i = 0; i < count; ++i) {
      if (py[i] < 0) continue;
      SplatKey& key = keys.Row(py[i])[px[i]];
      key = std::min(key, MakeSplatKey(depths[i], source + static_cast<std::uint32_t>(i)));
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::generation
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
