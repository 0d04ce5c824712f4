// The first steps of the general kernel, for some pixels of a row: split the motion, then find or
// compute the weights.
#if defined(WARPLUT_RUNTIME_WARP_WEIGHTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_WARP_WEIGHTS_INL_H_
#undef WARPLUT_RUNTIME_WARP_WEIGHTS_INL_H_
#else
#define WARPLUT_RUNTIME_WARP_WEIGHTS_INL_H_
#endif

#include <algorithm>
#include <array>
#include <limits>

#include "runtime/core/warp_simd-inl.h"
#include "runtime/motion/motion_split.h"
#include "runtime/warp/tap_polynomials.h"
#include "runtime/warp/warp_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

inline constexpr int kRowPixels = 64;  // pixels that go through each step together

// The state of some pixels of a row; each array has one entry, or one row, per pixel.
struct alignas(64) PixelRow {
  int count;        // pixels, at most kRowPixels
  int padded;       // the same, rounded up to kLanes
  bool all_inside;  // no window touches the border
  bool any_whole;   // some offset is (0, 0)
  alignas(64) std::int32_t texel_x[kRowPixels];
  alignas(64) std::int32_t texel_y[kRowPixels];
  alignas(64) float offset_x[kRowPixels];
  alignas(64) float offset_y[kRowPixels];
  alignas(64) std::int32_t row[kRowPixels];                // of weights
  alignas(64) float weights[kRowPixels * kMostRowFloats];  // RowFloats of the footprint apart
  alignas(64) float sums[kRowPixels * 4];
};

// SplitMotion and SampledTexel for kLanes pixels p.
HWY_INLINE void SplitAxis(hn::Vec<FloatTag> m, hn::Vec<IntTag> p, int size, hn::Vec<IntTag>& texel,
                          hn::Vec<FloatTag>& offset) {
  const FloatTag d;
  const IntTag di;
  const auto one = hn::Set(d, 1.0f);
  const auto finite = hn::Le(hn::Abs(m), hn::Set(d, std::numeric_limits<float>::max()));
  const auto minus_m = hn::Neg(hn::IfThenElseZero(finite, m));
  auto whole = hn::Floor(minus_m);
  offset = hn::Sub(minus_m, whole);
  const auto carry = hn::Ge(offset, one);
  offset = hn::IfThenZeroElse(carry, offset);
  whole = hn::Add(whole, hn::IfThenElseZero(carry, one));
  whole = hn::Min(hn::Max(whole, hn::Set(d, -kFarthestTexel)), hn::Set(d, kFarthestTexel));
  const auto sampled = hn::Add(p, hn::ConvertTo(di, whole));
  texel = hn::Min(hn::Max(sampled, hn::Set(di, kFirstSampledTexel)),
                  hn::Set(di, LastSampledTexel(size)));
}

// MoveInside for kLanes pixels.
HWY_INLINE void MoveInside(int size, hn::Vec<IntTag>& texel, hn::Vec<FloatTag>& offset) {
  const FloatTag d;
  const IntTag di;
  const auto last = hn::Set(di, size - 1);
  const auto outside = hn::Or(hn::Lt(texel, hn::Zero(di)), hn::Gt(texel, hn::Set(di, size - 2)));
  offset = hn::IfThenZeroElse(hn::RebindMask(d, outside), offset);
  texel = hn::Min(hn::Max(texel, hn::Zero(di)), last);
}

// Whether the taps of the footprint lie inside an axis of `size` texels.
template <Footprint kFootprint>
HWY_INLINE hn::Mask<IntTag> AreInside(hn::Vec<IntTag> texel, int size) {
  const IntTag di;
  constexpr int kFirst = FirstAxisTap(kFootprint);
  constexpr int kEnd = kFirst + AxisTaps(kFootprint);
  return hn::And(hn::Gt(texel, hn::Set(di, -kFirst - 1)),
                 hn::Lt(texel, hn::Set(di, size - kEnd + 1)));
}

template <Footprint kFootprint>
HWY_INLINE void SplitRow(const WarpJob& job, int x0, int y, PixelRow& r) {
  const FloatTag d;
  const IntTag di;
  const float* motion = job.motion.Row(y) + 2 * x0;
  alignas(64) float padded_motion[2 * kRowPixels];
  if (r.padded != r.count) {
    std::fill(padded_motion, padded_motion + 2 * r.padded, 0.0f);
    std::memcpy(padded_motion, motion, sizeof(float) * 2 * static_cast<std::size_t>(r.count));
    motion = padded_motion;
  }
  auto inside = hn::FirstN(di, static_cast<std::size_t>(kLanes));
  auto moved = inside;
  const int width = job.history.width;
  const int height = job.history.height;
  for (int i = 0; i < r.padded; i += kLanes) {
    hn::Vec<FloatTag> mx, my, offset_x, offset_y;
    hn::Vec<IntTag> tx, ty;
    hn::LoadInterleaved2(d, motion + 2 * i, mx, my);
    SplitAxis(mx, Numbers(x0 + i), width, tx, offset_x);
    SplitAxis(my, hn::Set(di, y), height, ty, offset_y);
    if (job.IsPrefiltered()) {
      MoveInside(width, tx, offset_x);
      MoveInside(height, ty, offset_y);
    }
    hn::Store(tx, di, r.texel_x + i);
    hn::Store(ty, di, r.texel_y + i);
    hn::Store(offset_x, d, r.offset_x + i);
    hn::Store(offset_y, d, r.offset_y + i);
    const auto inside_x = AreInside<kFootprint>(tx, width);
    const auto inside_y = AreInside<kFootprint>(ty, height);
    inside = hn::And(inside, hn::And(inside_x, inside_y));
    moved = hn::And(moved, hn::RebindMask(di, hn::Gt(hn::Max(offset_x, offset_y), hn::Zero(d))));
  }
  r.all_inside = hn::AllTrue(di, inside);
  r.any_whole = !hn::AllTrue(di, moved);
}

