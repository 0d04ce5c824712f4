// The kernel for pixels that have each their own motion.
//
// kRowPixels pixels of a row are processed in steps over all of them: split the motion, find or
// compute the weights, sum weights times texels, round. A group of four RGBA texels
// (luts/tap_layout.h) is 16 channels, hence one, two or four vectors; windows that touch the border
// are gathered with clamped coordinates first.
#if defined(WARPLUT_RUNTIME_WARP_GENERAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_WARP_GENERAL_INL_H_
#undef WARPLUT_RUNTIME_WARP_GENERAL_INL_H_
#else
#define WARPLUT_RUNTIME_WARP_GENERAL_INL_H_
#endif

#include "runtime/warp/warp_weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

inline constexpr int kRgba = 4;
inline constexpr int kGroup = kLanes / kRgba;  // pixels whose sums fill a vector

// The texel of tap (0, 0), and the distance of rows in channels.
template <class T>
struct Window {
  const T* texel;
  std::ptrdiff_t stride;
};

// Copies the least square around the footprint with clamped coordinates. T is float where the
// format has no vector load.
template <class T, int kChannels, Footprint kFootprint>
HWY_NOINLINE void GatherWindow(const ImageView& history, int tx, int ty, T* HWY_RESTRICT to) {
  constexpr int kSide = AxisTaps(kFootprint);
  constexpr int kFirst = FirstAxisTap(kFootprint);
  for (int k = 0; k < kSide * kSide; ++k) {
    const int x = std::clamp(tx + kFirst + k % kSide, 0, history.width - 1);
    const int y = std::clamp(ty + kFirst + k / kSide, 0, history.height - 1);
    if constexpr (std::is_same_v<T, float>) {
      for (int c = 0; c < kChannels; ++c) {
        to[k * kChannels + c] = LoadChannel(history.format, history.At(x, y), c);
      }
    } else {
      std::memcpy(to + k * kChannels, history.At(x, y), sizeof(T) * kChannels);
    }
  }
}

// How windows are read: where they are, gathered if they touch the border, or always gathered.
enum class Windows { kInside, kMixed, kGathered };

template <class T, int kChannels, Windows kWindows, Footprint kFootprint>
HWY_INLINE Window<T> FindWindow(const ImageView& history, int tx, int ty, T* HWY_RESTRICT scratch) {
  constexpr int kSide = AxisTaps(kFootprint);
  constexpr int kFirst = FirstAxisTap(kFootprint);
  const auto inside_axis = [](int texel, int size) {
    return texel >= -kFirst && texel <= size - kSide - kFirst;
  };
  const bool inside = kWindows == Windows::kInside ||
                      (kWindows == Windows::kMixed && inside_axis(tx, history.width) &&
                       inside_axis(ty, history.height));
  if (inside) {
    const auto stride = history.stride / static_cast<std::ptrdiff_t>(sizeof(T));
    return {static_cast<const T*>(history.data) + ty * stride + tx * kChannels, stride};
  }
  GatherWindow<T, kChannels, kFootprint>(history, tx, ty, scratch);
  return {scratch - kFirst * (kSide + 1) * kChannels, kSide * kChannels};
}

// Texels of a square around a footprint.
constexpr int SquareTexels(Footprint footprint) {
  return AxisTaps(footprint) * AxisTaps(footprint);
}

// Calls visit(std::integral_constant<int, i>) for i = 0..kCount - 1.
template <int kCount, int kFirst = 0, class Visit>
HWY_INLINE void VisitNumbers(const Visit& visit) {
  if constexpr (kFirst < kCount) {
    visit(std::integral_constant<int, kFirst>());
    VisitNumbers<kCount, kFirst + 1>(visit);
  }
}

