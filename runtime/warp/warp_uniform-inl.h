// The kernel for pixels of one motion: a stencil with one set of weights, vectorised along the row.
//
// The four rows of a strip are summed together, so that each loaded vector serves up to four sums.
// Float texels inside the image are read and written where they are; others, borders clamped, are
// turned into floats first and rounded last.
#if defined(WARPLUT_RUNTIME_WARP_UNIFORM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_WARP_UNIFORM_INL_H_
#undef WARPLUT_RUNTIME_WARP_UNIFORM_INL_H_
#else
#define WARPLUT_RUNTIME_WARP_UNIFORM_INL_H_
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "runtime/core/warp_simd-inl.h"
#include "runtime/motion/motion_split.h"
#include "runtime/warp/warp_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

inline constexpr int kStripWidth = 64;
inline constexpr int kStripHeight = 4;
// Bounds of loops that are unrolled.
inline constexpr int kMostTaps = kWindowTaps;
inline constexpr int kMostRows = kStripHeight + kMostTaps - 1;
inline constexpr int kSumStride = kStripWidth * 4;  // floats

// The texels that a strip reads.
template <Footprint kFootprint>
struct StripWindow {
  static constexpr int kTaps = AxisTaps(kFootprint);
  static constexpr int kFirstTap = FirstAxisTap(kFootprint);
  static constexpr int kWidth = kStripWidth + kTaps - 1;
  static constexpr int kHeight = kStripHeight + kTaps - 1;
  static constexpr int kStride =
      (kWidth * 4 + kLargestLanes - 1) / kLargestLanes * kLargestLanes;  // floats
};

// Converts `count` channels of one row to floats.
HWY_INLINE void ConvertChannels(PixelFormat format, const void* from, int count,
                                float* HWY_RESTRICT to) {
  const FloatTag d;
  // Whole vectors; the last one overlaps the one before.
  const auto convert = [&](const auto* channels) HWY_ATTR {
    for (int i = 0; i + kLanes < count; i += kLanes) {
      hn::StoreU(LoadChannels(channels + i), d, to + i);
    }
    hn::StoreU(LoadChannels(channels + count - kLanes), d, to + count - kLanes);
  };
  const bool is_half = format == PixelFormat::kRgba16F;
  if (count < kLanes || (is_half && !kNativeHalf)) {
    for (int i = 0; i < count; ++i) to[i] = LoadChannel(format, from, i);
  } else if (format == PixelFormat::kRgba8) {
    convert(static_cast<const std::uint8_t*>(from));
  } else if (is_half) {
    if constexpr (kNativeHalf) convert(static_cast<const hwy::float16_t*>(from));
  } else {
    convert(static_cast<const float*>(from));
  }
}

// Converts texels [x0, x0 + count) of row y, coordinates clamped, to floats.
HWY_INLINE void ConvertRow(const ImageView& history, int x0, int y, int count,
                           float* HWY_RESTRICT to) {
  const PixelFormat format = history.format;
  const int channels = Channels(format);
  const int row = std::clamp(y, 0, history.height - 1);
  const int left = std::clamp(-x0, 0, count);  // texels before the image
  const int right = std::clamp(x0 + count - history.width, 0, count);
  const int inside = count - left - right;
  if (inside > 0) {
    ConvertChannels(format, history.At(x0 + left, row), inside * channels, to + left * channels);
  }
  const auto repeat = [&](int begin, int end, int x) {
    for (int i = begin * channels; i < end * channels; ++i) {
      to[i] = LoadChannel(format, history.At(x, row), i % channels);
    }
  };
  repeat(0, left, 0);
  repeat(std::max(left, count - right), count, history.width - 1);
}

// Floats in rows, `stride` floats apart.
template <class Float>
struct FloatRows {
  Float* first;
  std::ptrdiff_t stride;
};

