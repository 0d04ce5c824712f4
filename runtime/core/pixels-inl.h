// RGBA pixels to and from planar vectors, per target.
#if defined(WARPLUT_RUNTIME_SR_PIXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_SR_PIXELS_INL_H_
#undef WARPLUT_RUNTIME_SR_PIXELS_INL_H_
#else
#define WARPLUT_RUNTIME_SR_PIXELS_INL_H_
#endif

#include <limits>

#include "runtime/core/warp_simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

using WordTag = hn::RebindToUnsigned<FloatTag>;
using Words = hn::Vec<WordTag>;

// kLanes pixels; 8-bit codes as code / 255.
struct Pixels {
  Floats r, g, b, a;
};

// The half in the low 16 bits of each lane. Infinities become +-kHalfInfinity, NaNs NaN.
inline constexpr float kHalfInfinity = 0x1p16f;
HWY_INLINE Floats HalfBits(Words half) {
  const FloatTag d;
  const WordTag dw;
  const auto magnitude = hn::ShiftLeft<13>(hn::And(half, hn::Set(dw, 0x7FFFu)));
  // The bits of a subnormal half make a subnormal float: it is put below the bits of a normal one,
  // 2^-14, and that taken off.
  const auto least = hn::Set(d, 0x1p-14f);
  const auto normal = hn::BitCast(d, hn::Add(magnitude, hn::Set(dw, 112u << 23)));
  const auto small = hn::Sub(hn::BitCast(d, hn::Or(magnitude, hn::BitCast(dw, least))), least);
  const auto scaled = hn::IfThenElse(hn::Lt(normal, least), small, normal);
  const auto sign = hn::ShiftLeft<16>(hn::And(half, hn::Set(dw, 0x8000u)));
  const auto number = hn::Le(scaled, hn::Set(d, kHalfInfinity));
  const auto checked =
      hn::IfThenElse(number, scaled, hn::Set(d, std::numeric_limits<float>::quiet_NaN()));
  return hn::Or(checked, hn::BitCast(d, sign));
}

// The half nearest to v in [0, 65504], ties to even, in the low bits.
HWY_INLINE Words ToHalfBits(Floats v) {
  const FloatTag d;
  const WordTag dw;
  const auto bits = hn::BitCast(dw, v);
  const auto odd = hn::And(hn::ShiftRight<13>(bits), hn::Set(dw, 1u));
  const auto normal =
      hn::ShiftRight<13>(hn::Add(hn::Sub(bits, hn::Set(dw, (112u << 23) - 0xFFFu)), odd));
  const auto shifted = hn::BitCast(dw, hn::Add(v, hn::Set(d, 0.5f)));
  const auto small = hn::Sub(shifted, hn::Set(dw, 0x3F000000u));
  return hn::IfThenElse(hn::RebindMask(dw, hn::Lt(v, hn::Set(d, 0x1p-14f))), small, normal);
}

HWY_INLINE Pixels LoadWhole(PixelFormat format, const void* from) {
  const FloatTag d;
  const WordTag dw;
  const IntTag di;
  const auto* words = static_cast<const std::uint32_t*>(from);
  if (format == PixelFormat::kRgba16F) {
    Words rg, ba;
    hn::LoadInterleaved2(dw, words, rg, ba);
    return {HalfBits(rg), HalfBits(hn::ShiftRight<16>(rg)), HalfBits(ba),
            HalfBits(hn::ShiftRight<16>(ba))};
  }
  if (format == PixelFormat::kRgba8) {
    const auto code = hn::LoadU(dw, words);
    const auto byte = hn::Set(dw, 0xFFu);
    const auto unit = hn::Set(d, 1.0f / ChannelScale(format));
    const auto value = [&](Words shifted) HWY_ATTR {
      return hn::Mul(hn::ConvertTo(d, hn::BitCast(di, hn::And(shifted, byte))), unit);
    };
    return {value(code), value(hn::ShiftRight<8>(code)), value(hn::ShiftRight<16>(code)),
            value(hn::ShiftRight<24>(code))};
  }
  Floats r, g, b, a;
  hn::LoadInterleaved4(d, static_cast<const float*>(from), r, g, b, a);
  return {r, g, b, a};
}

