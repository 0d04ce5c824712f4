// What the vector kernels of frame generation share, per target. Each computes what the plain
// version of its pass does, in the same order and without fused operations.
#if defined(WARPLUT_RUNTIME_GENERATION_GEOMETRY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_GENERATION_GEOMETRY_INL_H_
#undef WARPLUT_RUNTIME_GENERATION_GEOMETRY_INL_H_
#else
#define WARPLUT_RUNTIME_GENERATION_GEOMETRY_INL_H_
#endif

#include <algorithm>
#include <cstring>

#include "runtime/core/gates-inl.h"
#include "runtime/core/warp_simd-inl.h"
#include "runtime/generation/row_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::generation {
namespace HWY_NAMESPACE {

using namespace warplut::HWY_NAMESPACE;

using FloatMask = hn::Mask<FloatTag>;

inline constexpr int kPixels = 64;  // pixels of a row that go through each step together
static_assert(kPixels * 4 <= kStoredChannels);

// `count` floats at `from`, padded with zeros up to kPixels * step, or `from` itself if it has as
// many.
HWY_INLINE const float* Padded(const float* from, int count, int size, float* HWY_RESTRICT padded) {
  if (count == size) return from;
  std::memcpy(padded, from, sizeof(float) * static_cast<std::size_t>(count));
  std::fill(padded + count, padded + size, 0.0f);
  return padded;
}

HWY_INLINE FloatMask IsFiniteVector(Floats v) {
  return hn::Le(hn::Abs(v), hn::Set(FloatTag(), std::numeric_limits<float>::max()));
}

// CleanDepth.
HWY_INLINE Floats CleanDepths(Floats depth) {
  const FloatTag d;
  const auto farthest = hn::Set(d, kFarthestDepth);
  const auto valid = hn::And(hn::Ge(depth, hn::Zero(d)), hn::Le(depth, farthest));
  return hn::IfThenElse(valid, hn::Add(depth, hn::Zero(d)), farthest);
}

// NearestPixel of kLanes pixels of row y from x on; `inside` tells where it is one, the others are
// 0.
struct NearestPixels {
  Ints x, y;
  FloatMask inside;
};
HWY_INLINE NearestPixels FindNearest(const GenerationJob& job, Floats x, float y, Floats dx,
                                     Floats dy) {
  const FloatTag d;
  const IntTag di;
  const auto half = hn::Set(d, 0.5f);
  const auto zero = hn::Zero(d);
  const auto fx = hn::Floor(hn::Add(hn::Add(x, dx), half));
  const auto fy = hn::Floor(hn::Add(hn::Add(hn::Set(d, y), dy), half));
  const auto inside_x =
      hn::And(hn::Ge(fx, zero), hn::Lt(fx, hn::Set(d, static_cast<float>(job.width()))));
  const auto inside_y =
      hn::And(hn::Ge(fy, zero), hn::Lt(fy, hn::Set(d, static_cast<float>(job.height()))));
  const auto inside = hn::And(inside_x, inside_y);
  return {hn::ConvertTo(di, hn::IfThenElseZero(inside, fx)),
          hn::ConvertTo(di, hn::IfThenElseZero(inside, fy)), inside};
}

// Pixels that are two runs, each of neighbours in a row, as they are nearly always where motion
// changes little: they are read and written as vectors in place of single pixels. Pixels [0,
// kLanes) of both runs lie in the image.
struct TwoRuns {
  FloatMask first;  // pixels of the first run
  int x0, y0;       // of its first pixel
  int x1, y1;       // where the second one would begin if it had kLanes pixels
  bool found;

  HWY_INLINE TwoRuns(Ints x, Ints y, int width) {
    const FloatTag d;
    const IntTag di;
    x0 = hn::GetLane(x);
    y0 = hn::GetLane(y);
    x1 = hn::ExtractLane(x, kLanes - 1) - (kLanes - 1);
    y1 = hn::ExtractLane(y, kLanes - 1);
    const auto starts = hn::Sub(x, hn::Iota(di, 0));
    const auto in_first = hn::And(hn::Eq(starts, hn::Set(di, x0)), hn::Eq(y, hn::Set(di, y0)));
    const auto in_second = hn::And(hn::Eq(starts, hn::Set(di, x1)), hn::Eq(y, hn::Set(di, y1)));
    first = hn::RebindMask(d, in_first);
    found = x0 + kLanes <= width && x1 >= 0 && hn::AllTrue(di, hn::Or(in_first, in_second));
  }
};

// Reads pixels (x, y), given that they lie in the image.
HWY_INLINE void GatherPixels(const ImageView& image, Ints x, Ints y, const TwoRuns& runs,
                             float* HWY_RESTRICT to) {
  const FloatTag d;
  const IntTag di;
  if (runs.found) {
    hn::Store(hn::IfThenElse(runs.first, hn::LoadU(d, image.Row<float>(runs.y0) + runs.x0),
                             hn::LoadU(d, image.Row<float>(runs.y1) + runs.x1)),
              d, to);
    return;
  }
  alignas(64) std::int32_t px[kLanes], py[kLanes];
  hn::Store(x, di, px);
  hn::Store(y, di, py);
  for (int i = 0; i < kLanes; ++i) to[i] = image.Row<float>(py[i])[px[i]];
}

// Motion of kLanes pixels that follow each other, at `a` for the lanes of `first` and at `b` for
// the others.
HWY_INLINE void LoadMotion(FloatMask first, const float* a, const float* b, Floats& mx,
                           Floats& my) {
  const FloatTag d;
  Floats ax, ay, bx, by;
  hn::LoadInterleaved2(d, a, ax, ay);
  hn::LoadInterleaved2(d, b, bx, by);
  mx = hn::IfThenElse(first, ax, bx);
  my = hn::IfThenElse(first, ay, by);
}

HWY_INLINE void GatherPixels(const MotionView& motion, Ints x, Ints y, const TwoRuns& runs,
                             float* HWY_RESTRICT to_x, float* HWY_RESTRICT to_y) {
  const FloatTag d;
  const IntTag di;
  if (runs.found) {
    Floats mx, my;
    LoadMotion(runs.first, motion.Row(runs.y0) + 2 * runs.x0, motion.Row(runs.y1) + 2 * runs.x1, mx,
               my);
    hn::Store(mx, d, to_x);
    hn::Store(my, d, to_y);
    return;
  }
  alignas(64) std::int32_t px[kLanes], py[kLanes];
  hn::Store(x, di, px);
  hn::Store(y, di, py);
  for (int i = 0; i < kLanes; ++i) {
    const float* from = motion.Row(py[i]) + 2 * px[i];
    to_x[i] = from[0];
    to_y[i] = from[1];
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::generation
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
