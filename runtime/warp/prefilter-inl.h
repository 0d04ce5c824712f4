// The kernel of the prefilter pass: a tile at a time, columns first, then rows, in floats.
//
// Both recursions are weighted means, so that a constant stays as it is to the bit:
//
//   g(i) = x(i) + z (g(i - 1) - x(i))     forward
//   c(i) = g(i) + z (c(i + 1) - g(i))     backward
//
// Each starts `reach` pixels outside of the tile, with its first input: what that lacks has decayed
// where the tile begins.
// A FIR is x + the sum of t_j (x(i - j) + x(i + j) - 2 x(i)), with the same property.
//
// The tile lies in scratch rows of blocks of four floats: the channels of a pixel, or one channel
// of four rows. So rows of either are filtered alike, a block a pixel.
#if defined(WARPLUT_RUNTIME_PREFILTER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WARPLUT_RUNTIME_PREFILTER_INL_H_
#undef WARPLUT_RUNTIME_PREFILTER_INL_H_
#else
#define WARPLUT_RUNTIME_PREFILTER_INL_H_
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "runtime/core/warp_simd-inl.h"
#include "runtime/warp/prefilter_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace warplut {
namespace HWY_NAMESPACE {

inline constexpr int kBlock = PrefilterScratch::kBlock;
using BlockTag = hn::FixedTag<float, kBlock>;

// Added to samples and taken from coefficients. A recursion that decays to 0 would pass through
// subnormal numbers, which are slow; one that decays to this does not.
inline constexpr float kFloor = 0x1p-90f;

// Rows of blocks that are filtered at the same time, so that each hides the latency of the others.
inline constexpr int kChains = 8;
static_assert(kPrefilterRows % (kChains * kBlock) == 0);

// Vectors of a row that are filtered along columns at the same time.
inline constexpr int kColumnVectors = 4;
static_assert(kColumnVectors * kLanes <= PrefilterScratch::kColumn);

// kLanes samples as the recursions take them.
template <class T>
HWY_INLINE Floats LoadSamples(const T* from) {
  const FloatTag d;
  const auto floor = hn::Set(d, kFloor);
  if constexpr (std::is_same_v<T, std::uint8_t>) {
    return hn::Add(LoadChannels(from), floor);
  } else {
    Floats x;
    if constexpr (std::is_same_v<T, hwy::float16_t> && !kNativeHalf) {
      alignas(64) float channels[kLanes];
      for (int i = 0; i < kLanes; ++i) channels[i] = LoadChannel(PixelFormat::kRgba16F, from, i);
      x = hn::Load(d, channels);
    } else {
      x = LoadChannels(from);
    }
    const auto counts = hn::Le(hn::Abs(x), hn::Set(d, kLargestPrefiltered));
    return hn::Add(hn::IfThenElseZero(counts, x), floor);
  }
}

// The first `count` samples; the other lanes hold 0.
template <class T>
HWY_INLINE Floats LoadFirstSamples(const T* from, int count) {
  alignas(64) T samples[kLanes] = {};
  std::memcpy(samples, from, sizeof(T) * static_cast<std::size_t>(count));
  return LoadSamples(samples);
}

template <class Tag>
HWY_INLINE hn::Vec<Tag> Recur(Tag, hn::Vec<Tag> pole, hn::Vec<Tag> before, hn::Vec<Tag> input) {
  return hn::MulAdd(pole, hn::Sub(before, input), input);
}

// A tile on its way.
struct PrefilterState {
  const PrefilterJob& job;
  TileRect pixels;
  PrefilterScratch scratch;
  float pole;
  const std::byte* samples[kPrefilterRows + 2 * kLargestPrefilterReach];  // rows, mirrored

