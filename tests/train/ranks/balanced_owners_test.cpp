#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "train/ranks/ranks.h"

namespace warplut {
namespace {

TEST(BalancedOwners, OneRankOwnsEverything) {
  EXPECT_EQ(BalancedOwners(std::vector<double>{3, 1, 2}, 1), (std::vector<int>{0, 0, 0}));
  EXPECT_TRUE(BalancedOwners(std::vector<double>{}, 4).empty());
}

TEST(BalancedOwners, TheLargestGoFirstToWhomHasLeast) {
  EXPECT_EQ(BalancedOwners(std::vector<double>{1, 5, 4, 2}, 2), (std::vector<int>{0, 0, 1, 1}));
}

// The bound of this rule: 4/3 of the least possible largest sum, which is at least the mean.
TEST(BalancedOwners, SharesAreAlike) {
  std::vector<double> work;
  for (int i = 0; i < 100; ++i) work.push_back(1 + i * 7 % 13);
  for (const int ranks : {2, 3, 4, 64}) {
    const std::vector<int> owners = BalancedOwners(work, ranks);
    std::vector<double> sums(static_cast<std::size_t>(ranks), 0.0);
    double total = 0;
    for (std::size_t i = 0; i < work.size(); ++i) {
      sums[static_cast<std::size_t>(owners[i])] += work[i];
      total += work[i];
    }
    EXPECT_LE(*std::max_element(sums.begin(), sums.end()), total / ranks + 13) << ranks;
    EXPECT_GT(*std::min_element(sums.begin(), sums.end()), 0) << ranks;
  }
}

TEST(ContiguousOwners, NeighboursStayTogether) {
  EXPECT_EQ(ContiguousOwners(std::vector<double>{3, 1, 2}, 1), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(ContiguousOwners(std::vector<double>{1, 1, 1, 1}, 2), (std::vector<int>{0, 0, 1, 1}));
  EXPECT_EQ(ContiguousOwners(std::vector<double>{8, 1, 1, 1}, 2), (std::vector<int>{0, 1, 1, 1}));
  EXPECT_EQ(ContiguousOwners(std::vector<double>{5}, 3), (std::vector<int>{1}));
  EXPECT_TRUE(ContiguousOwners(std::vector<double>{}, 4).empty());
}

TEST(ContiguousOwners, SharesAreTheMeanButForOnePiece) {
  std::vector<double> work;
  for (int i = 0; i < 100; ++i) work.push_back(1 + i * 7 % 13);
  const double total = std::accumulate(work.begin(), work.end(), 0.0);
  for (const int ranks : {2, 3, 4, 64}) {
    const std::vector<int> owners = ContiguousOwners(work, ranks);
    EXPECT_TRUE(std::is_sorted(owners.begin(), owners.end()));
    std::vector<double> sums(static_cast<std::size_t>(ranks), 0.0);
    for (std::size_t i = 0; i < work.size(); ++i) {
      sums[static_cast<std::size_t>(owners[i])] += work[i];
    }
    EXPECT_LE(*std::max_element(sums.begin(), sums.end()), total / ranks + 13) << ranks;
  }
}

TEST(Ranks, AloneEverythingIsOnesOwn) {
  Ranks& ranks = Ranks::World();
  EXPECT_EQ(ranks.rank(), 0);
  EXPECT_EQ(ranks.count(), 1);
  EXPECT_TRUE(ranks.IsRoot());
  EXPECT_TRUE(ranks.Any(true));
  EXPECT_FALSE(ranks.Any(false));
  EXPECT_EQ(ranks.OfRoot(2.5), 2.5);
  std::vector<std::vector<double>> items = {{1, 2}, {}, {3}};
  const std::vector<std::vector<double>> before = items;
  ranks.Exchange(std::vector<int>{0, 0, 0}, items);
  EXPECT_EQ(items, before);
  ranks.Meet();
  ranks.WaitForRoot();
  ranks.RequireSame("the texts", "text");
  ranks.Abort(2);  // returns
}

TEST(AloneOnRank, EndsAsItWas) {
  const Ranks& ranks = Ranks::World();
  {
    const AloneOnRank alone;
    EXPECT_TRUE(ranks.IsRoot());
    EXPECT_EQ(ranks.count(), 1);
  }
  EXPECT_EQ(ranks.rank(), 0);
  EXPECT_EQ(ranks.count(), 1);
}

}  // namespace
}  // namespace warplut
