// The parts of a build of the runtime. `warplut profile` writes one as PIPELINE.h for a content;
// docs/CONFIGURE.md shows how to compile with it.
//
// A header of one's own defines warplut::kPipeline and nothing else:
//
//   #include "runtime/pipeline_configuration.h"
//   namespace warplut {
//   inline constexpr PipelineConfiguration kPipeline = {
//       .interpolation = false,
//       .extrapolation = false,
//       .reference = false,
//       .filter = Filter::kCatmullRom,
//       .sr = {.form = HistoryForm::kSample, .clamp = ColorClamp::kNone},
//   };
//   }  // namespace warplut
//
// A choice without a value is made at run time, by the options. A choice with a value is the only
// one that is compiled: the options start with it, and their IsValid refuses another. The images
// are those of the full runtime with the same options, to the bit.
#pragma once

#include <cstdint>
#include <optional>

#include "luts/table.h"
#include "luts/visibility.h"
#include "runtime/choices.h"
#include "runtime/color_encoding.h"
#include "runtime/filter.h"
#include "runtime/gates.h"
#include "runtime/image_view.h"

namespace WARPLUT_PUBLIC warplut {

// Choices of SuperResolutionOptions, by the same names, and formats of the frames.
struct SuperResolutionConfiguration {
  std::optional<HistoryForm> form = {};
  std::optional<bool> history = {};
  std::optional<ColorClamp> clamp = {};
  std::optional<DepthMeasure> depth = {};
  std::optional<MotionUpsampling> motion = {};
  std::optional<bool> motion_filter = {};
  std::optional<CurrentFrame> current = {};
  std::optional<PixelFormat> history_format = {};
  std::optional<PixelFormat> color_format = {};   // of RenderedFrame::color
  std::optional<PixelFormat> output_format = {};  // of the output
  std::optional<ColorEncoding> encoding = {};
};

// Choices of FrameGenerationOptions, by the same names, and formats of the frames.
struct FrameGenerationConfiguration {
  std::optional<MotionModel> motion_model = {};
  std::optional<bool> splat = {};
  std::optional<bool> refine = {};
  std::optional<DisocclusionFill> fill = {};
  std::optional<DepthMeasure> depth = {};
  std::optional<bool> brightness_gate = {};
  std::optional<bool> motion_filter = {};
  std::optional<PixelFormat> color_format = {};   // of DisplayedFrame::color, both frames
  std::optional<PixelFormat> output_format = {};  // of the output
  std::optional<ColorEncoding> encoding = {};
};

struct PipelineConfiguration {
  bool super_resolution = true;  // SuperResolution is there
  bool interpolation = true;     // FrameGeneration::Interpolate
  bool extrapolation = true;     // FrameGeneration::Extrapolate
  bool reference = true;         // the plain version of every pass (options.reference)
  bool peers = true;             // other systems (runtime/peers.h)

  // WarpOptions::filter and ::lookup of every warp.
  std::optional<Filter> filter = {};
  std::optional<Lookup> lookup = {};

  SuperResolutionConfiguration sr = {};
  FrameGenerationConfiguration generation = {};
};

// FNV-1a of the members of a configuration, after those of `digest`.
namespace pipeline_digest {

constexpr std::uint64_t Number(bool is_contained) { return is_contained ? 1 : 0; }
template <class T>
constexpr std::uint64_t Number(const std::optional<T>& choice) {
  return choice.has_value() ? 1 + static_cast<std::uint64_t>(*choice) : 0;
}

template <class... T>
constexpr std::uint64_t Added(std::uint64_t digest, const T&... members) {
  ((digest = (digest ^ Number(members)) * 0x100000001B3u), ...);
  return digest;
}

}  // namespace pipeline_digest

// A number that tells configurations apart: FNV-1a over all members, in their order.
class PipelineDigest {
 public:
  constexpr explicit PipelineDigest(const PipelineConfiguration& whole) {
    const auto& [super_resolution, interpolation, extrapolation, reference, peers, filter, lookup,
                 sr, generation] = whole;
    value_ = pipeline_digest::Added(value_, super_resolution, interpolation, extrapolation,
                                    reference, peers, filter, lookup);
    AddMembers(sr);
    AddMembers(generation);
  }

  constexpr std::uint64_t value() const { return value_; }

 private:
  constexpr void AddMembers(const SuperResolutionConfiguration& sr) {
    const auto& [form, history, clamp, depth, motion, motion_filter, current, history_format,
                 color_format, output_format, encoding] = sr;
    value_ = pipeline_digest::Added(value_, form, history, clamp, depth, motion, motion_filter,
                                    current, history_format, color_format, output_format, encoding);
  }
  constexpr void AddMembers(const FrameGenerationConfiguration& generation) {
    const auto& [motion_model, splat, refine, fill, depth, brightness_gate, motion_filter,
                 color_format, output_format, encoding] = generation;
    value_ =
        pipeline_digest::Added(value_, motion_model, splat, refine, fill, depth, brightness_gate,
                               motion_filter, color_format, output_format, encoding);
  }
  std::uint64_t value_ = 0xCBF29CE484222325u;
};

}  // namespace warplut
