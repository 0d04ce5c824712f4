#include "runtime/warp.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "runtime/float_environment.h"
#include "runtime/motion/motion_split.h"
#include "runtime/warp/warp_kernels.h"

namespace warplut {
namespace {

bool Refuse(const char* reason, const char** why) {
  if (why != nullptr) *why = reason;
  return false;
}

// Copies the samples from `whole` texels away, coordinates clamped.
void CopyPixels(const WarpJob& job, const TileRect& pixels, int whole_x, int whole_y) {
  const ImageView& samples = job.samples;
  const int bytes = BytesPerPixel(samples.format);
  // Pixels [begin, end) have their texel inside the image; the others repeat a border texel.
  const int begin = std::clamp(-whole_x, pixels.x0, pixels.x1);
  const int end = std::clamp(samples.width - whole_x, begin, pixels.x1);
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    const int from_y = std::clamp(y + whole_y, 0, samples.height - 1);
    const auto copy = [&](int x, int from_x, int count) {
      std::memcpy(job.out.At(x, y), samples.At(from_x, from_y),
                  static_cast<std::size_t>(count) * bytes);
    };
    for (int x = pixels.x0; x < begin; ++x) copy(x, 0, 1);
    if (begin < end) copy(begin, begin + whole_x, end - begin);
    for (int x = end; x < pixels.x1; ++x) copy(x, samples.width - 1, 1);
  }
}

// Tiles of one row that are warped together: neighbours of one kind and, unless general, of one
// motion.
struct Run {
  TileRect pixels{};
  TileMotion motion;

  bool Takes(const TileRect& tile, const TileMotion& other) const {
    if (pixels.width() == 0) return true;
    if (pixels.x1 != tile.x0 || motion.kind != other.kind) return false;
    return motion.kind == MotionKind::kGeneral || (motion.x == other.x && motion.y == other.y);
  }
};

void WarpRun(const WarpJob& job, const Run& run) {
  const auto& [kind, mx, my] = run.motion;
  switch (kind) {
    case MotionKind::kStatic:
    case MotionKind::kWhole:
      CopyPixels(job, run.pixels, SplitMotion(mx).whole, SplitMotion(my).whole);
      break;
    case MotionKind::kUniform:
      WarpUniform(job, run.pixels, mx, my);
      break;
    case MotionKind::kGeneral:
      WarpGeneral(job, run.pixels);
      break;
  }
}

// Warps the tile rows [first, last); `motion_of(column, row)` classifies a tile.
template <class MotionOf>
WarpStats WarpTileRows(const WarpJob& job, int first, int last, const MotionOf& motion_of) {
  const FloatEnvironment environment;
  WarpStats stats;
  const int columns = TileCount(job.out.width, kTileWidth);
  for (int row = first; row < last; ++row) {
    Run run;
    for (int column = 0; column < columns; ++column) {
      const TileRect tile = TileAt(column, row, job.out.width, job.out.height);
      const TileMotion motion = job.options.general_only ? TileMotion{} : motion_of(column, row);
      ++stats.tiles[static_cast<int>(motion.kind)];
      if (!run.Takes(tile, motion)) {
        WarpRun(job, run);
        run = {};
      }
      if (run.pixels.width() == 0) run = {tile, motion};
      run.pixels.x1 = tile.x1;
    }
    WarpRun(job, run);
  }
  return stats;
}

template <class Image>
WarpStats WarpImageRows(const Image& history, const MotionView& motion, const WarpOptions& options,
                        int first_row, int last_row, const MutableImageView& out) {
  // A view that ends at last_row: its last tiles may be smaller.
  MutableImageView rows = out;
  rows.height = last_row;
  return WarpTileRows({history, motion, options, rows}, first_row / kTileHeight,
                      TileCount(last_row, kTileHeight), [&](int column, int row) {
                        return ClassifyTile(motion, TileAt(column, row, out.width, last_row));
                      });
}

}  // namespace

bool WarpOptions::IsValid(const char** why) const {
  const FilterInfo& info = Info(filter);
  if (info.needs_a && !(keys_a >= -1.0f && keys_a <= 0.0f)) {
    return Refuse("keys_a is outside of [-1, 0]", why);
  }
  if (info.needs_k && !(spline_k >= kLeastSplineK && spline_k <= kLargestSplineK)) {
    return Refuse("spline_k is outside of [-0.1, 0.06]", why);
  }
  if (info.needs_table && table == nullptr) return Refuse("the lut filter has no table", why);
  if (!Contains(kPipeline.filter, filter)) return Refuse("this build contains another filter", why);
  if (info.needs_table && !Contains(kPipeline.lookup, lookup)) {
    return Refuse("this build contains another lookup", why);
  }
  return true;
}