// How SumRows goes over a strip.
struct Walk {
  bool to_left = false;  // from the last vector to the first
  std::ptrdiff_t ahead =
      0;  // prefetches the window's new rows of the strip that many floats ahead; 0: none
};

// sums[r][i] = sum over the taps (kx, ky), counted from the window's first, of their weights times
// window[r + ky][i + kx * kChannels] for all rows r of a strip and i < count, which is rounded up
// to kLanes.
template <Footprint kFootprint, int kChannels>
HWY_INLINE void SumRows(const Weights<float>& weights, const FloatRows<const float>& window,
                        int count, const FloatRows<float>& sums, const Walk& walk) {
  constexpr int kTaps = AxisTaps(kFootprint);
  constexpr int kFirst = FirstAxisTap(kFootprint);
  constexpr int kHeight = StripWindow<kFootprint>::kHeight;
  const FloatTag d;
  hn::Vec<FloatTag> weight[kTaps * kTaps];
  for (int k = 0; k < kTaps * kTaps; ++k) {
    weight[k] = hn::Set(d, weights[TapWeight(kFirst + k % kTaps, kFirst + k / kTaps)]);
  }
  const int vectors = (count + kLanes - 1) / kLanes;
  const int step = walk.to_left ? -kLanes : kLanes;
  int i = walk.to_left ? (vectors - 1) * kLanes : 0;
  for (int v = 0; v < vectors; ++v, i += step) {
    hn::Vec<FloatTag> sum[kStripHeight] = {hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    HWY_UNROLL(kMostTaps)
    for (int kx = 0; kx < kTaps; ++kx) {
      const float* column = window.first + i + kx * kChannels;
      HWY_UNROLL(kMostRows)
      for (int y = 0; y < kHeight; ++y) {
        const auto texels = hn::LoadU(d, column + y * window.stride);
        // Keeps the texels in a register: GCC reads them from memory again for each sum otherwise,
        // and loads take the time.
        std::atomic_signal_fence(std::memory_order_seq_cst);
        HWY_UNROLL(kStripHeight)
        for (int r = 0; r < kStripHeight; ++r) {
          const int ky = y - r;
          if (ky < 0 || ky >= kTaps || !HasTap(kFootprint, kFirst + kx, kFirst + ky)) continue;
          sum[r] = hn::MulAdd(weight[ky * kTaps + kx], texels, sum[r]);
        }
      }
    }
    for (int r = 0; r < kStripHeight; ++r) hn::StoreU(sum[r], d, sums.first + r * sums.stride + i);
    if (walk.ahead == 0) continue;
    for (int y = kTaps - 1; y < kHeight; ++y) {
      hwy::Prefetch(window.first + i + y * window.stride + walk.ahead);
    }
  }
}

// Whether to walk from right to left. Processors compare the low bits of a load's address with
// those of the stores before it, and delay it where they agree, as they do when history and output
// lie alike in their pages. So the loads must run ahead of the stores, to the side on which they
// lie. Speed alone depends on it.
template <Footprint kFootprint, int kChannels>
HWY_INLINE bool LoadsLieLeft(const FloatRows<const float>& window, const FloatRows<float>& sums) {
  constexpr int kCompared = 4096;  // bytes: 12 bits
  // Of a vector's loads.
  constexpr int kMiddle = (AxisTaps(kFootprint) - 1) * kChannels * int{sizeof(float)} / 2;
  int nearest = kCompared;
  for (int y = 0; y < StripWindow<kFootprint>::kHeight; ++y) {
    for (int r = 0; r < kStripHeight; ++r) {
      const auto load = reinterpret_cast<std::uintptr_t>(window.first + y * window.stride);
      const auto store = reinterpret_cast<std::uintptr_t>(sums.first + r * sums.stride);
      const int apart =
          static_cast<int>((load + kMiddle - store + kCompared / 2) % kCompared) - kCompared / 2;
      if (std::abs(apart) < std::abs(nearest)) nearest = apart;
    }
  }
  return nearest < 0;
}

// The first pixels of the strip that SumRows can take from the history to the output as they are:
// their number.
template <Footprint kFootprint>
HWY_INLINE int DirectPixels(const WarpJob& job, const TileRect& strip, int x0, int y0) {
  using Strip = StripWindow<kFootprint>;
  constexpr int kFirst = Strip::kFirstTap;
  const ImageView& history = job.history;
  const bool is_float =
      history.format == PixelFormat::kRgba32F || history.format == PixelFormat::kR32F;
  if (!is_float || strip.height() != kStripHeight) return 0;
  if (y0 + kFirst < 0 || y0 + kFirst + Strip::kHeight > history.height) return 0;
  if (x0 + kFirst < 0) return 0;
  const int inside = std::min(strip.width(), history.width - (x0 + kFirst) - (Strip::kTaps - 1));
  const int pixels = kLanes / Channels(history.format);  // of a vector
  return std::max(inside, 0) / pixels * pixels;
}

template <Footprint kFootprint, int kChannels>
HWY_INLINE void DirectStrip(const WarpJob& job, const TileRect& strip, int x0, int y0, int pixels,
                            const Weights<float>& weights) {
  using Strip = StripWindow<kFootprint>;
  const auto stride = [](const auto& view) {
    return view.stride / static_cast<std::ptrdiff_t>(sizeof(float));
  };
  const ImageView& history = job.history;
  const FloatRows<const float> window = {
      static_cast<const float*>(history.At(x0 + Strip::kFirstTap, y0 + Strip::kFirstTap)),
      stride(history)};
  const FloatRows<float> sums = {static_cast<float*>(job.out.At(strip.x0, strip.y0)),
                                 stride(job.out)};
  const bool below = y0 + Strip::kFirstTap + Strip::kHeight + kStripHeight <= history.height;
  SumRows<kFootprint, kChannels>(weights, window, pixels * kChannels, sums,
                                 {LoadsLieLeft<kFootprint, kChannels>(window, sums),
                                  below ? kStripHeight * window.stride : 0});
}

// Asks for what the strip to the right will need: where it is written, and the rows of its window
// that no strip above has read.
HWY_INLINE void PrefetchNextStrip(const WarpJob& job, const TileRect& strip, int x0, int y0,
                                  int last_tap) {
  const ImageView& history = job.history;
  const int bytes = kStripWidth * BytesPerPixel(history.format);
  const int tx = std::clamp(x0, 0, history.width - 1);
  for (int y = 0; y < strip.height(); ++y) {
    const int ty = std::clamp(y0 + y + last_tap, 0, history.height - 1);
    PrefetchBytes(static_cast<const std::byte*>(history.At(tx, ty)) + bytes, bytes);
    PrefetchBytes(static_cast<const std::byte*>(job.out.At(strip.x0, strip.y0 + y)) + bytes, bytes);
  }
}

// Warps at most kStripWidth x kStripHeight pixels whose upper left one has its tap (0, 0) at texel
// (x0, y0).
template <Footprint kFootprint>
HWY_INLINE void ConvertedStrip(const WarpJob& job, const TileRect& strip, int x0, int y0,
                               const Weights<float>& weights) {
  using Strip = StripWindow<kFootprint>;
  const ImageView& history = job.history;
  const int channels = Channels(history.format);
  const int count = strip.width() * channels;
  // Of the window.
  const int width = (count + kLanes - 1) / kLanes * kLanes / channels + Strip::kTaps - 1;
  PrefetchNextStrip(job, strip, x0, y0, Strip::kFirstTap + Strip::kTaps - 1);
  alignas(64) float window[Strip::kHeight * Strip::kStride];
  alignas(64) float sums[kStripHeight * kSumStride];
  for (int y = 0; y < Strip::kHeight; ++y) {
    ConvertRow(history, x0 + Strip::kFirstTap, y0 + Strip::kFirstTap + y, width,
               window + y * Strip::kStride);
  }
  const FloatRows<const float> rows = {window, Strip::kStride};
  if (channels == 1) {
    SumRows<kFootprint, 1>(weights, rows, count, {sums, kSumStride}, {});
  } else {
    SumRows<kFootprint, 4>(weights, rows, count, {sums, kSumStride}, {});
  }
  for (int y = 0; y < strip.height(); ++y) {
    StoreChannels(job.out.format, sums + y * kSumStride, count, job.out.At(strip.x0, strip.y0 + y));
  }
}

// kFootprint is that of the options.
template <Footprint kFootprint>
HWY_NOINLINE void UniformPixels(const WarpJob& any_format, const TileRect& pixels, float mx,
                                float my) {
  const WarpJob job = any_format.InFormats();
  const MotionSplit split_x = SplitMotion(mx);
  const MotionSplit split_y = SplitMotion(my);
  const ImageView& history = job.history;
  const Weights<float> weights = FilterWeights(job.options, split_x.offset, split_y.offset);
  // Far outside, only border texels are read: any window there is the same.
  const auto first_x = [&](int x) {
    return std::clamp(x + split_x.whole, -2 * kStripWidth, history.width + kStripWidth);
  };
  for (int y = pixels.y0; y < pixels.y1; y += kStripHeight) {
    const int y0 = std::clamp(y + split_y.whole, -2 * kStripHeight, history.height + kStripHeight);
    for (int x = pixels.x0; x < pixels.x1;) {
      const TileRect rest = {x, y, pixels.x1, std::min(y + kStripHeight, pixels.y1)};
      const int direct = DirectPixels<kFootprint>(job, rest, first_x(x), y0);
      if (direct > 0) {
        if (Channels(history.format) == 1) {
          DirectStrip<kFootprint, 1>(job, rest, first_x(x), y0, direct, weights);
        } else {
          DirectStrip<kFootprint, 4>(job, rest, first_x(x), y0, direct, weights);
        }
        x += direct;
        continue;
      }
      TileRect strip = rest;
      strip.x1 = std::min(x + kStripWidth, pixels.x1);
      ConvertedStrip<kFootprint>(job, strip, first_x(x), y0, weights);
      x = strip.x1;
    }
  }
}

// Pixels [begin, end) of [first, last): those whose position is between the outermost texels.
struct InsideRange {
  InsideRange(int whole, int size, int first, int last)
      : begin(std::clamp(-whole, first, last)), end(std::clamp(size - 1 - whole, begin, last)) {}
  int begin, end;
};

// Where positions are moved into a prefiltered image, pixels do not share their weights: the
// general kernel warps them.
inline void Uniform(const WarpJob& job, const TileRect& pixels, float mx, float my) {
  TileRect inside = pixels;
  if (job.IsPrefiltered()) {
    const InsideRange x(SplitMotion(mx).whole, job.history.width, pixels.x0, pixels.x1);
    const InsideRange y(SplitMotion(my).whole, job.history.height, pixels.y0, pixels.y1);
    inside = {x.begin, y.begin, x.end, y.end};
    const TileRect outside[] = {{pixels.x0, pixels.y0, pixels.x1, y.begin},
                                {pixels.x0, y.begin, x.begin, y.end},
                                {x.end, y.begin, pixels.x1, y.end},
                                {pixels.x0, y.end, pixels.x1, pixels.y1}};
    for (const TileRect& rest : outside) {
      if (rest.width() > 0 && rest.height() > 0) WarpGeneral(job, rest);
    }
  }
  switch (FootprintOf(job.options)) {
    case Footprint::k16:
      return UniformPixels<Footprint::k16>(job, inside, mx, my);
    case Footprint::k24:
      return UniformPixels<Footprint::k24>(job, inside, mx, my);
    case Footprint::k36:
      return UniformPixels<Footprint::k36>(job, inside, mx, my);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
