// The vector kernels behind Warp, chosen at run time for the processor. Input is checked before.
#pragma once

#include <optional>

#include "runtime/core/strict_math.h"
#include "runtime/motion_tiles.h"
#include "runtime/prefilter.h"
#include "runtime/warp.h"

namespace warplut {

// What the options come to in this build (runtime/pipeline.h).
constexpr Filter FilterOf(const WarpOptions& options) {
  return Choose(kPipeline.filter, options.filter);
}
constexpr Lookup LookupOf(const WarpOptions& options) {
  return Choose(kPipeline.lookup, options.lookup);
}

// The only format of what is summed, samples and coefficients.
constexpr std::optional<PixelFormat> SummedFormat() {
  if (!kWarpedFormat.has_value() || !kContainsPrefilter) return kWarpedFormat;
  const bool same = CoefficientFormat(*kWarpedFormat) == *kWarpedFormat;
  return same ? kWarpedFormat : std::nullopt;
}
inline constexpr std::optional<PixelFormat> kSummedFormat = SummedFormat();

// The parameter of the options' filter, as FilterTaps takes it.
constexpr float ParameterOf(const WarpOptions& options) {
  return FilterOf(options) == Filter::kSpline ? options.spline_k : options.keys_a;
}

// `history` is what is summed: the samples, or their coefficients if IsPrefiltered.
struct WarpJob {
  WarpJob(const ImageView& image, const MotionView& vectors, const WarpOptions& chosen,
          const MutableImageView& warped)
      : history(image), samples(image), motion(vectors), options(chosen), out(warped) {}
  WarpJob(const PrefilteredImage& image, const MotionView& vectors, const WarpOptions& chosen,
          const MutableImageView& warped)
      : history(image.coefficients),
        samples(image.samples),
        motion(vectors),
        options(chosen),
        out(warped),
        prefiltered_(true) {}

  // The same with formats that are constants where the build contains one alone.
  WarpJob InFormats() const {
    WarpJob job = *this;
    job.history = InFormat(kSummedFormat, history);
    job.samples = InFormat(kWarpedFormat, samples);
    job.out = InFormat(kWarpedFormat, out);
    return job;
  }

  bool IsPrefiltered() const { return kContainsPrefilter && prefiltered_; }

  ImageView history;
  ImageView samples;
  MotionView motion;
  const WarpOptions& options;
  MutableImageView out;

 private:
  bool prefiltered_ = false;
};

// The formula, one pixel after the other.
void WarpReferencePixels(const WarpJob& job, const TileRect& pixels);

// Whether all motion of the pixels equals that of the first one; a NaN equals nothing.
bool IsUniform(const MotionView& motion, const TileRect& pixels);

// Each pixel has its own weights.
void WarpGeneral(const WarpJob& job, const TileRect& pixels);

// All pixels have the motion (mx, my), which is finite and not whole in both axes.
void WarpUniform(const WarpJob& job, const TileRect& pixels, float mx, float my);

}  // namespace warplut