bool IsWarpable(const ImageView& history, const MotionView& motion, const MutableImageView& out,
                const char** why) {
  if (history.data == nullptr || motion.xy == nullptr || out.data == nullptr) {
    return Refuse("history, motion or output has no data", why);
  }
  const int width = history.width;
  const int height = history.height;
  if (width < 1 || height < 1) return Refuse("the history is empty", why);
  if (width > kLargestSize || height > kLargestSize) {
    return Refuse("the history is larger than kLargestSize", why);
  }
  if (motion.width != width || motion.height != height) {
    return Refuse("motion and history differ in size", why);
  }
  if (out.width != width || out.height != height) {
    return Refuse("output and history differ in size", why);
  }
  if (out.format != history.format) return Refuse("output and history differ in format", why);
  const std::ptrdiff_t row = std::ptrdiff_t{width} * BytesPerPixel(history.format);
  const std::ptrdiff_t channel = BytesPerPixel(history.format) / Channels(history.format);
  if (!Contains(kWarpedFormat, history.format)) {
    return Refuse("this build warps images of another format", why);
  }
  if (history.stride < row || out.stride < row) {
    return Refuse("the stride of history or output is less than a row", why);
  }
  if (history.stride % channel != 0 || out.stride % channel != 0) {
    return Refuse("the stride of history or output is not whole channels", why);
  }
  if (motion.stride < std::ptrdiff_t{width} * 2 * static_cast<std::ptrdiff_t>(sizeof(float)) ||
      motion.stride % static_cast<std::ptrdiff_t>(sizeof(float)) != 0) {
    return Refuse("the stride of the motion is less than a row or not whole floats", why);
  }
  return true;
}

bool IsWarpable(const PrefilteredImage& history, const MotionView& motion,
                const MutableImageView& out, const char** why) {
  const ImageView& samples = history.samples;
  const ImageView& coefficients = history.coefficients;
  if (!IsWarpable(samples, motion, out, why)) return false;
  if (coefficients.data == nullptr) return Refuse("the coefficients have no data", why);
  if (coefficients.width != samples.width || coefficients.height != samples.height) {
    return Refuse("coefficients and samples differ in size", why);
  }
  if (coefficients.format != CoefficientFormat(samples.format)) {
    return Refuse("the coefficients are not in the format of those of the samples", why);
  }
  const std::ptrdiff_t pixel = BytesPerPixel(coefficients.format);
  if (coefficients.stride < samples.width * pixel) {
    return Refuse("the stride of the coefficients is less than a row", why);
  }
  if (coefficients.stride % (pixel / Channels(coefficients.format)) != 0) {
    return Refuse("the stride of the coefficients is not whole channels", why);
  }
  return true;
}

Prefilter PrefilterOf(const WarpOptions& options) {
  const FloatEnvironment environment;
  switch (FilterOf(options)) {
    case Filter::kLut:
      return options.table->prefilter();
    case Filter::kSpline:
      return {.kind = PrefilterKind::kRecursive, .side = SplineSide(options.spline_k)};
    case Filter::kBilinear:
    case Filter::kCatmullRom:
    case Filter::kKeys:
      break;
  }
  return {};
}

Footprint FootprintOf(const WarpOptions& options) {
  return FilterOf(options) == Filter::kLut ? options.table->footprint() : Footprint::k16;
}

WarpStats Warp(const ImageView& history, const MotionView& motion, const WarpOptions& options,
               const MutableImageView& out) {
  return WarpRows(history, motion, options, 0, out.height, out);
}

WarpStats Warp(const PrefilteredImage& history, const MotionView& motion,
               const WarpOptions& options, const MutableImageView& out) {
  return WarpRows(history, motion, options, 0, out.height, out);
}

WarpStats Warp(const ImageView& history, const MotionView& motion, const MotionTiles& tiles,
               const WarpOptions& options, const MutableImageView& out) {
  return WarpTileRows({history, motion, options, out}, 0, tiles.rows(),
                      [&](int column, int row) { return tiles.At(column, row); });
}

WarpStats WarpRows(const ImageView& history, const MotionView& motion, const WarpOptions& options,
                   int first_row, int last_row, const MutableImageView& out) {
  return WarpImageRows(history, motion, options, first_row, last_row, out);
}

WarpStats WarpRows(const PrefilteredImage& history, const MotionView& motion,
                   const WarpOptions& options, int first_row, int last_row,
                   const MutableImageView& out) {
  return WarpImageRows(history, motion, options, first_row, last_row, out);
}

}  // namespace warplut