// kLanes channels of RGBA texels: those of places kPlace and after of the layout, which are in one
// group.
template <class T, Footprint kFootprint, int kPlace>
HWY_INLINE hn::Vec<FloatTag> LoadPlaces(const Window<T>& window) {
  const FloatTag d;
  constexpr TapGroup kTapGroup = LayoutOf(kFootprint).groups[kPlace / kGroupTaps];
  constexpr int kFirst = kPlace % kGroupTaps;
  const auto at = [&](int x, int y)
                      HWY_ATTR { return window.texel + y * window.stride + x * kRgba; };
  if constexpr (kTapGroup.is_run) {
    (void)d;
    return LoadChannels(at(kTapGroup.x[0] + kFirst, kTapGroup.y[0]));
  } else if constexpr (kGroup == kGroupTaps) {
    const hn::Half<FloatTag> half;
    return hn::Combine(d, LoadChannels(half, at(kTapGroup.x[1], kTapGroup.y[1])),
                       LoadChannels(half, at(kTapGroup.x[0], kTapGroup.y[0])));
  } else {
    (void)d;
    constexpr int kPair = kFirst / 2;
    return LoadChannels(at(kTapGroup.x[kPair] + kFirst % 2, kTapGroup.y[kPair]));
  }
}

// The weighted sum of an RGBA window; its kGroup blocks are partial sums. The weight of a texel is
// repeated for its channels: vectors of 16 pick it from all of 16 weights, smaller ones from those
// of a group.
template <class T, Footprint kFootprint>
HWY_INLINE hn::Vec<FloatTag> SumWindow(const float* HWY_RESTRICT weights, const Window<T>& window) {
  const FloatTag d;
  constexpr int kLine = 16;  // weights
  alignas(64) static constexpr std::int32_t kPick[kRgba * kLine] = {
      0,  0,  0,  0,  1,  1,  1,  1,  2,  2,  2,  2,  3,  3,  3,  3,  4,  4,  4,  4,  5,  5,
      5,  5,  6,  6,  6,  6,  7,  7,  7,  7,  8,  8,  8,  8,  9,  9,  9,  9,  10, 10, 10, 10,
      11, 11, 11, 11, 12, 12, 12, 12, 13, 13, 13, 13, 14, 14, 14, 14, 15, 15, 15, 15};
  auto sum = hn::Zero(d);
  VisitNumbers<LayoutOf(kFootprint).count>([&](auto group) HWY_ATTR {
    constexpr int kFirst = group * kGroupTaps;
    constexpr bool kAll = kLanes == kLine;
    const auto some =
        kAll ? hn::Load(d, weights + kFirst / kLine * kLine) : hn::LoadDup128(d, weights + kFirst);
    VisitNumbers<kGroupTaps / kGroup>([&](auto vector) HWY_ATTR {
      constexpr int kPlace = kFirst + vector * kGroup;
      constexpr int kPicked = kAll ? kFirst % kLine : vector * kGroup;
      const auto pick = hn::SetTableIndices(d, kPick + kPicked * kRgba);
      sum = hn::MulAdd(hn::TableLookupLanes(some, pick), LoadPlaces<T, kFootprint, kPlace>(window),
                       sum);
    });
  });
  return sum;
}

// Adds the blocks of each of kGroup vectors; block i of the result belongs to sums[i].
HWY_INLINE hn::Vec<FloatTag> AddBlocks(const hn::Vec<FloatTag>* sums) {
  const FloatTag d;
  if constexpr (kGroup == 1) {
    (void)d;
    return sums[0];
  } else if constexpr (kGroup == 2) {
    return hn::Add(hn::ConcatLowerLower(d, sums[1], sums[0]),
                   hn::ConcatUpperUpper(d, sums[1], sums[0]));
  } else {
    const auto even = hn::Add(hn::ConcatLowerLower(d, sums[2], sums[0]),
                              hn::ConcatUpperUpper(d, sums[2], sums[0]));  // 0 0 2 2
    const auto odd = hn::Add(hn::ConcatLowerLower(d, sums[3], sums[1]),
                             hn::ConcatUpperUpper(d, sums[3], sums[1]));  // 1 1 3 3
    const auto straight = hn::OddEvenBlocks(odd, even);                   // 0 1 2 3
    const auto crossed = hn::OddEvenBlocks(even, odd);                    // 1 0 3 2
    return hn::Add(straight, hn::SwapAdjacentBlocks(crossed));
  }
}

