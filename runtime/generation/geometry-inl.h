// What the vector kernels of frame generation share, per target. Each computes what the plain version of its pass does, in
// the same order and without fused operations.
#if defined(WARPLUT_RUNTIME_GENERATION_GEOMETRY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_GENERATION_GEOMETRY_INL_H_
#undef WARPLUT_RUNTIME_GENERATION_GEOMETRY_INL_H_
#else
#define WARPLUT_RUNTIME_GENERATION_GEOMETRY_INL_H_
#endif

#include <algorithm>
#include <cstring>

#include "runtime/generation/row_kernels.h"
#include "runtime/warp_simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut::generation {
namespace HWY_NAMESPACE {

using namespace warplut::HWY_NAMESPACE;

using Floats = hn::Vec<FloatTag>;
using Ints = hn::Vec<IntTag>;
using FloatMask = hn::Mask<FloatTag>;

inline constexpr int kPixels = 64;  // pixels of a row that go through each step together
static_assert(kPixels * 4 <= kStoredChannels);

// `count` floats at `from`, padded with zeros up to kPixels * step, or `from` itself if it has as many.
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
  return hn::IfThenElse(valid, hn::Abs(depth), farthest);
}

// DepthDifference.
HWY_INLINE Floats DepthDifferences(DepthMeasure measure, Floats a, Floats b) {
  const FloatTag d;
  if (measure == DepthMeasure::kNone) return hn::Zero(d);
  const auto difference = hn::Sub(a, b);
  if (measure == DepthMeasure::kAbsolute) return difference;
  return hn::Div(difference, hn::Max(hn::Min(a, b), hn::Set(d, 1e-12f)));
}

// Gate.
HWY_INLINE Floats Gates(Floats x, float threshold, float width) {
  const FloatTag d;
  const auto one = hn::Set(d, 1.0f);
  const float half = threshold * width;
  if (!(half > 0.0f)) return hn::IfThenElseZero(hn::Le(x, hn::Set(d, threshold)), one);
  const auto share = hn::Div(hn::Sub(hn::Set(d, threshold + half), x), hn::Set(d, half + half));
  return hn::IfThenElseZero(hn::Gt(share, hn::Zero(d)), hn::Min(share, one));
}

// NearestPixel of kLanes pixels of row y from x on; `inside` tells where it is one, the others are 0.
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

// Whether the pixels follow each other in one row, as they do where motion changes little: then vectors are read in place of
// single pixels.
HWY_INLINE bool IsRun(Ints x, Ints y) {
  const IntTag d;
  const auto follow = hn::Eq(x, hn::Iota(d, hn::GetLane(x)));
  return hn::AllTrue(d, hn::And(follow, hn::Eq(y, hn::Set(d, hn::GetLane(y)))));
}

// Reads pixels (x, y), given that they lie in the image.
HWY_INLINE void GatherPixels(const ImageView& image, Ints x, Ints y, float* HWY_RESTRICT to) {
  const IntTag d;
  if (IsRun(x, y)) {
    std::memcpy(to, image.Row<float>(hn::GetLane(y)) + hn::GetLane(x), sizeof(float) * kLanes);
    return;
  }
  alignas(64) std::int32_t px[kLanes], py[kLanes];
  hn::Store(x, d, px);
  hn::Store(y, d, py);
  for (int i = 0; i < kLanes; ++i) to[i] = image.Row<float>(py[i])[px[i]];
}
HWY_INLINE void GatherPixels(const MotionView& motion, Ints x, Ints y, float* HWY_RESTRICT to) {
  const IntTag d;
  if (IsRun(x, y)) {
    std::memcpy(to, motion.Row(hn::GetLane(y)) + 2 * hn::GetLane(x), sizeof(float) * 2 * kLanes);
    return;
  }
  alignas(64) std::int32_t px[kLanes], py[kLanes];
  hn::Store(x, d, px);
  hn::Store(y, d, py);
  for (int i = 0; i < kLanes; ++i) {
    std::memcpy(to + 2 * i, motion.Row(py[i]) + 2 * px[i], 2 * sizeof(float));
  }
}

HWY_INLINE Floats PixelNumbers(int first) {
  return hn::ConvertTo(FloatTag(), hn::Iota(IntTag(), first));
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut::generation
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
