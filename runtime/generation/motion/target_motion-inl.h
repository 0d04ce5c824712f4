// The vector kernel of the third pass: which pixels are neither gaps nor disocclusions is found by
// vectors, the others go one by one.
#if defined(WARPLUT_RUNTIME_GENERATION_TARGET_MOTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_GENERATION_TARGET_MOTION_INL_H_
#undef WARPLUT_RUNTIME_GENERATION_TARGET_MOTION_INL_H_
#else
#define WARPLUT_RUNTIME_GENERATION_TARGET_MOTION_INL_H_
#endif

#include "runtime/generation/motion/geometry-inl.h"

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

// Marks pixels [x, x + kLanes) of row y, all inside and not on the left or right border, that need
// TargetMotionAt.
HWY_INLINE FloatMask NeedSearch(const GenerationJob& job, const KeyView& keys,
                                const DepthTolerance& tolerance, int x, int y) {
  const FloatTag d;
  const auto center = SplatDepths(keys.Row(y) + x);
  const auto none = hn::Set(d, kNoArrivalDepth);
  if (!Refines(job.options)) return hn::Eq(center, none);
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

  HWY_INLINE TargetMotion Read(SplatKey key) {
    const std::uint32_t source = SplatSource(key);
    const float* displacement = forward_ + 2 * std::size_t{source};
    const float* motion = MotionOf(source);
    return {{displacement[0] + motion[0], displacement[1] + motion[1]},
            {displacement[0], displacement[1]}};
  }

  // The same for kLanes pixels that are two runs of sources, those of `others` aside, whose motion
  // is whatever; false if they are not. In vectors that follow each other from `to0` and `to1` on;
  // to0 may be null.
  HWY_INLINE bool ReadRuns(const SplatKey* keys, FloatMask others, float* to0, float* to1) {
    const FloatTag d;
    const hn::RebindToUnsigned<FloatTag> du;
    if (width_ < kLanes || keys[0] == kNoSplat || keys[kLanes - 1] == kNoSplat) return false;
    hn::Vec<decltype(du)> sources, depths;
    hn::LoadInterleaved2(du, reinterpret_cast<const std::uint32_t*>(keys), sources, depths);
    const std::uint32_t a = SplatSource(keys[0]);
    const std::uint32_t b = SplatSource(keys[kLanes - 1]) - (kLanes - 1);
    if (Column(a) + kLanes > width_ || Column(b + kLanes - 1) < kLanes - 1) return false;
    const auto starts = hn::Sub(sources, hn::Iota(du, 0));
    const auto in_first = hn::Eq(starts, hn::Set(du, a));
    const auto in_second = hn::Eq(starts, hn::Set(du, b));
    const auto known = hn::Or(hn::Or(in_first, in_second), hn::RebindMask(du, others));
    if (!hn::AllTrue(du, known)) return false;
    const FloatMask first = hn::RebindMask(d, in_first);
    Floats dx, dy, mx, my;
    LoadMotion(first, forward_ + 2 * std::size_t{a}, forward_ + 2 * std::size_t{b}, dx, dy);
    hn::StoreInterleaved2(dx, dy, d, to1);
    if (to0 == nullptr) return true;
    LoadMotion(first, MotionOf(a), MotionOf(b), mx, my);
    hn::StoreInterleaved2(hn::Add(dx, mx), hn::Add(dy, my), d, to0);
    return true;
  }

 private:
  HWY_INLINE std::uint32_t Column(std::uint32_t source) {
    if (source - row_start_ >= width_) {
      const std::uint32_t y = source / width_;
      row_start_ = y * width_;
      motion_row_ = motion_.Row(static_cast<int>(y));
    }
    return source - row_start_;
  }
  HWY_INLINE const float* MotionOf(std::uint32_t source) {
    const std::uint32_t column = Column(source);
    return motion_row_ + 2 * std::size_t{column};
  }

  MotionView motion_;
  const float* forward_;
  std::uint32_t width_;
  const float* motion_row_;
  std::uint32_t row_start_ = 0;
};

inline void TargetMotionRow(const GenerationJob& job, const Arrivals& arrivals, int y,
                            const MutableMotionView& from0, const MutableMotionView& from1,
                            std::uint8_t* disoccluded) {
  const FloatTag d;
  const DepthTolerance tolerance(job);
  const SplatKey* keys = arrivals.keys.Row(y);
  SourceReader reader(job, arrivals);
  float* to0 = job.Interpolates() ? from0.Row(y) : nullptr;
  float* to1 = from1.Row(y);
  const auto set = [&](int x, const TargetMotion& motion) {
    if (job.Interpolates()) SetMotion(from0, x, y, motion.from0);
    SetMotion(from1, x, y, motion.from1);
  };
  const auto search = [&](int x) {
    const TargetMotion motion = TargetMotionAt(job, arrivals, x, y);
    set(x, motion);
    if (motion.filled) disoccluded[x / kTileWidth] = 1;
  };
  int x = 0;
  search(x++);
  for (; x + kLanes < job.width(); x += kLanes) {
    const auto marks = NeedSearch(job, arrivals.keys, tolerance, x, y);
    const bool read =
        reader.ReadRuns(keys + x, marks, to0 == nullptr ? nullptr : to0 + 2 * x, to1 + 2 * x);
    if (read && hn::AllFalse(d, marks)) continue;
    std::uint8_t marked[hn::MaxLanes(d) / 8 + 1] = {};
    hn::StoreMaskBits(d, marks, marked);
    for (int i = 0; i < kLanes; ++i) {
      if ((marked[i / 8] >> (i % 8) & 1) != 0) {
        search(x + i);
      } else if (!read) {
        set(x + i, reader.Read(keys[x + i]));
      }
    }
  }
  for (; x < job.width(); ++x) search(x);
}

// OwnMotionRowReference.
inline void OwnMotionRow(const GenerationJob& job, int y, const MutableMotionView& from0,
                         const MutableMotionView& from1) {
  const FloatTag d;
  alignas(64) float padded_motion[2 * kPixels], padded_own[2 * kPixels];
  for (int x0 = 0; x0 < job.width(); x0 += kPixels) {
    const int count = std::min(kPixels, job.width() - x0);
    const auto bytes = sizeof(float) * 2 * static_cast<std::size_t>(count);
    const float* own = Padded(from1.Row(y) + 2 * x0, 2 * count, 2 * kPixels, padded_own);
    const float* motion =
        Padded(job.motion1.Row(y) + 2 * x0, 2 * count, 2 * kPixels, padded_motion);
    alignas(64) float to0[2 * kPixels], to1[2 * kPixels];
    for (int i = 0; i < kPixels; i += kLanes) {
      Floats dx, dy, mx, my;
      hn::LoadInterleaved2(d, own + 2 * i, dx, dy);
      hn::LoadInterleaved2(d, motion + 2 * i, mx, my);
      const auto moves = hn::And(IsFiniteVector(dx), IsFiniteVector(dy));
      hn::StoreInterleaved2(hn::IfThenElseZero(moves, dx), hn::IfThenElseZero(moves, dy), d,
                            to1 + 2 * i);
      hn::StoreInterleaved2(hn::IfThenElseZero(moves, hn::Add(dx, mx)),
                            hn::IfThenElseZero(moves, hn::Add(dy, my)), d, to0 + 2 * i);
    }
    std::memcpy(from1.Row(y) + 2 * x0, to1, bytes);
    if (job.Interpolates()) std::memcpy(from0.Row(y) + 2 * x0, to0, bytes);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::generation
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
