#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/train/replay/pan_sequence.h"
#include "tools/profile/profile_search.h"
#include "tools/profile/tile_shares.h"

namespace warplut {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

PipelineScore Score(double ssim, double psnr, double temporal) {
  return {.mean = {.name = {}, .mean_squared_error = 0, .psnr = psnr, .ssim = ssim},
          .temporal_error = temporal};
}

TEST(CostOf, TakesTheWorstClip) {
  const PipelineCost cost = CostOf({Score(0.90, 30, 0.2), Score(0.95, 28, 0.1)},
                                   {Score(0.91, 29, 0.1), Score(0.94, 31, 0.1)});
  EXPECT_NEAR(cost.loss, 0.01, 1e-12);
  EXPECT_NEAR(cost.psnr_loss, 3, 1e-12);
  EXPECT_NEAR(cost.temporal_growth, 0.1, 1e-12);
  const PipelineCost equal =
      CostOf({Score(1, kInfinity, std::nan(""))}, {Score(1, kInfinity, std::nan(""))});
  EXPECT_EQ(equal.loss, 0);
  EXPECT_TRUE(std::isnan(equal.psnr_loss));
  EXPECT_TRUE(std::isnan(equal.temporal_growth));
}

TEST(RatioOf, ComparesPassByPass) {
  const TimeRatio ratio = RatioOf({1, 4, 9}, {2, 4, 6});
  EXPECT_EQ(ratio.median, 1);
  EXPECT_EQ(ratio.low, 0.5);
  EXPECT_EQ(ratio.high, 1.5);
}

// A pan of a texture, judged by its references or, without, by the full pipeline.
class Search : public testing::Test {
 protected:
  ProfileResult Profile(const char* method, PanOptions pan, double within) {
    const MethodInfo& info = *FindMethod(method);
    options_.method = &info;
    options_.every = info.generation == Generation::kNone ? 1 : 2;
    const bool has_reference = Contains(pan.streams, Streams::kReference);
    full_ = FullPipeline(options_, pan.render == pan.output);
    meter_.emplace(Clips(pan, has_reference), full_, options_, 1, [] {});
    const ProfileSearch search(full_, within, [&](double share) {
      EXPECT_GE(share, share_);
      share_ = share;
    });
    ProfileResult result = search.Search(*meter_);
    search.Check(*meter_, ShippedPipeline(options_, pan.render == pan.output), &result);
    EXPECT_EQ(share_, 1);
    return result;
  }

  static std::vector<std::string> Names(const std::vector<OmissionTrial>& trials) {
    std::vector<std::string> names;
    for (const OmissionTrial& trial : trials) names.emplace_back(trial.omission->name);
    return names;
  }

  std::vector<ProfileClip> Clips(const PanOptions& pan, bool has_reference) {
    const Sequence sequence = WritePan(folder_ / "pan", pan);
    const Streams streams = NeededStreams(*options_.method, AvailableStreams(sequence));
    std::vector<ProfileClip> clips(1);
    clips[0].input = LoadClip(sequence, 0, pan.frames, streams, options_.every);
    clips[0].truth = LoadClip(sequence, 0, pan.frames, pan.streams & kTruthStreams);
    clips[0].has_reference = has_reference;
    return clips;
  }

  const TemporaryFolder folder_;
  ModeRunOptions options_;
  ProfiledPipeline full_;
  std::optional<PipelineMeter> meter_;
  double share_ = 0;
};

TEST_F(Search, StaysWithinTheBound) {
  const ProfileResult result = Profile("sr", {}, 0.002);
  EXPECT_LE(result.checked.loss, 0.002);
  for (const OmissionTrial& trial : result.taken) EXPECT_LE(trial.cost.loss, 0.002);
  EXPECT_THAT(Names(result.alone), testing::Contains("history"));
  EXPECT_THAT(Names(result.taken), testing::Not(testing::Contains("history")))
      << "the texture is too fine for the render grid";
  // Errors have the same bits in any run.
  const auto again = meter_->Judge(result.chosen);
  EXPECT_EQ(again[0].mean.ssim, result.checked.scores[0].mean.ssim);
}

TEST_F(Search, WithoutABoundTheCheapestStays) {
  const ProfileResult result = Profile("sr", {}, 2);
  EXPECT_FALSE(result.chosen.sr.history);
  EXPECT_LT(result.checked.time.median, 0.8);
  EXPECT_TRUE(result.chosen.parameters.empty());
}

TEST_F(Search, WhatStandsStillNeedsNoGeneration) {
  const ProfileResult result = Profile("i", {.speed_x = 0, .speed_y = 0}, 0);
  EXPECT_THAT(Names(result.taken), testing::ElementsAre("generation"));
  EXPECT_EQ(result.checked.loss, 0);
  EXPECT_EQ(result.checked.time.median, 0);
  const std::vector<TileShares> tiles = CountTiles(*meter_, full_);
  ASSERT_EQ(tiles.size(), 1U);
  EXPECT_EQ(tiles[0].history.total, 0);
  EXPECT_EQ(Share(tiles[0].generated.warped, MotionKind::kStatic), 1);
  EXPECT_EQ(tiles[0].generated.disoccluded, 0);
}

TEST_F(Search, WithoutReferencesTheFullPipelineIsTheTruth) {
  const ProfileResult result = Profile("sr", {.streams = Streams::kRenderGrid}, 0.001);
  EXPECT_EQ(result.full_scores[0].mean.ssim, 1);
  EXPECT_TRUE(std::isnan(result.full_scores[0].temporal_error));
  EXPECT_LE(result.checked.loss, 0.001);
}

TEST_F(Search, AFrameRenderedAsShownNeedsNoSuperResolution) {
  // Rendered without jitter on the output grid: the rendered frame is the reference.
  const ProfileResult result =
      Profile("sr", {.render = {80, 64}, .output = {80, 64}, .jitter = false}, 0.0005);
  EXPECT_THAT(Names(result.taken), testing::ElementsAre("super-resolution"));
  EXPECT_LE(result.checked.loss, 0);
  EXPECT_FALSE(result.chosen.super_resolution);
}

TEST_F(Search, ClipsMustFit) {
  ExpectError([&] { Profile("sr", {.streams = Streams::kColor | Streams::kReference}, 0); },
              {"'depth'"});
}

}  // namespace
}  // namespace warplut
