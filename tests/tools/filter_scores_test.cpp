#include "tools/filter_scores.h"

#include <gtest/gtest.h>

#include "tests/datasets/expect_error.h"
#include "tools/protocol_filter.h"

namespace warplut {
namespace {

TEST(ScoreTarget, ReadsFilterMarginOffsetsAndWarps) {
  const ScoreTarget target = ParseScoreTarget("best-keys,0.002,random,24");
  EXPECT_EQ(target.against, "best-keys");
  EXPECT_EQ(target.margin, 0.002);
  EXPECT_EQ(target.offsets, "random");
  EXPECT_EQ(target.max_warps, 24);
}

TEST(ScoreTarget, RefusesAnythingElse) {
  for (const char* text : {"", "keys", "keys,", "keys,x", "keys,nan", "keys,0,quarter",
                           "keys,0,half,x", "a,0,half,1,1"}) {
    ExpectError([&] { ParseScoreTarget(text); }, {text, "expected FILTER,MARGIN"});
  }
}

TEST(ScoreTarget, CountsOnlyItsProtocols) {
  const std::vector<Protocol> protocols = {{.warps = 6, .offsets = Offsets::kHalf},
                                           {.warps = 6, .offsets = Offsets::kRandom},
                                           {.warps = 64, .offsets = Offsets::kRandom}};
  const FilterScores judged{.name = "lut", .ssim = {0.9, 0.9, 0.9}, .keys_a = {}};
  const std::vector<FilterScores> others = {
      {.name = "keys", .ssim = {0.95, 0.899, 0.95}, .keys_a = {}}};
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

TEST(NamedFilter, RefusesWhatIsNoFilter) {
  for (const char* name :
       {"", "lut", "keys", "keys:", "keys:x", "keys:-0.5x", "keys:-1.5", "keys:nan", "Bilinear"}) {
    ExpectError([&] { NamedFilter(name); }, {name, "is not a filter"});
  }
}

}  // namespace
}  // namespace warplut
