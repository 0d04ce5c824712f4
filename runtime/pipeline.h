// kPipeline, the configuration of this build. WARPLUT_PIPELINE_HEADER names the header that defines
// it; all code that includes the runtime is compiled with the same one. Code that is not does not
// link.
#pragma once

#include <cstdint>
#include <optional>

#include "luts/visibility.h"

#ifdef WARPLUT_PIPELINE_HEADER
#include WARPLUT_PIPELINE_HEADER
#else
#include "runtime/full_pipeline.h"
#endif

namespace WARPLUT_PUBLIC warplut {

// The library defines this for the configuration that it is compiled with, and every file that
// includes its headers refers to that of its own: a program that is compiled with another
// PIPELINE.h than the library does not link.
template <std::uint64_t kDigest>
struct LibraryWithPipeline {
  static const char kIsLinked;
};
inline constexpr std::uint64_t kPipelineDigest = PipelineDigest(kPipeline).value();
extern template struct LibraryWithPipeline<kPipelineDigest>;
#if defined(__GNUC__)
#if __has_attribute(retain)
[[gnu::retain]]
#endif
[[gnu::used]]
#endif
static const char* const kLinkedLibrary = &LibraryWithPipeline<kPipelineDigest>::kIsLinked;

// Whether the build contains this value of a choice.
template <class T>
constexpr bool Contains(const std::optional<T>& choice, T value) {
  return !choice.has_value() || *choice == value;
}

// The effective value of a choice: the only one that the build contains, or the one of run time.
template <class T>
constexpr T Choose(const std::optional<T>& choice, T at_run_time) {
  return choice.value_or(at_run_time);
}

// Whether a filter that the build contains may have a prefilter (runtime/prefilter.h).
inline constexpr bool kContainsPrefilter =
    !kPipeline.filter.has_value() || MayHavePrefilter(*kPipeline.filter);

// A view whose format is a constant where the build contains one alone.
template <class View>
constexpr View InFormat(const std::optional<PixelFormat>& choice, View view) {
  view.format = Choose(choice, view.format);
  return view;
}

inline constexpr bool kContainsGeneration = kPipeline.interpolation || kPipeline.extrapolation;
inline constexpr bool kContainsHistory =
    kPipeline.super_resolution && Contains(kPipeline.sr.history, true);

// The only format of the frames that frame generation warps, and of what it blends, if each is one.
constexpr std::optional<PixelFormat> InLinearHdr(const std::optional<ColorEncoding>& encoding,
                                                 const std::optional<PixelFormat>& on_display) {
  if (encoding == ColorEncoding::kLinearHdr) return PixelFormat::kRgba32F;
  return encoding == ColorEncoding::kDisplay ? on_display : std::nullopt;
}
inline constexpr std::optional<PixelFormat> kWarpedFrameFormat =
    InLinearHdr(kPipeline.generation.encoding, kPipeline.generation.color_format);
inline constexpr std::optional<PixelFormat> kBlendedFrameFormat =
    InLinearHdr(kPipeline.generation.encoding, kPipeline.generation.output_format);

// The only format of all that is warped.
constexpr std::optional<PixelFormat> WarpedFormat() {
  const bool history = kContainsHistory && kPipeline.sr.motion != MotionUpsampling::kStatic;
  if (!history) return kContainsGeneration ? kWarpedFrameFormat : std::nullopt;
  const bool same = kPipeline.sr.history_format == kWarpedFrameFormat;
  return same || !kContainsGeneration ? kPipeline.sr.history_format : std::nullopt;
}
inline constexpr std::optional<PixelFormat> kWarpedFormat = WarpedFormat();

}  // namespace warplut