HWY_INLINE void StoreWhole(PixelFormat format, const Pixels& p, void* to) {
  const FloatTag d;
  const WordTag dw;
  const IntTag di;
  auto* words = static_cast<std::uint32_t*>(to);
  if (format == PixelFormat::kRgba16F) {
    const auto rg = hn::Or(ToHalfBits(p.r), hn::ShiftLeft<16>(ToHalfBits(p.g)));
    const auto ba = hn::Or(ToHalfBits(p.b), hn::ShiftLeft<16>(ToHalfBits(p.a)));
    hn::StoreInterleaved2(rg, ba, dw, words);
  } else if (format == PixelFormat::kRgba8) {
    const auto white = hn::Set(d, ChannelScale(format));
    const auto code = [&](Floats v) HWY_ATTR {
      const auto rounded = hn::Add(hn::Mul(v, white), hn::Set(d, 0.5f));
      const auto limited = hn::Min(hn::Max(rounded, hn::Zero(d)), white);
      return hn::BitCast(dw, hn::ConvertTo(di, limited));
    };
    const auto rg = hn::Or(code(p.r), hn::ShiftLeft<8>(code(p.g)));
    const auto ba = hn::Or(code(p.b), hn::ShiftLeft<8>(code(p.a)));
    hn::StoreU(hn::Or(rg, hn::ShiftLeft<16>(ba)), dw, words);
  } else {
    hn::StoreInterleaved4(p.r, p.g, p.b, p.a, d, static_cast<float*>(to));
  }
}

// Pixels x to x + kLanes of a row of which `left` (> 0) remain; lanes beyond them are arbitrary,
// and not stored. Channels that are stored in halves lie in [0, 65504].
template <class Image>
HWY_INLINE Pixels LoadPixels(const Image& image, int x, int y, int left) {
  if (left >= kLanes) return LoadWhole(image.format, image.At(x, y));
  alignas(64) std::byte whole[kLanes * 4 * sizeof(float)] = {};
  std::memcpy(whole, image.At(x, y), static_cast<std::size_t>(left) * BytesPerPixel(image.format));
  return LoadWhole(image.format, whole);
}

HWY_INLINE void StorePixels(const Pixels& p, const MutableImageView& image, int x, int y,
                            int left) {
  if (left >= kLanes) {
    StoreWhole(image.format, p, image.At(x, y));
    return;
  }
  alignas(64) std::byte whole[kLanes * 4 * sizeof(float)];
  StoreWhole(image.format, p, whole);
  std::memcpy(image.At(x, y), whole, static_cast<std::size_t>(left) * BytesPerPixel(image.format));
}

HWY_INLINE Floats Limit(Floats v) {
  const FloatTag d;
  return hn::Min(hn::Max(v, hn::Zero(d)), hn::Set(d, 1.0f));
}

// a + t (b - a).
HWY_INLINE Floats Mix(Floats a, Floats b, Floats t) { return hn::MulAdd(t, hn::Sub(b, a), a); }

// to[i] = upper[i] + share (lower[i] - upper[i]) for a whole row and its border.
HWY_INLINE void MixRows(const float* HWY_RESTRICT upper, const float* HWY_RESTRICT lower,
                        float share, int width, float* HWY_RESTRICT to) {
  const FloatTag d;
  const auto t = hn::Set(d, share);
  for (int i = 0; i < width + kLanes; i += kLanes) {
    hn::Store(Mix(hn::Load(d, upper + i), hn::Load(d, lower + i), t), d, to + i);
  }
}

// Takes the values of a render row that belong to kLanes output columns from x on: as the columns
// are dense, they mostly lie in one vector.
class Columns {
 public:
  // `index` ascends; columns beyond the image repeat indices that exist.
  HWY_INLINE Columns(const int* index, int x) : base_(index[x]) {
    const FloatTag d;
    const IntTag di;
    const auto distance = hn::Sub(hn::LoadU(di, index + x), hn::Set(di, base_));
    narrow_ = index[x + kLanes - 1] + 1 - base_ < kLanes;
    distance_ = distance;
    next_distance_ = hn::Add(distance, hn::Set(di, 1));
    const auto last = hn::Set(di, kLanes - 1);
    here_ = hn::IndicesFromVec(d, hn::Min(distance, last));
    next_ = hn::IndicesFromVec(d, hn::Min(next_distance_, last));
  }

  // row[index] and row[index + 1].
  HWY_INLINE Floats At(const float* row) const { return Take(row, here_, distance_); }
  HWY_INLINE Floats Next(const float* row) const { return Take(row, next_, next_distance_); }
  // row[index] + t (row[index + 1] - row[index]).
  HWY_INLINE Floats Mixed(const float* row, Floats t) const { return Mix(At(row), Next(row), t); }

 private:
  using Indices = decltype(hn::IndicesFromVec(FloatTag(), Ints()));

  HWY_INLINE Floats Take(const float* row, Indices indices, Ints distance) const {
    const FloatTag d;
    if (HWY_LIKELY(narrow_)) return hn::TableLookupLanes(hn::LoadU(d, row + base_), indices);
    return hn::GatherIndex(d, row + base_, distance);
  }

  int base_;
  bool narrow_;
  Ints distance_, next_distance_;
  Indices here_, next_;
};

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
