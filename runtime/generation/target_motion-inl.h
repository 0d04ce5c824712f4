// The vector kernel of the third pass: which pixels are neither gaps nor disocclusions is found by vectors, the others go
// one by one.
#if defined(WARPLUT_RUNTIME_GENERATION_TARGET_MOTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_GENERATION_TARGET_MOTION_INL_H_
#undef WARPLUT_RUNTIME_GENERATION_TARGET_MOTION_INL_H_
#else
#define WARPLUT_RUNTIME_GENERATION_TARGET_MOTION_INL_H_
#endif

#include "runtime/generation/geometry-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::generation {
namespace HWY_NAMESPACE {

// SplatDepth of kLanes keys.
HWY_INLINE Floats SplatDepths(const SplatKey* keys) {
  const FloatTag d;
  const hn::RebindToUnsigned<FloatTag> du;
  hn::Vec<decltype(du)> low, high;
  hn::LoadInterleaved2(du, reinterpret_cast<const std::uint32_t*>(keys), low, high);
  const auto depth = hn::BitCast(d, high);
  return hn::IfThenElse(hn::Eq(depth, depth), depth, hn::Set(d, kNoArrivalDepth));
}

// Marks pixels [x, x + kLanes) of row y, all inside and not on the left or right border, that need TargetMotionAt.
HWY_INLINE FloatMask NeedSearch(const GenerationJob& job, const KeyView& keys,
                                const DepthTolerance& tolerance, int x, int y) {
  const FloatTag d;
  const auto center = SplatDepths(keys.Row(y) + x);
  const auto none = hn::Set(d, kNoArrivalDepth);
  if (!job.options.refine) return hn::Eq(center, none);
  const SplatKey* rows[3] = {keys.Row(std::max(y - 1, 0)) + x, keys.Row(y) + x,
                             keys.Row(std::min(y + 1, job.height() - 1)) + x};
  const auto absolute = hn::Set(d, tolerance.absolute);
  const auto relative = hn::Set(d, tolerance.relative);
  const auto alike = [&](int j, int i) HWY_ATTR {
    const auto depth = SplatDepths(rows[j] + i - 1);
    const auto lesser = hn::Max(hn::Min(center, depth), hn::Set(d, 1e-12f));
    return hn::Le(hn::Abs(hn::Sub(center, depth)), hn::Add(absolute, hn::Mul(relative, lesser)));
  };
  // Seldom is a pixel alike to none but those below: the first blocks answer for most vectors.
  const auto arrived = hn::Ne(center, none);
  const auto above = alike(0, 1), left = alike(1, 0);
  const auto above_left = hn::And(arrived, hn::And(hn::And(above, left), alike(0, 0)));
  if (hn::AllTrue(d, above_left)) return hn::Not(above_left);
  const auto below = alike(2, 1), right = alike(1, 2);
  const auto others = hn::Or(hn::And(hn::And(above, right), alike(0, 2)),
                             hn::Or(hn::And(hn::And(below, left), alike(2, 0)),
                                    hn::And(hn::And(below, right), alike(2, 2))));
  return hn::Not(hn::Or(above_left, hn::And(arrived, others)));
}

// Reads the displacements and the motion of the pixels that arrived, whose rows change seldom.
class SourceReader {
 public:
  SourceReader(const GenerationJob& job, const Arrivals& arrivals)
      : motion_(job.motion1),
        forward_(arrivals.forward.xy),
        width_(static_cast<std::uint32_t>(job.width())),
        motion_row_(job.motion1.xy) {}

  HWY_INLINE void Read(SplatKey key, float* HWY_RESTRICT displacement, float* HWY_RESTRICT motion) {
    const std::uint32_t source = SplatSource(key);
    std::memcpy(displacement, forward_ + 2 * std::size_t{source}, 2 * sizeof(float));
    FindRow(source);
    std::memcpy(motion, motion_row_ + 2 * std::size_t{source - row_start_}, 2 * sizeof(float));
  }

  // The same for kLanes keys whose pixels arrived.
  HWY_INLINE void ReadAll(const SplatKey* keys, float* HWY_RESTRICT displacement,
                          float* HWY_RESTRICT motion) {
    const hn::RebindToUnsigned<FloatTag> du;
    hn::Vec<decltype(du)> sources, depths;
    hn::LoadInterleaved2(du, reinterpret_cast<const std::uint32_t*>(keys), sources, depths);
    const std::uint32_t first = SplatSource(keys[0]);
    FindRow(first);
    const bool one_row = first - row_start_ + kLanes <= width_;
    if (one_row && hn::AllTrue(du, hn::Eq(sources, hn::Iota(du, first)))) {
      std::memcpy(displacement, forward_ + 2 * std::size_t{first}, 2 * kLanes * sizeof(float));
      std::memcpy(motion, motion_row_ + 2 * std::size_t{first - row_start_},
                  2 * kLanes * sizeof(float));
      return;
    }
    for (int i = 0; i < kLanes; ++i) Read(keys[i], displacement + 2 * i, motion + 2 * i);
  }

 private:
  HWY_INLINE void FindRow(std::uint32_t source) {
    if (source - row_start_ < width_) return;
    const std::uint32_t y = source / width_;
    row_start_ = y * width_;
    motion_row_ = motion_.Row(static_cast<int>(y));
  }

  MotionView motion_;
  const float* forward_;
  std::uint32_t width_;
  const float* motion_row_;
  std::uint32_t row_start_ = 0;
};

void TargetMotionRow(const GenerationJob& job, const Arrivals& arrivals, int y,
                     const MutableMotionView& from0, const MutableMotionView& from1) {
  const FloatTag d;
  const DepthTolerance tolerance(job);
  const SplatKey* keys = arrivals.keys.Row(y);
  SourceReader reader(job, arrivals);
  float* to0 = from0.Row(y);
  float* to1 = from1.Row(y);
  const auto search = [&](int x) {
    const TargetMotion motion = TargetMotionAt(job, arrivals, x, y);
    if (job.interpolates) SetMotion(from0, x, y, motion.from0);
    SetMotion(from1, x, y, motion.from1);
  };
  int x = 0;
  search(x++);
  for (; x + kLanes < job.width(); x += kLanes) {
    const auto marks = NeedSearch(job, arrivals.keys, tolerance, x, y);
    if (!hn::AllFalse(d, marks)) {
      std::uint8_t marked[hn::MaxLanes(d) / 8 + 1] = {};
      hn::StoreMaskBits(d, marks, marked);
      for (int i = 0; i < kLanes; ++i) {
        if ((marked[i / 8] >> (i % 8) & 1) != 0) {
          search(x + i);
          continue;
        }
        alignas(16) float displacement[2], motion[2];
        reader.Read(keys[x + i], displacement, motion);
        SetMotion(from1, x + i, y, {displacement[0], displacement[1]});
        if (!job.interpolates) continue;
        SetMotion(from0, x + i, y, {displacement[0] + motion[0], displacement[1] + motion[1]});
      }
      continue;
    }
    alignas(64) float displacement[2 * kLanes], motion[2 * kLanes];
    reader.ReadAll(keys + x, displacement, motion);
    for (int i = 0; i < 2 * kLanes; i += kLanes) {
      const auto forward = hn::Load(d, displacement + i);
      hn::StoreU(forward, d, to1 + 2 * x + i);
      if (job.interpolates) {
        hn::StoreU(hn::Add(forward, hn::Load(d, motion + i)), d, to0 + 2 * x + i);
      }
    }
  }
  for (; x < job.width(); ++x) search(x);
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::generation
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