  float* Column() const { return job.scratch; }
  float* Row(int row) const { return job.scratch + scratch.column + row * scratch.stride; }
};

// Puts the coefficients, along columns, of kVectors vectors into the column of the tile.
// `load(row, v)` gives the samples, from `reach` rows above the tile on.
template <int kVectors, class Load>
HWY_INLINE void RecurColumns(const PrefilterState& s, int tile_rows, const Load& load) {
  const FloatTag d;
  constexpr int kStep = kVectors * kLanes;
  const int reach = s.job.reach;
  const int last = tile_rows + 2 * reach - 1;
  const auto pole = hn::Set(d, s.pole);
  float* const column = s.Column();
  Floats state[kVectors];
  for (int v = 0; v < kVectors; ++v) state[v] = load(0, v);
  for (int row = 1; row < reach; ++row) {
    for (int v = 0; v < kVectors; ++v) state[v] = Recur(d, pole, state[v], load(row, v));
  }
  for (int row = reach; row <= last; ++row) {
    for (int v = 0; v < kVectors; ++v) {
      state[v] = Recur(d, pole, state[v], load(row, v));
      hn::Store(state[v], d, column + (row - reach) * kStep + v * kLanes);
    }
  }
  for (int row = last - reach - 1; row >= 0; --row) {
    for (int v = 0; v < kVectors; ++v) {
      float* const at = column + row * kStep + v * kLanes;
      state[v] = Recur(d, pole, state[v], hn::Load(d, at));
      hn::Store(state[v], d, at);
    }
  }
}

// x + the sum of the differences; `at(j)` gives the input j pixels away.
template <class At>
HWY_INLINE Floats SumTaps(const Prefilter& prefilter, const At& at) {
  const FloatTag d;
  const auto x = at(0);
  const auto twice = hn::Add(x, x);
  auto sum = x;
  for (int j = 1; j <= prefilter.reach; ++j) {
    const auto bend = hn::Sub(hn::Add(at(-j), at(j)), twice);
    sum = hn::MulAdd(hn::Set(d, prefilter.taps[j]), bend, sum);
  }
  return sum;
}

template <int kVectors, class Load>
HWY_INLINE void SumColumns(const PrefilterState& s, int tile_rows, const Load& load) {
  const FloatTag d;
  constexpr int kStep = kVectors * kLanes;
  const int reach = s.job.reach;
  // The sum of a row takes the place of the row `reach` above, which no sum below reads.
  float* const column = s.Column();
  for (int row = 0; row < tile_rows + 2 * reach; ++row) {
    for (int v = 0; v < kVectors; ++v) {
      hn::Store(load(row, v), d, column + row * kStep + v * kLanes);
    }
  }
  for (int row = 0; row < tile_rows; ++row) {
    for (int v = 0; v < kVectors; ++v) {
      float* const to = column + row * kStep + v * kLanes;
      const auto at = [&](int j) HWY_ATTR { return hn::Load(d, to + (reach + j) * kStep); };
      hn::Store(SumTaps(s.job.prefilter, at), d, to);
    }
  }
}

// Filters kVectors vectors of each row from channel `first` on, which is channel `to` of the
// scratch rows. Unless kWhole, they end with the row, after `count` channels.
template <class T, int kRowsOfBlock, int kVectors, bool kWhole>
HWY_INLINE void FilterColumns(const PrefilterState& s, int tile_rows, int first, int count,
                              int to) {
  const FloatTag d;
  constexpr int kStep = kVectors * kLanes;
  constexpr int kStepBytes = kStep * static_cast<int>(sizeof(T));
  const auto load = [&](int row, int v) HWY_ATTR {
    const T* from = reinterpret_cast<const T*>(s.samples[row]) + first;
    if constexpr (kWhole) {
      if (v == 0) PrefetchBytes(from + kStep, kStepBytes);
      return LoadSamples(from + v * kLanes);
    } else {
      return LoadFirstSamples(from, count);
    }
  };
  if (s.job.prefilter.kind == PrefilterKind::kRecursive) {
    RecurColumns<kVectors>(s, tile_rows, load);
  } else {
    SumColumns<kVectors>(s, tile_rows, load);
  }
  const float* from = s.Column();
  float* row_to = s.Row(0) + to * kRowsOfBlock;
  const std::ptrdiff_t stride = s.scratch.stride;
  for (int row = 0; row < tile_rows; row += kRowsOfBlock) {
    for (int v = 0; v < kStep; v += kLanes) {
      if constexpr (kRowsOfBlock == 1) {
        hn::StoreU(hn::Load(d, from + v), d, row_to + v);
      } else {
        hn::StoreInterleaved4(hn::Load(d, from + v), hn::Load(d, from + v + kStep),
                              hn::Load(d, from + v + 2 * kStep), hn::Load(d, from + v + 3 * kStep),
                              d, row_to + v * kBlock);
      }
    }
    from += kRowsOfBlock * kStep;
    row_to += stride;
  }
}

// Filters the tile along columns, and `reach` columns more at each end.
template <class T, int kRowsOfBlock>
HWY_INLINE void FilterAllColumns(const PrefilterState& s, int tile_rows) {
  constexpr int kChannels = kBlock / kRowsOfBlock;
  constexpr int kStep = kColumnVectors * kLanes;
  const int reach = s.job.reach;
  const int left = s.pixels.x0 - reach;  // pixel of the first block
  const int begin = std::max(left, 0) * kChannels;
  const int end = std::min(s.pixels.x1 + reach, s.job.samples.width) * kChannels;
  const int shift = left * kChannels;
  int i = begin;
  for (; i + kStep <= end; i += kStep) {
    FilterColumns<T, kRowsOfBlock, kColumnVectors, true>(s, tile_rows, i, 0, i - shift);
  }
  for (; i < end; i += kLanes) {
    FilterColumns<T, kRowsOfBlock, 1, false>(s, tile_rows, i, std::min(kLanes, end - i), i - shift);
  }
}

// Fills the blocks beyond the image's edges.
HWY_INLINE void MirrorBlocks(const PrefilterState& s, int rows) {
  const int left = s.pixels.x0 - s.job.reach;
  const int width = s.job.samples.width;
  const auto mirror = [&](int begin, int end) {
    for (int x = begin; x < end; ++x) {
      const int from = MirroredPixel(x, width);
      for (int row = 0; row < rows; ++row) {
        std::memcpy(s.Row(row) + (x - left) * kBlock, s.Row(row) + (from - left) * kBlock,
                    sizeof(float) * kBlock);
      }
    }
  };
  mirror(left, 0);
  mirror(width, s.pixels.x1 + s.job.reach);
}

// Filters kChains rows in place, from block `reach` on.
HWY_INLINE void RecurRows(const PrefilterState& s, int first_row) {
  const BlockTag d;
  const int reach = s.job.reach;
  const int last = s.pixels.width() + 2 * reach - 1;
  const auto pole = hn::Set(d, s.pole);
  float* const rows = s.Row(first_row);
  const std::ptrdiff_t stride = s.scratch.stride;
  hn::Vec<BlockTag> state[kChains];
  for (int r = 0; r < kChains; ++r) state[r] = hn::Load(d, rows + r * stride);
  for (int x = 1; x <= last; ++x) {
    for (int r = 0; r < kChains; ++r) {
      float* const at = rows + r * stride + x * kBlock;
      state[r] = Recur(d, pole, state[r], hn::Load(d, at));
      hn::Store(state[r], d, at);
    }
  }
  for (int x = last - 1; x >= reach; --x) {
    for (int r = 0; r < kChains; ++r) {
      float* const at = rows + r * stride + x * kBlock;
      state[r] = Recur(d, pole, state[r], hn::Load(d, at));
      hn::Store(state[r], d, at);
    }
  }
}

// Filters a row in place: the sum of a block takes the place of the block `reach` before, so that
// the row begins there.
HWY_INLINE void SumRow(const PrefilterState& s, int row) {
  const FloatTag d;
  const int reach = s.job.reach;
  float* const blocks = s.Row(row);
  for (int i = 0; i < s.pixels.width() * kBlock; i += kLanes) {
    const auto at = [&](int j) HWY_ATTR { return hn::LoadU(d, blocks + i + (reach + j) * kBlock); };
    hn::StoreU(SumTaps(s.job.prefilter, at), d, blocks + i);
  }
}

// kLanes coefficients; those that the format cannot hold are limited.
HWY_INLINE Floats Coefficients(PixelFormat format, Floats sums) {
  const FloatTag d;
  const auto c = hn::Sub(sums, hn::Set(d, kFloor));
  if (format != PixelFormat::kRgba16F) return c;
  const auto largest = hn::Set(d, kLargestHalf);
  return hn::Min(hn::Max(c, hn::Neg(largest)), largest);
}

// Writes `count` channels of one row of coefficients; may change the floats at `from`.
HWY_INLINE void StoreCoefficients(PixelFormat format, float* HWY_RESTRICT from, int count,
                                  std::byte* HWY_RESTRICT to) {
  const FloatTag d;
  const int bytes = BytesPerPixel(format) / Channels(format);
  for (int i = 0; i < count; i += kLanes) {
    const auto c = Coefficients(format, hn::LoadU(d, from + i));
    if constexpr (kNativeHalf) {
      if (i + kLanes <= count && format == PixelFormat::kRgba16F) {
        const hn::Rebind<hwy::float16_t, FloatTag> d16;
        hn::StoreU(hn::DemoteTo(d16, c), d16, reinterpret_cast<hwy::float16_t*>(to) + i);
        continue;
      }
    }
    alignas(64) float channels[kLanes];
    hn::Store(c, d, channels);
    StoreChannels(format, channels, std::min(kLanes, count - i), to + i * bytes);
  }
}

template <int kRowsOfBlock>
HWY_INLINE void StoreTile(const PrefilterState& s) {
  const FloatTag d;
  const bool recursive = s.job.prefilter.kind == PrefilterKind::kRecursive;
  const int first = recursive ? s.job.reach * kBlock : 0;
  const MutableImageView& out = s.job.coefficients;
  const TileRect& pixels = s.pixels;
  const auto to = [&](int y) { return static_cast<std::byte*>(out.At(pixels.x0, y)); };
  for (int y = pixels.y0; y < pixels.y1; y += kRowsOfBlock) {
    float* const row = s.Row((y - pixels.y0) / kRowsOfBlock) + first;
    if constexpr (kRowsOfBlock == 1) {
      StoreCoefficients(out.format, row, pixels.width() * kBlock, to(y));
    } else {
      for (int x = 0; x < pixels.width(); x += kLanes) {
        Floats c[kBlock];
        hn::LoadInterleaved4(d, row + x * kBlock, c[0], c[1], c[2], c[3]);
        alignas(64) float channels[kLanes];
        for (int i = 0; i < std::min(kBlock, pixels.y1 - y); ++i) {
          hn::Store(c[i], d, channels);
          StoreCoefficients(out.format, channels, std::min(kLanes, pixels.width() - x),
                            to(y + i) + x * static_cast<int>(sizeof(float)));
        }
      }
    }
  }
}

template <class T, int kRowsOfBlock>
HWY_NOINLINE void FilterTileOf(PrefilterState& s) {
  // Rows beyond the tile, so that all chains are full.
  constexpr int kFull = kChains * kRowsOfBlock;
  const int tile_rows = (s.pixels.height() + kFull - 1) / kFull * kFull;
  const int reach = s.job.reach;
  for (int row = 0; row < tile_rows + 2 * reach; ++row) {
    const int y = MirroredPixel(s.pixels.y0 - reach + row, s.job.samples.height);
    s.samples[row] = s.job.samples.Row<std::byte>(y);
  }
  FilterAllColumns<T, kRowsOfBlock>(s, tile_rows);
  const int rows = tile_rows / kRowsOfBlock;
  MirrorBlocks(s, rows);
  if (s.job.prefilter.kind == PrefilterKind::kRecursive) {
    for (int row = 0; row < rows; row += kChains) RecurRows(s, row);
  } else {
    for (int row = 0; row < rows; ++row) SumRow(s, row);
  }
  StoreTile<kRowsOfBlock>(s);
}

inline void FilterTile(const PrefilterJob& job, const TileRect& pixels) {
  PrefilterState s = {.job = job,
                      .pixels = pixels,
                      .scratch = PrefilterScratch(job.samples.width, job.reach),
                      .pole = static_cast<float>(PoleOfSide(job.prefilter.side)),
                      .samples = {}};
  switch (job.samples.format) {
    case PixelFormat::kRgba8:
      FilterTileOf<std::uint8_t, 1>(s);
      break;
    case PixelFormat::kRgba16F:
      FilterTileOf<hwy::float16_t, 1>(s);
      break;
    case PixelFormat::kRgba32F:
      FilterTileOf<float, 1>(s);
      break;
    case PixelFormat::kR32F:
      FilterTileOf<float, kBlock>(s);
      break;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace warplut
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
