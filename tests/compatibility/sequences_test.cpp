// Manifests and parameters of every version load with the values that they were written with.
#include <gtest/gtest.h>

#include <cmath>

#include "datasets/sequence/sequence.h"
#include "train/replay/parameters_file.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

const fs::path kReleased = WARPLUT_RELEASED;

TEST(ReleasedSequences, PlainManifestHasItsValues) {
  const Sequence s = ReadSequence(kReleased / "sequences" / "plain");
  EXPECT_EQ(s.name, "colonnade");
  EXPECT_EQ(s.count, 2);
  EXPECT_EQ(s.render, (GridSize{4, 2}));
  EXPECT_EQ(s.output, (GridSize{8, 4}));
  EXPECT_EQ(s.color_space, ColorSpace::kSrgb);
  EXPECT_EQ(AvailableStreams(s), Streams::kAll);
  EXPECT_EQ(s.depth->kind, DepthKind::kLinear);
  EXPECT_EQ(s.depth->near, 0.1);
  EXPECT_EQ(s.depth->far, 300);
  EXPECT_EQ(s.motion->units, MotionUnits::kPixels);
  EXPECT_EQ(s.motion->channels, (std::vector<std::string>{"X", "Y"}));
  EXPECT_FALSE(s.motion->invalid);
  ASSERT_EQ(s.jitter.size(), 2U);
  EXPECT_EQ(s.jitter[0].y, -0.25);
  ASSERT_EQ(s.camera.size(), 2U);
  EXPECT_EQ(s.camera[1].view[5], 1);
  EXPECT_EQ(s.camera[1].projection[15], 1.5);
  EXPECT_EQ(s.cuts, std::vector<int>{1});
}

TEST(ReleasedSequences, PackedManifestHasItsValues) {
  const Sequence s = ReadSequence(kReleased / "sequences" / "packed");
  EXPECT_EQ(s.color_space, ColorSpace::kLinear);
  EXPECT_EQ(s.depth->encoding, Encoding::kRgba8Base255);
  EXPECT_EQ(s.depth->kind, DepthKind::kReversed);
  EXPECT_TRUE(std::isinf(s.depth->far));
  EXPECT_EQ(s.depth->scale, 0.5);
  EXPECT_EQ(s.motion->path_x, "mx%3d.png");
  EXPECT_EQ(s.motion->path_y, "my%3d.png");
  EXPECT_EQ(s.motion->scale, (std::array<double, 2>{2, 2}));
  EXPECT_EQ(s.motion->bias, (std::array<double, 2>{-1, -1}));
  EXPECT_EQ(s.motion->units, MotionUnits::kUv);
  EXPECT_EQ(s.motion->direction, MotionDirection::kCurrentToPrevious);
  EXPECT_EQ(s.motion->y, YAxis::kUp);
  EXPECT_TRUE(s.camera.empty());
}

TEST(ReleasedParameters, FileOfCalibrationHasItsValues) {
  const Parameters p = ReadParameters(kReleased / "parameters" / "version1.json");
  EXPECT_EQ(p.sr_depth_threshold, 0.25F);
  EXPECT_EQ(p.generation_depth_threshold, 0.125F);
  EXPECT_EQ(p.brightness_threshold, 0.07F);
  EXPECT_EQ(p.blend_a, 0.7F);
  EXPECT_EQ(p.blend_b, 0.8F);
  EXPECT_EQ(p.clamp_gamma, 1.3F);
}

TEST(ReleasedParameters, FileByHandKeepsTheDefaultsOfOthers) {
  const Parameters p = ReadParameters(kReleased / "parameters" / "version1_by_hand.json");
  EXPECT_EQ(p.blend_a, 0.7F);
  EXPECT_EQ(p.blend_b, 0.8F);
  EXPECT_EQ(p.clamp_gamma, Parameters{}.clamp_gamma);
}

}  // namespace
}  // namespace warplut
