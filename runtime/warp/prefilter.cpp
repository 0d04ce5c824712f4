#include "runtime/prefilter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/core/band.h"
#include "runtime/core/pixel.h"
#include "runtime/float_environment.h"
#include "runtime/warp/prefilter_kernels.h"

namespace warplut {
namespace {

double PoleOf(const Prefilter& prefilter) {
  return PoleOfSide(static_cast<double>(prefilter.side));
}

// The prefilter of an axis as a sum: tap j of the pixels j to the left and to the right.
std::vector<double> TapsOf(const Prefilter& prefilter) {
  std::vector<double> taps;
  if (prefilter.kind == PrefilterKind::kFir) {
    taps.assign(prefilter.taps.begin(), prefilter.taps.begin() + prefilter.reach + 1);
    taps[0] = 1;
    for (int j = 1; j <= prefilter.reach; ++j) taps[0] -= 2 * taps[j];
    return taps;
  }
  const double z = PoleOf(prefilter);
  for (double tap = (1 - z) / (1 + z); std::abs(tap) > 0x1p-60; tap *= z) taps.push_back(tap);
  return taps;
}

// The sum of taps about pixel i of `size`; `at(i)` gives a pixel of the image.
template <class At>
double SumMirrored(const std::vector<double>& taps, int i, int size, const At& at) {
  double sum = taps[0] * at(i);
  for (int j = 1; j < static_cast<int>(taps.size()); ++j) {
    sum += taps[j] * (at(MirroredPixel(i - j, size)) + at(MirroredPixel(i + j, size)));
  }
  return sum;
}

}  // namespace

int PrefilterReach(const Prefilter& prefilter) {
  const FloatEnvironment environment;
  if (prefilter.kind == PrefilterKind::kFir) return prefilter.reach;
  const double pole = std::abs(PoleOf(prefilter));
  // A recursion has values of up to `gain` times its largest input, so that it starts wrong by
  // 1 + gain at most. Four of them run one after the other.
  const double gain = (1 + pole) / (1 - pole);
  const double wrong = 4 * (1 + gain) * gain * gain * gain;
  const double least = std::log(static_cast<double>(kPrefilterBound) / 2 / wrong) / std::log(pole);
  return std::min(static_cast<int>(std::ceil(least)), kLargestPrefilterReach);
}

PrefilterPass::PrefilterPass(const Prefilter& prefilter, int width, int height, int threads)
    : prefilter_(prefilter) {
  const PrefilterScratch scratch(width, PrefilterReach(prefilter));
  const int bands = TileCount(height, kPrefilterRows);
  for (int i = 0; i < std::min(threads, bands); ++i) {
    scratch_.emplace_back(sizeof(float) * static_cast<std::size_t>(scratch.size), 1);
  }
}

void PrefilterPass::Apply(const ImageView& samples, Executor& executor,
                          const MutableImageView& coefficients) {
  const int reach = PrefilterReach(prefilter_);
  ForEachBand(executor, samples.height, kPrefilterRows, scratch_,
              [&](const Band& band, const RowBuffer& scratch) {
                const PrefilterJob job = {prefilter_, reach, samples, coefficients,
                                          reinterpret_cast<float*>(scratch.data())};
                for (int x = 0; x < samples.width; x += kPrefilterColumns) {
                  const int end = std::min(x + kPrefilterColumns, samples.width);
                  PrefilterTile(job, {x, band.first, end, band.last});
                }
              });
}

void PrefilterReferencePixels(const Prefilter& prefilter, const ImageView& samples,
                              const TileRect& pixels, const MutableImageView& coefficients) {
  const std::vector<double> taps = TapsOf(prefilter);
  const int channels = Channels(samples.format);
  const bool is_half = coefficients.format == PixelFormat::kRgba16F;
  const auto sample = [&](int x, int y, int c) -> double {
    const float value = LoadChannel(samples.format, samples.At(x, y), c);
    return std::abs(value) <= kLargestPrefiltered ? value : 0.0f;
  };
  std::vector<double> row(static_cast<std::size_t>(samples.width));  // filtered along columns
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    for (int c = 0; c < channels; ++c) {
      for (int x = 0; x < samples.width; ++x) {
        row[x] = SumMirrored(taps, y, samples.height, [&](int from) { return sample(x, from, c); });
      }
      for (int x = pixels.x0; x < pixels.x1; ++x) {
        const double sum = SumMirrored(taps, x, samples.width, [&](int from) { return row[from]; });
        const double c_xy = is_half ? std::clamp<double>(sum, -kLargestHalf, kLargestHalf) : sum;
        StoreChannel(coefficients.format, static_cast<float>(c_xy), coefficients.At(x, y), c);
      }
    }
  }
}

void PrefilterPass::Reference(const Prefilter& prefilter, const ImageView& samples,
                              const MutableImageView& coefficients) {
  const FloatEnvironment environment;
  PrefilterReferencePixels(prefilter, samples, {0, 0, samples.width, samples.height}, coefficients);
}

std::size_t PrefilterPass::bytes() const {
  std::size_t sum = 0;
  for (const RowBuffer& scratch : scratch_) sum += scratch.size();
  return sum;
}

}  // namespace warplut