// Nearest lookup: the rows of the table.
HWY_INLINE void FindNodes(PixelRow& r) {
  const FloatTag d;
  const IntTag di;
  const auto nodes = hn::Set(d, static_cast<float>(kNodes));
  const auto half = hn::Set(d, 0.5f);
  for (int i = 0; i < r.padded; i += kLanes) {
    const auto x = hn::ConvertTo(di, hn::MulAdd(hn::Load(d, r.offset_x + i), nodes, half));
    const auto y = hn::ConvertTo(di, hn::MulAdd(hn::Load(d, r.offset_y + i), nodes, half));
    hn::Store(hn::Add(hn::Mul(y, hn::Set(di, kTableNodes)), x), di, r.row + i);
  }
}

// Bilinear lookup: the mean of four rows of the table.
template <Footprint kFootprint>
HWY_INLINE void BlendNodes(const Table& table, PixelRow& r) {
  constexpr int kStride = RowFloats(kFootprint);
  const FloatTag d;
  const IntTag di;
  alignas(64) std::int32_t corner[kRowPixels];
  alignas(64) float share[4][kRowPixels];
  const auto nodes = hn::Set(d, static_cast<float>(kNodes));
  const auto one = hn::Set(d, 1.0f);
  for (int i = 0; i < r.padded; i += kLanes) {
    const auto x = hn::Mul(hn::Load(d, r.offset_x + i), nodes);
    const auto y = hn::Mul(hn::Load(d, r.offset_y + i), nodes);
    const auto ix = hn::ConvertTo(di, x);
    const auto jy = hn::ConvertTo(di, y);
    const auto fx = hn::Sub(x, hn::ConvertTo(d, ix));
    const auto fy = hn::Sub(y, hn::ConvertTo(d, jy));
    const auto gx = hn::Sub(one, fx);
    const auto gy = hn::Sub(one, fy);
    hn::Store(hn::Add(hn::Mul(jy, hn::Set(di, kTableNodes)), ix), di, corner + i);
    hn::Store(hn::Mul(gx, gy), d, share[0] + i);
    hn::Store(hn::Mul(fx, gy), d, share[1] + i);
    hn::Store(hn::Mul(gx, fy), d, share[2] + i);
    hn::Store(hn::Mul(fx, fy), d, share[3] + i);
    hn::Store(Numbers(i), di, r.row + i);
  }
  for (int p = 0; p < r.padded; ++p) {
    const float* upper = table.data() + corner[p] * kStride;
    const float* lower = upper + kTableNodes * kStride;
    for (int k = 0; k < TapCount(kFootprint); k += kLanes) {
      auto w = hn::Mul(hn::Set(d, share[0][p]), hn::Load(d, upper + k));
      w = hn::MulAdd(hn::Set(d, share[1][p]), hn::Load(d, upper + kStride + k), w);
      auto v = hn::Mul(hn::Set(d, share[2][p]), hn::Load(d, lower + k));
      v = hn::MulAdd(hn::Set(d, share[3][p]), hn::Load(d, lower + kStride + k), v);
      hn::Store(hn::Add(w, v), d, r.weights + p * kStride + k);
    }
  }
}

// Closed-form filters: the product of the weights of both axes, of 16 taps.
HWY_INLINE void TapsAt(const TapPolynomials& taps, const float* offsets, float* to) {
  const FloatTag d;
  const auto x = hn::Load(d, offsets);
  const auto tap = [&](int t) HWY_ATTR {
    const std::array<float, 4>& c = taps.coefficients[t];
    auto sum = hn::MulAdd(hn::Set(d, c[3]), x, hn::Set(d, c[2]));
    sum = hn::MulAdd(sum, x, hn::Set(d, c[1]));
    return hn::MulAdd(sum, x, hn::Set(d, c[0]));
  };
  const auto t0 = tap(0);
  const auto t1 = tap(1);
  const auto t3 = tap(3);
  const auto rest = hn::Add(t1, hn::Add(t0, t3));
  hn::StoreInterleaved4(t0, t1, hn::Sub(hn::Set(d, 1.0f), rest), t3, d, to);
}

HWY_INLINE void ComputeWeights(const TapPolynomials& taps, PixelRow& r) {
  const hn::FixedTag<float, kTaps> d4;
  const IntTag di;
  alignas(64) float x_taps[kRowPixels * kTaps];
  alignas(64) float y_taps[kRowPixels * kTaps];
  for (int i = 0; i < r.padded; i += kLanes) {
    TapsAt(taps, r.offset_x + i, x_taps + i * kTaps);
    TapsAt(taps, r.offset_y + i, y_taps + i * kTaps);
    hn::Store(Numbers(i), di, r.row + i);
  }
  for (int p = 0; p < r.padded; ++p) {
    const auto x = hn::Load(d4, x_taps + p * kTaps);
    for (int ky = 0; ky < kTaps; ++ky) {
      hn::Store(hn::Mul(x, hn::Set(d4, y_taps[p * kTaps + ky])), d4,
                r.weights + p * RowFloats(Footprint::k16) + ky * kTaps);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
