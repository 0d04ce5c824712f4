// The vector kernel behind PrefilterPass, chosen at run time for the processor. Input is checked
// before.
#pragma once

#include <algorithm>
#include <cstddef>

#include "luts/contract.h"
#include "luts/prefilter.h"
#include "runtime/core/instruction_sets.h"
#include "runtime/image_view.h"
#include "runtime/motion_tiles.h"
#include "runtime/prefilter.h"

namespace warplut {

struct PrefilterJob {
  const Prefilter& prefilter;
  int reach;  // PrefilterReach
  ImageView samples;
  MutableImageView coefficients;
  float* scratch;  // of PrefilterScratch, aligned to kRowAlignment
};

// Writes the coefficients of at most kPrefilterColumns x kPrefilterRows pixels.
void PrefilterTile(const PrefilterJob& job, const TileRect& pixels);

// The same for any pixels, in double, without scratch: PrefilterPass::Reference.
void PrefilterReferencePixels(const Prefilter& prefilter, const ImageView& samples,
                              const TileRect& pixels, const MutableImageView& coefficients);

// The largest finite RGBA16F channel; what the coefficients of the format are limited to.
inline constexpr float kLargestHalf = 65504;

// Where a tile lies while it is filtered, in floats.
struct PrefilterScratch {
  static constexpr int kBlock = 4;  // the channels of a pixel, or one of four rows
  static constexpr int kColumn =
      4 * kLargestLanes;  // the most floats of a row that go through together
  static constexpr int kLine = 64 / sizeof(float);

  // For a tile of an image of this width.
  PrefilterScratch(int width, int reach)
      : column((kPrefilterRows + 2 * reach) * kColumn),
        stride(Lines((std::min(width, kPrefilterColumns) + 2 * reach + kLargestLanes) * kBlock) *
               kLine),
        size(column + kPrefilterRows * stride) {}

  int column;  // of the part that holds columns; rows of blocks follow
  int stride;  // of these rows
  int size;

 private:
  // An odd number, so that rows do not compete for the same lines of a cache.
  static constexpr int Lines(int floats) { return ((floats + kLine - 1) / kLine) | 1; }
};

}  // namespace warplut
