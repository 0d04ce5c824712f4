// Configurations of one content each, as PIPELINE.h would have them.
#pragma once

#include <array>

#include "runtime/pipeline_configuration.h"

namespace warplut {

// Super resolution alone, in its plainest form with motion.
inline constexpr PipelineConfiguration kSampleConfiguration = {
    .interpolation = false,
    .extrapolation = false,
    .reference = false,
    .peers = false,
    .filter = Filter::kCatmullRom,
    .sr = {.form = HistoryForm::kSample,
           .history = true,
           .clamp = ColorClamp::kNone,
           .depth = DepthMeasure::kRelative,
           .motion = MotionUpsampling::kNearest,
           .motion_filter = false,
           .current = CurrentFrame::kBilinear,
           .history_format = PixelFormat::kRgba8,
           .color_format = PixelFormat::kRgba8,
           .output_format = PixelFormat::kRgba8,
           .encoding = ColorEncoding::kDisplay}};

// Interpolation alone.
inline constexpr PipelineConfiguration kInterpolationConfiguration = {
    .super_resolution = false,
    .extrapolation = false,
    .reference = false,
    .peers = false,
    .filter = Filter::kBilinear,
    .generation = {.motion_model = MotionModel::kLinear,
                   .splat = true,
                   .refine = false,
                   .fill = DisocclusionFill::kBackground,
                   .depth = DepthMeasure::kRelative,
                   .brightness_gate = false,
                   .motion_filter = false,
                   .color_format = PixelFormat::kRgba8,
                   .output_format = PixelFormat::kRgba8,
                   .encoding = ColorEncoding::kDisplay}};

// Super resolution of a scene and a camera that stand still.
inline constexpr PipelineConfiguration kStaticConfiguration = {
    .interpolation = false,
    .extrapolation = false,
    .reference = false,
    .peers = false,
    .filter = Filter::kCatmullRom,
    .sr = {.form = HistoryForm::kResidual,
           .history = true,
           .clamp = ColorClamp::kNone,
           .depth = DepthMeasure::kNone,
           .motion = MotionUpsampling::kStatic,
           .motion_filter = false,
           .current = CurrentFrame::kBilinear,
           .history_format = PixelFormat::kRgba16F,
           .color_format = PixelFormat::kRgba8,
           .output_format = PixelFormat::kRgba8,
           .encoding = ColorEncoding::kDisplay}};

struct NamedConfiguration {
  const char* name;
  PipelineConfiguration configuration;
};
inline constexpr std::array<NamedConfiguration, 4> kConfigurations = {{
    {"full", {}},
    {"sample", kSampleConfiguration},
    {"interpolation", kInterpolationConfiguration},
    {"static", kStaticConfiguration},
}};

}  // namespace warplut
