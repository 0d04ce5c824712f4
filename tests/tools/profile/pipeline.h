// A golden file of tests/tools/profile/header_test.cpp.
//
// Every choice has a value.
// clang-format off
#pragma once

#include "runtime/pipeline_configuration.h"

namespace warplut {

inline constexpr PipelineConfiguration kPipeline = {
    .extrapolation = false,
    .reference = false,
    .peers = false,
    .filter = Filter::kCatmullRom,
    .lookup = Lookup::kNearest,
    .sr = {
        .form = HistoryForm::kSample,
        .history = true,
        .clamp = ColorClamp::kVariance,
        .depth = DepthMeasure::kRelative,
        .motion = MotionUpsampling::kEdgeAware,
        .motion_filter = false,
        .current = CurrentFrame::kBilinear,
        .history_format = PixelFormat::kRgba16F,
        .color_format = PixelFormat::kRgba8,
        .output_format = PixelFormat::kRgba32F,
        .encoding = ColorEncoding::kLinearHdr,
    },
    .generation = {
        .motion_model = MotionModel::kQuadratic,
        .splat = true,
        .refine = false,
        .fill = DisocclusionFill::kOwnMotion,
        .depth = DepthMeasure::kNone,
        .brightness_gate = true,
        .motion_filter = false,
        .color_format = PixelFormat::kRgba16F,
        .output_format = PixelFormat::kRgba8,
        .encoding = ColorEncoding::kDisplay,
    },
};

}  // namespace warplut
