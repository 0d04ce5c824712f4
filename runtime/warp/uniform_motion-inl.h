// Whether pixels share one motion vector.
#if defined(WARPLUT_RUNTIME_UNIFORM_MOTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_UNIFORM_MOTION_INL_H_
#undef WARPLUT_RUNTIME_UNIFORM_MOTION_INL_H_
#else
#define WARPLUT_RUNTIME_UNIFORM_MOTION_INL_H_
#endif

#include "runtime/core/warp_simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

inline bool UniformMotion(const MotionView& motion, const TileRect& pixels) {
  const FloatTag d;
  const float* first = motion.Row(pixels.y0) + 2 * pixels.x0;
  const auto expected = hn::OddEven(hn::Set(d, first[1]), hn::Set(d, first[0]));
  const int count = 2 * pixels.width();
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    const float* row = motion.Row(y) + 2 * pixels.x0;
    PrefetchBytes(row + count,
                  count * static_cast<int>(sizeof(float)));  // of the tile to the right
    auto equal = hn::Eq(hn::Zero(d), hn::Zero(d));
    int i = 0;
    for (; i + kLanes <= count; i += kLanes) {
      equal = hn::And(equal, hn::Eq(hn::LoadU(d, row + i), expected));
    }
    if (!hn::AllTrue(d, equal)) return false;
    for (; i < count; ++i) {
      if (!(row[i] == first[i % 2])) return false;
    }
  }
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
