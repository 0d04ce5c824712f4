#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "datasets/file.h"
#include "tools/profile/pipeline_header.h"

namespace warplut {
namespace {

// tests/tools/profile/pipeline.h is what the compiler is given (profile_pipeline_compiles.cpp).
TEST(PipelineHeader, IsTheOneThatCompiles) {
  PipelineConfiguration configuration;
  configuration.extrapolation = false;
  configuration.reference = false;
  configuration.peers = false;
  configuration.filter = Filter::kCatmullRom;
  configuration.lookup = Lookup::kNearest;
  configuration.sr = {.form = HistoryForm::kSample,
                      .history = true,
                      .clamp = ColorClamp::kVariance,
                      .depth = DepthMeasure::kRelative,
                      .motion = MotionUpsampling::kEdgeAware,
                      .motion_filter = false,
                      .current = CurrentFrame::kBilinear,
                      .history_format = PixelFormat::kRgba16F,
                      .color_format = PixelFormat::kRgba8,
                      .output_format = PixelFormat::kRgba32F,
                      .encoding = ColorEncoding::kLinearHdr};
  configuration.generation = {.motion_model = MotionModel::kQuadratic,
                              .splat = true,
                              .refine = false,
                              .fill = DisocclusionFill::kOwnMotion,
                              .depth = DepthMeasure::kNone,
                              .brightness_gate = true,
                              .motion_filter = false,
                              .color_format = PixelFormat::kRgba16F,
                              .output_format = PixelFormat::kRgba8,
                              .encoding = ColorEncoding::kDisplay};
  EXPECT_EQ(PipelineHeader({"A golden file of tests/tools/profile/header_test.cpp.", "",
                            "Every choice has a value."},
                           configuration),
            ReadFile(WARPLUT_SOURCE "/tests/tools/profile/pipeline.h"));
}

TEST(PipelineHeader, LeavesOutWhatHasNoValue) {
  EXPECT_EQ(Initializer({}), "{\n}");
  PipelineConfiguration configuration;
  configuration.super_resolution = false;
  configuration.generation.splat = false;
  EXPECT_EQ(Initializer(configuration),
            "{\n    .super_resolution = false,\n    .generation = {\n        .splat = false,\n    "
            "},\n}");
}

TEST(PipelineHeader, NamesEnumeratorsByTheirText) {
  EXPECT_EQ(Enumerator("edge-aware"), "kEdgeAware");
  EXPECT_EQ(Enumerator("own motion"), "kOwnMotion");
  EXPECT_EQ(Enumerator("rgba16f"), "kRgba16F");
  EXPECT_EQ(Enumerator("rgba8"), "kRgba8");
  EXPECT_EQ(Enumerator("catmull-rom"), "kCatmullRom");
}

}  // namespace
}  // namespace warplut
