// Warping: every output pixel p takes the history at p - m(p).
//
//   out(p) = sum over taps k of w_k(d) * history(t + (TapX(k), TapY(k))),   p - m(p) = t + d,   d
//                                                                           in [0, 1)^2
//
// with the weights w and the taps of the chosen filter (FootprintOf), clamped texel coordinates at
// the borders, and m in pixels of the image, from history to now (x right, y down). A NaN or
// infinite component of m counts as zero; a position far outside gives the border texel. Where
// d = (0, 0) the texel is copied, bit for bit.
//
// RGBA8 rounds halves up and clamps to [0, 255]; RGBA16F is summed in float and rounded to nearest
// even. Subnormal texels and sums are flushed to zero, but copied where d = (0, 0):
// runtime/float_environment.h.
// Motion, history and output have one size; history and output one format; the output overlaps
// neither input.
//
// A filter with prefilter (PrefilterOf) weighs coefficients (runtime/prefilter.h) in place of the
// history's texels. It takes a PrefilteredImage; an ImageView alone it would blur. A filter without
// prefilter takes an ImageView. Where d = (0, 0) the sample is copied, bit for bit. A position
// beyond the centres of the outermost pixels is moved to them, in each axis: far outside is the
// border sample.
#pragma once

#include <cstdint>

#include "luts/filters.h"
#include "luts/table.h"
#include "luts/visibility.h"
#include "runtime/filter.h"
#include "runtime/image_view.h"
#include "runtime/motion_tiles.h"
#include "runtime/pipeline.h"

namespace WARPLUT_PUBLIC warplut {

// The largest difference of Warp from WarpReference.
// RGBA8: code values; exactly 0 for tables other than f32, without prefilter, with nearest lookup:
// every sum is exact in float.
inline constexpr int kWarpRgba8Bound = 1;
// Float formats: relative to the largest |texel|, or |coefficient|, of the window, or to kWarpFloor
// if that is more, as products may be flushed (RGBA16F: plus one unit of the result's last place).
inline constexpr float kWarpFloatBound = 0x1p-20f;
inline constexpr float kWarpFloor = 0x1p-102f;

// The largest width and height of an image.
inline constexpr int kLargestSize = 1 << 20;

struct WarpOptions {
  Filter filter = kPipeline.filter.value_or(Filter::kCatmullRom);
  float keys_a = static_cast<float>(kCatmullRomA);  // Filter::kKeys: in [-1, 0]
  float spline_k = 0;            // Filter::kSpline: in [kLeastSplineK, kLargestSplineK]
  const Table* table = nullptr;  // Filter::kLut: not null, outlives the call
  Lookup lookup = kPipeline.lookup.value_or(Lookup::kBilinear);
  bool general_only = false;  // do not use what tiles have in common; for tests and benchmarks

  // Whether the options can be used; otherwise *why (if not null) says why not.
  bool IsValid(const char** why) const;
};

// The range of k of Filter::kSpline: sides of 1/15 to 17/75.
inline constexpr float kLeastSplineK = -0.1f;
inline constexpr float kLargestSplineK = 0.06f;

// The prefilter of the options' filter; kind none where it weighs samples.
Prefilter PrefilterOf(const WarpOptions& options);

// An image as a filter with prefilter reads it. Both views have one size; `coefficients` has
// CoefficientFormat of the samples' format.
struct PrefilteredImage {
  ImageView samples;
  ImageView coefficients;
};

// The taps of the options' filter: those of its table, or 16.
Footprint FootprintOf(const WarpOptions& options);

// The weights of the options' filter for an offset in [0, 1)^2.
Weights<float> FilterWeights(const WarpOptions& options, float dx, float dy);

// Whether a warp may be called: sizes, formats, strides and pointers fit; otherwise *why
// (if not null) says why not.
bool IsWarpable(const ImageView& history, const MotionView& motion, const MutableImageView& out,
                const char** why);

// The same for a filter with prefilter. Neither knows the options: PrefilterOf tells which of the
// two a filter takes.
bool IsWarpable(const PrefilteredImage& history, const MotionView& motion,
                const MutableImageView& out, const char** why);

// The formula above, one pixel after the other: slow, obvious. Input is assumed to be checked, as
// for Warp.
void WarpReference(const ImageView& history, const MotionView& motion, const WarpOptions& options,
                   const MutableImageView& out);

// How many tiles of each kind were warped.
struct WarpStats {
  std::int64_t tiles[kMotionKinds] = {};

  std::int64_t operator[](MotionKind kind) const { return tiles[static_cast<int>(kind)]; }
  WarpStats& operator+=(const WarpStats& other) {
    for (int kind = 0; kind < kMotionKinds; ++kind) tiles[kind] += other.tiles[kind];
    return *this;
  }
};

// The same, fast: tiles of whole-pixel motion are copied, tiles of uniform motion share their
// weights, the others look up each pixel. Uses the widest vectors that the processor has, on the
// calling thread. Input is assumed to be checked (IsWarpable, IsValid).
WarpStats Warp(const ImageView& history, const MotionView& motion, const WarpOptions& options,
               const MutableImageView& out);

// The same with the motion classified before, for several images that share one motion (colour,
// depth, ...). `tiles` must be that of `motion`.
WarpStats Warp(const ImageView& history, const MotionView& motion, const MotionTiles& tiles,
               const WarpOptions& options, const MutableImageView& out);

// Rows [first_row, last_row) of the same. Both must be multiples of kTileHeight, or last_row the
// height: then any split of an image into calls, on any threads, gives the same bits as one call.
WarpStats WarpRows(const ImageView& history, const MotionView& motion, const WarpOptions& options,
                   int first_row, int last_row, const MutableImageView& out);

// Warp, WarpRows and WarpReference with a filter that has a prefilter. The output has the samples'
// format.
WarpStats Warp(const PrefilteredImage& history, const MotionView& motion,
               const WarpOptions& options, const MutableImageView& out);
WarpStats WarpRows(const PrefilteredImage& history, const MotionView& motion,
                   const WarpOptions& options, int first_row, int last_row,
                   const MutableImageView& out);
void WarpReference(const PrefilteredImage& history, const MotionView& motion,
                   const WarpOptions& options, const MutableImageView& out);

// The name of the instruction set that Warp runs on here ("AVX3", "AVX2", ...).
const char* WarpTarget();

}  // namespace warplut