template <class T, Windows kWindows, Footprint kFootprint>
HWY_INLINE void SumRgbaRow(const ImageView& image, const float* HWY_RESTRICT table, PixelRow& r) {
  const FloatTag d;
  const ImageView history = image;
  alignas(64) T scratch[kGroup][SquareTexels(kFootprint) * kRgba];
  for (int p = 0; p < r.padded; p += kGroup) {
    hn::Vec<FloatTag> sums[kGroup];
    for (int i = 0; i < kGroup; ++i) {
      const auto window = FindWindow<T, kRgba, kWindows, kFootprint>(history, r.texel_x[p + i],
                                                                     r.texel_y[p + i], scratch[i]);
      sums[i] = SumWindow<T, kFootprint>(table + r.row[p + i] * RowFloats(kFootprint), window);
    }
    hn::Store(AddBlocks(sums), d, r.sums + p * kRgba);
  }
}

// One channel: a group of four texels is one block.
template <Footprint kFootprint, int kGroupIndex>
HWY_INLINE hn::Vec<hn::FixedTag<float, kGroupTaps>> LoadGroup(const Window<float>& window) {
  const hn::FixedTag<float, kGroupTaps> d4;
  constexpr TapGroup kTapGroup = LayoutOf(kFootprint).groups[kGroupIndex];
  const auto at = [&](int i) HWY_ATTR {
    return window.texel + kTapGroup.y[i] * window.stride + kTapGroup.x[i];
  };
  if constexpr (kTapGroup.is_run) {
    return hn::LoadU(d4, at(0));
  } else {
    const hn::Half<hn::FixedTag<float, kGroupTaps>> half;
    return hn::Combine(d4, hn::LoadU(half, at(1)), hn::LoadU(half, at(0)));
  }
}

template <Windows kWindows, Footprint kFootprint>
HWY_INLINE void SumSingleRow(const ImageView& image, const float* HWY_RESTRICT table, PixelRow& r) {
  const FloatTag d;
  const hn::FixedTag<float, kGroupTaps> d4;
  const ImageView history = image;
  alignas(64) float scratch[SquareTexels(kFootprint)];
  alignas(64) float partial[kRowPixels * kGroupTaps];
  for (int p = 0; p < r.padded; ++p) {
    const auto window =
        FindWindow<float, 1, kWindows, kFootprint>(history, r.texel_x[p], r.texel_y[p], scratch);
    const float* w = table + r.row[p] * RowFloats(kFootprint);
    auto sum = hn::Mul(hn::Load(d4, w), LoadGroup<kFootprint, 0>(window));
    VisitNumbers<LayoutOf(kFootprint).count, 1>([&](auto group) HWY_ATTR {
      sum = hn::MulAdd(hn::Load(d4, w + group * kGroupTaps), LoadGroup<kFootprint, group>(window),
                       sum);
    });
    hn::Store(sum, d4, partial + p * kGroupTaps);
  }
  for (int p = 0; p < r.padded; p += kLanes) {
    hn::Vec<FloatTag> a, b, c, e;
    hn::LoadInterleaved4(d, partial + p * kGroupTaps, a, b, c, e);
    hn::Store(hn::Add(hn::Add(a, b), hn::Add(c, e)), d, r.sums + p);
  }
}

template <class T, Footprint kFootprint>
HWY_INLINE void SumRgba(const ImageView& history, const float* table, PixelRow& r) {
  if (r.all_inside) {
    SumRgbaRow<T, Windows::kInside, kFootprint>(history, table, r);
  } else {
    SumRgbaRow<T, Windows::kMixed, kFootprint>(history, table, r);
  }
}

