// The prefilter pass: an image's samples -> the coefficients that a filter with prefilter weighs.
//
//   c = P x      P along rows and along columns, as luts/prefilter.h defines it, each channel alone
//
// The tap t_0 of a FIR is what makes the sum of its taps 1, exactly.
//
// The image is continued beyond its edges by mirroring, and c is mirrored alike: a warp that clamps
// texel coordinates by at most one reads the right coefficients.
//
// Subnormals are flushed to zero (runtime/float_environment.h). All coefficients are finite. A
// channel beyond kLargestPrefiltered, or not a number, counts as 0,
// here and only here: it does not spread, and a whole-pixel warp still copies it. Coefficients in
// RGBA16F are limited to the largest half.
#pragma once

#include <cstddef>
#include <vector>

#include "luts/prefilter.h"
#include "luts/visibility.h"
#include "runtime/executor.h"
#include "runtime/image_buffer.h"
#include "runtime/image_view.h"

namespace WARPLUT_PUBLIC warplut {

// Pixels of a tile of the fast pass. Each tile is filtered alone, with PrefilterReach more pixels
// on each side.
inline constexpr int kPrefilterColumns = 256;
inline constexpr int kPrefilterRows = 64;

// How many pixels to each side a coefficient is made of. What a recursion leaves out beyond them is
// less than kPrefilterBound / 2 of the largest sample. At most kLargestPrefilterReach.
int PrefilterReach(const Prefilter& prefilter);
inline constexpr int kLargestPrefilterReach = 32;

// The image continued beyond its edges: the pixel, of `size`, that stands for pixel i.
constexpr int MirroredPixel(int i, int size) {
  const int period = 2 * size;
  const int in_period = (i % period + period) % period;
  return in_period < size ? in_period : period - 1 - in_period;
}

// The format of the coefficients of samples in `format`: they overshoot the range of the samples.
// Those of RGBA8 are code values in RGBA16F; the float formats keep theirs.
constexpr PixelFormat CoefficientFormat(PixelFormat format) {
  return format == PixelFormat::kRgba8 ? PixelFormat::kRgba16F : format;
}

// The largest difference of Apply from Reference, relative to the largest |sample| of the image, or
// kPrefilterFloor if that is more. In RGBA16F one unit of the result's last place comes on top.
inline constexpr float kPrefilterBound = 0x1p-15f;
inline constexpr float kPrefilterFloor = 0x1p-108f;

// The largest |sample| that is filtered: the coefficients of larger ones could overflow.
inline constexpr float kLargestPrefiltered = 0x1p118f;

class PrefilterPass {
 public:
  // For images of this size; `prefilter` is valid and not none. Allocates all that Apply needs with
  // an executor of so many threads.
  PrefilterPass(const Prefilter& prefilter, int width, int height, int threads);

  // Writes the coefficients, in CoefficientFormat of the samples' format; they overlap nothing.
  // Any size from 1 x 1. The same bits for any executor; nothing is allocated where there are
  // vectors. A constant image stays as it is, to the bit, from 2^-60 up.
  void Apply(const ImageView& samples, Executor& executor, const MutableImageView& coefficients);

  // The slow, obvious version: the sum of all pixels, in double.
  static void Reference(const Prefilter& prefilter, const ImageView& samples,
                        const MutableImageView& coefficients);

  std::size_t bytes() const;

 private:
  Prefilter prefilter_;
  std::vector<RowBuffer> scratch_;  // one for each thread
};

}  // namespace warplut
