// What the warp kernels share, per target.
#if defined(WARPLUT_RUNTIME_WARP_SIMD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_WARP_SIMD_INL_H_
#undef WARPLUT_RUNTIME_WARP_SIMD_INL_H_
#else
#define WARPLUT_RUNTIME_WARP_SIMD_INL_H_
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "luts/contract.h"
#include "runtime/core/instruction_sets.h"
#include "runtime/core/pixel.h"
#include "runtime/motion_tiles.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Vectors of 4, 8 or 16 floats: one, two or four RGBA texels.
static_assert(!HWY_HAVE_SCALABLE,
              "the kernels need vectors of known size: runtime/core/instruction_sets.h");
using FloatTag = hn::CappedTag<float, kLargestLanes>;
using IntTag = hn::RebindToSigned<FloatTag>;
inline constexpr int kLanes = static_cast<int>(hn::MaxLanes(FloatTag()));
using Floats = hn::Vec<FloatTag>;
using Ints = hn::Vec<IntTag>;

// first, first + 1, ...; hn::Iota fills its lanes one by one unless `first` is a constant.
HWY_INLINE Ints Numbers(int first) {
  const IntTag d;
  return hn::Add(hn::Set(d, first), hn::Iota(d, 0));
}
// The same as floats, for numbers up to 2^24.
HWY_INLINE Floats PixelNumbers(int first) { return hn::ConvertTo(FloatTag(), Numbers(first)); }

// Highway emulates half conversion where it is missing, but does not round to nearest there.
#if HWY_TARGET == HWY_SSSE3 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_EMU128 || \
    HWY_TARGET == HWY_WASM || HWY_TARGET == HWY_PPC8
inline constexpr bool kNativeHalf = false;
#else
inline constexpr bool kNativeHalf = true;
#endif

// The channels of a vector of tag `d` as floats; 8-bit codes as 0..255.
template <class D, class T>
HWY_INLINE hn::Vec<D> LoadChannels(D d, const T* from) {
  if constexpr (std::is_same_v<T, float>) {
    return hn::LoadU(d, from);
  } else if constexpr (std::is_same_v<T, std::uint8_t>) {
    const hn::Rebind<std::uint8_t, D> d8;
    const hn::RebindToSigned<D> di;
    return hn::ConvertTo(d, hn::PromoteTo(di, hn::LoadU(d8, from)));
  } else {
    return hn::PromoteTo(d, hn::LoadU(hn::Rebind<hwy::float16_t, D>(), from));
  }
}

// kLanes of them.
template <class T>
HWY_INLINE hn::Vec<FloatTag> LoadChannels(const T* from) {
  return LoadChannels(FloatTag(), from);
}

// Asks for the lines of `count` bytes.
HWY_INLINE void PrefetchBytes(const void* from, int count) {
  constexpr int kLine = 64;
  for (int i = 0; i < count; i += kLine) hwy::Prefetch(static_cast<const std::byte*>(from) + i);
}

// Rounds `count` channels into the format of `to`; rounding as pixel.h defines it. Reads `sums`,
// and may write `to`, up to the next multiple of kLanes.
HWY_INLINE void RoundChannels(PixelFormat format, const float* HWY_RESTRICT sums, int count,
                              void* HWY_RESTRICT to) {
  const FloatTag d;
  if (format == PixelFormat::kRgba8) {
    const hn::Rebind<std::uint8_t, FloatTag> d8;
    for (int i = 0; i < count; i += kLanes) {
      const auto shifted = hn::Add(hn::LoadU(d, sums + i), hn::Set(d, 0.5f));
      const auto code = hn::Min(hn::Max(shifted, hn::Zero(d)), hn::Set(d, 255.0f));
      hn::StoreU(hn::DemoteTo(d8, hn::ConvertTo(IntTag(), code)), d8,
                 static_cast<std::uint8_t*>(to) + i);
    }
  } else if (format == PixelFormat::kRgba16F) {
    if constexpr (kNativeHalf) {
      const hn::Rebind<hwy::float16_t, FloatTag> d16;
      for (int i = 0; i < count; i += kLanes) {
        hn::StoreU(hn::DemoteTo(d16, hn::LoadU(d, sums + i)), d16,
                   static_cast<hwy::float16_t*>(to) + i);
      }
    } else {
      for (int i = 0; i < count; ++i) StoreChannel(format, sums[i], to, i);
    }
  } else {
    std::memcpy(to, sums, sizeof(float) * static_cast<std::size_t>(count));
  }
}

// The same for any `count` up to kStoredChannels, writing no more than that.
inline constexpr int kStoredChannels = 256;

HWY_INLINE void StoreChannels(PixelFormat format, const float* HWY_RESTRICT sums, int count,
                              void* HWY_RESTRICT to) {
  if (count % kLanes == 0) {
    RoundChannels(format, sums, count, to);
    return;
  }
  alignas(64) std::byte rounded[kStoredChannels * sizeof(float)];
  RoundChannels(format, sums, count, rounded);
  std::memcpy(to, rounded,
              static_cast<std::size_t>(count) * BytesPerPixel(format) / Channels(format));
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