// `table` has rows of RowFloats(kFootprint), in the order of the layout.
template <Footprint kFootprint>
HWY_INLINE void SumRow(const ImageView& history, const float* table, PixelRow& r) {
  switch (history.format) {
    case PixelFormat::kRgba8:
      SumRgba<std::uint8_t, kFootprint>(history, table, r);
      break;
    case PixelFormat::kRgba16F:
      if constexpr (kNativeHalf) {
        SumRgba<hwy::float16_t, kFootprint>(history, table, r);
      } else {
        SumRgbaRow<float, Windows::kGathered, kFootprint>(history, table, r);
      }
      break;
    case PixelFormat::kRgba32F:
      SumRgba<float, kFootprint>(history, table, r);
      break;
    case PixelFormat::kR32F:
      if (r.all_inside) {
        SumSingleRow<Windows::kInside, kFootprint>(history, table, r);
      } else {
        SumSingleRow<Windows::kMixed, kFootprint>(history, table, r);
      }
      break;
  }
}

// Rounds the sums into the output; pixels of whole displacement copy their sample.
HWY_INLINE void StoreRow(const WarpJob& job, int x0, int y, const PixelRow& r) {
  const PixelFormat format = job.out.format;
  const auto bytes = static_cast<std::size_t>(BytesPerPixel(format));
  StoreChannels(format, r.sums, r.count * Channels(format), job.out.At(x0, y));
  if (!r.any_whole) return;
  const ImageView& samples = job.samples;
  for (int p = 0; p < r.count; ++p) {
    if (r.offset_x[p] != 0 || r.offset_y[p] != 0) continue;
    const int tx = std::clamp(r.texel_x[p], 0, samples.width - 1);
    const int ty = std::clamp(r.texel_y[p], 0, samples.height - 1);
    std::memcpy(job.out.At(x0 + p, y), samples.At(tx, ty), bytes);
  }
}

// Asks for what the pixels after these will need: their motion, their texels if the motion stays as
// it is, and where they are written.
HWY_INLINE void PrefetchNext(const WarpJob& job, int x, int y, const PixelRow& r) {
  constexpr int kMotionBytes = kRowPixels * 2 * static_cast<int>(sizeof(float));
  const ImageView& history = job.history;
  const int bytes = kRowPixels * BytesPerPixel(history.format);
  const int tx = std::clamp(r.texel_x[0], 0, history.width - 1);
  const int ty = std::clamp(r.texel_y[0] + kTaps / 2, 0, history.height - 1);
  PrefetchBytes(reinterpret_cast<const std::byte*>(job.motion.Row(y) + 2 * x) + 2 * kMotionBytes,
                kMotionBytes);
  PrefetchBytes(static_cast<const std::byte*>(history.At(tx, ty)) + bytes, bytes);
  PrefetchBytes(static_cast<const std::byte*>(job.out.At(x, y)) + bytes, bytes);
}

// kFootprint is that of the options.
template <Footprint kFootprint>
HWY_NOINLINE void GeneralPixels(const WarpJob& any_format, const TileRect& pixels) {
  const WarpJob job = any_format.InFormats();
  const Filter filter = FilterOf(job.options);
  const bool lut = kFootprint != Footprint::k16 || filter == Filter::kLut;
  const bool nearest = lut && LookupOf(job.options) == Lookup::kNearest;
  const TapPolynomials taps(filter, ParameterOf(job.options));
  const Table* table = job.options.table;
  PixelRow r;
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    for (int x = pixels.x0; x < pixels.x1; x += kRowPixels) {
      r.count = std::min(kRowPixels, pixels.x1 - x);
      r.padded = (r.count + kLanes - 1) / kLanes * kLanes;
      SplitRow<kFootprint>(job, x, y, r);
      PrefetchNext(job, x, y, r);
      if (nearest) {
        FindNodes(r);
      } else if (lut) {
        BlendNodes<kFootprint>(*table, r);
      } else {
        ComputeWeights(taps, r);
      }
      SumRow<kFootprint>(job.history, nearest ? table->data() : r.weights, r);
      StoreRow(job, x, y, r);
    }
  }
}

inline void General(const WarpJob& job, const TileRect& pixels) {
  switch (FootprintOf(job.options)) {
    case Footprint::k16:
      return GeneralPixels<Footprint::k16>(job, pixels);
    case Footprint::k24:
      return GeneralPixels<Footprint::k24>(job, pixels);
    case Footprint::k36:
      return GeneralPixels<Footprint::k36>(job, pixels);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
