#include "tools/judge/images/filter_scores.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/datasets/expect_error.h"

namespace warplut {
namespace {

TEST(ScoreTarget, ReadsFilterMarginOffsetsAndWarps) {
  const ScoreTarget target = ParseScoreTarget("best-keys,0.002,random,24");
  EXPECT_EQ(target.against, "best-keys");
  EXPECT_EQ(target.margin, 0.002);
  EXPECT_EQ(target.offsets, "random");
  EXPECT_EQ(target.max_warps, 24);
  EXPECT_FALSE(target.mean);
  EXPECT_EQ(ParseScoreTarget("spline:1/84,0,pan").offsets, "pan");
  EXPECT_TRUE(ParseScoreTarget("o-moms,0,mean").mean);
}

TEST(ScoreTarget, RefusesAnythingElse) {
  for (const char* text : {"", "keys", "keys,", "keys,x", "keys,nan", "keys,0,quarter",
                           "keys,0,half,x", "a,0,half,1,1", "keys,0,mean,24"}) {
    ExpectError([&] { ParseScoreTarget(text); }, {text, "expected FILTER,MARGIN", "pan", "mean"});
  }
}

TEST(ScoreTarget, CountsOnlyItsProtocols) {
  const std::vector<Protocol> protocols = {{.warps = 6, .offsets = Offsets::kHalf},
                                           {.warps = 6, .offsets = Offsets::kRandom},
                                           {.warps = 64, .offsets = Offsets::kRandom}};
  const FilterScores judged{.name = "lut", .ssim = {0.9, 0.9, 0.9}, .parameters = {}};
  const std::vector<FilterScores> others = {
      {.name = "keys", .ssim = {0.95, 0.899, 0.95}, .parameters = {}}};
  EXPECT_EQ(MissedProtocols(ParseScoreTarget("keys,0"), judged, others, protocols).size(), 2U);
  EXPECT_EQ(MissedProtocols(ParseScoreTarget("keys,0,random"), judged, others, protocols).size(),
            1U);
  EXPECT_EQ(MissedProtocols(ParseScoreTarget("keys,0,random,24"), judged, others, protocols).size(),
            0U);
  EXPECT_EQ(
      MissedProtocols(ParseScoreTarget("keys,0.002,random,24"), judged, others, protocols).size(),
      1U);
  ExpectError([&] { MissedProtocols(ParseScoreTarget("bilinear,0"), judged, others, protocols); },
              {"bilinear"});
}

TEST(ScoreTarget, TheMeanIsOverAllProtocols) {
  const std::vector<Protocol> protocols(3);
  const FilterScores judged{.name = "lut", .ssim = {0.9, 0.8, 0.7}, .parameters = {}};
  const std::vector<FilterScores> others = {
      {.name = "keys", .ssim = {0.95, 0.75, 0.67}, .parameters = {}}};
  EXPECT_DOUBLE_EQ(judged.Mean(), 0.8);
  EXPECT_TRUE(
      MissedProtocols(ParseScoreTarget("keys,0.009,mean"), judged, others, protocols).empty());
  const auto missed =
      MissedProtocols(ParseScoreTarget("keys,0.011,mean"), judged, others, protocols);
  ASSERT_EQ(missed.size(), 1U);
  EXPECT_THAT(missed[0], testing::StartsWith("mean: +0.01000 SSIM over keys"));
}

TEST(ScoreTarget, NanMisses) {
  const std::vector<Protocol> protocols(1);
  const FilterScores judged{.name = "lut", .ssim = {std::nan("")}, .parameters = {}};
  const std::vector<FilterScores> others = {{.name = "keys", .ssim = {0}, .parameters = {}}};
  for (const char* target : {"keys,0", "keys,0,mean"}) {
    EXPECT_EQ(MissedProtocols(ParseScoreTarget(target), judged, others, protocols).size(), 1U);
  }
}

}  // namespace
}  // namespace warplut
