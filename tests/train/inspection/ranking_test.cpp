#include "train/inspection/ranking.h"

#include <gtest/gtest.h>

#include <cmath>

namespace warplut {
namespace {

TEST(Difference, HasTheStandardErrorOfTheMean) {
  const PairedDifference d = Difference({1, 2, 3, std::nan("")}, {0, 0, 0, 5});
  EXPECT_EQ(d.samples, 3);
  EXPECT_DOUBLE_EQ(d.mean, 2);
  EXPECT_NEAR(d.standard_error, 1 / std::sqrt(3.0), 1e-12);
}

TEST(Difference, LeavesOutTiesUnlessAllAre) {
  EXPECT_EQ(Difference({1, 2, 3}, {1, 0, 0}).samples, 2);
  EXPECT_EQ(Difference({1, 2}, {1, 2}).mean, 0);
  EXPECT_FALSE(Difference({1, 2}, {1, 2}).IsTold(0.01));
}

TEST(PairedDifference, IsToldBeyondTheQuantile) {
  EXPECT_FALSE((PairedDifference{1, 0.2, 3}).IsTold(0.1)) << "9.92 errors are needed";
  EXPECT_TRUE((PairedDifference{1, 0.1, 3}).IsTold(0.1));
  EXPECT_FALSE((PairedDifference{1, 0.0, 1}).IsTold(0.1)) << "one sample has no error";
  EXPECT_FALSE((PairedDifference{0.05, 0.001, 20}).IsTold(0.1));
  EXPECT_NEAR(StudentQuantile(40), 2.704, 0.01);
  EXPECT_NEAR(StudentQuantile(1), 63.66, 0.01);
}

TEST(RankValues, TellsAgreementAndContradiction) {
  const std::vector<SampleScores> scores = {{1, 1.1, 0.9, 1}, {5, 5, 5.2, 5.1}, {0, 0, 0, 0.1}};
  EXPECT_EQ(RankValues("q", {"a", "b", "a"}, scores, "b").verdict, Verdict::kAgrees);
  const Ranking ranking = RankValues("q", {"a", "b", "a"}, scores, "a");
  EXPECT_EQ(ranking.verdict, Verdict::kContradicts);
  EXPECT_EQ(ranking.found, "b");
  ASSERT_EQ(ranking.candidates.size(), 2U);
  EXPECT_EQ(ranking.candidates[1].name, "a");
  EXPECT_TRUE(ranking.candidates[1].stated);
}

TEST(RankValues, CannotTellWhatIsCloseAndKeepsWhatIsStated) {
  const Ranking ranking = RankValues("q", {"a", "b"}, {{1, 2, 1, 2}, {1.2, 1.9, 1.1, 2}}, "a");
  EXPECT_EQ(ranking.verdict, Verdict::kCannotTell);
  EXPECT_EQ(ranking.found, "a");
  EXPECT_EQ(RankValues("q", {"a"}, {{1, 2}}, "a").verdict, Verdict::kCannotTell);
}

}  // namespace
}  // namespace warplut
