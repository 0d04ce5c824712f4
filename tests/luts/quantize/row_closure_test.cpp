#include "luts/quantize/row_closure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace warplut {
namespace {

constexpr RoundingGrid kWide{-1000, 1000, 1000};

double Cost(const std::vector<RoundingTerm>& terms) {
  double cost = 0;
  for (const RoundingTerm& t : terms) cost += t.count * std::abs(t.rounded - t.value);
  return cost;
}

std::int32_t Sum(const std::vector<RoundingTerm>& terms) {
  std::int32_t sum = 0;
  for (const RoundingTerm& t : terms) sum += t.count * t.rounded;
  return sum;
}

// The least cost by trying every combination of steps.
double BruteForce(std::vector<RoundingTerm> terms, std::int32_t total, const RoundingGrid& grid,
                  std::size_t i = 0) {
  if (i == terms.size()) {
    return Sum(terms) == total ? Cost(terms) : std::numeric_limits<double>::infinity();
  }
  double best = std::numeric_limits<double>::infinity();
  for (int s = -kMaxRoundingStep; s <= kMaxRoundingStep; ++s) {
    terms[i].rounded = static_cast<std::int32_t>(std::llround(terms[i].value)) + s;
    if (grid.Has(terms[i].rounded)) best = std::min(best, BruteForce(terms, total, grid, i + 1));
  }
  return best;
}

TEST(RowClosure, FindsTheCheapestIntegersWithTheSum) {
  std::mt19937 random(3);
  for (const RoundingGrid& grid : {kWide, RoundingGrid{-1000, 1000, 20}}) {
    for (int trial = 0; trial < 50; ++trial) {
      std::vector<RoundingTerm> terms(5);
      double sum = 0;
      for (RoundingTerm& t : terms) {
        t.count = 1 + static_cast<int>(random() % 2);
        t.value = static_cast<double>(random() % 100000) / 1000 - 50;
        sum += t.count * t.value;
      }
      terms[0].count = 1;
      const auto total = static_cast<std::int32_t>(std::lround(sum));
      const double expected = BruteForce(terms, total, grid);
      if (!RoundToSum(total, grid, &terms)) {
        EXPECT_TRUE(std::isinf(expected));
        continue;
      }
      EXPECT_EQ(Sum(terms), total);
      EXPECT_NEAR(Cost(terms), expected, 1e-9);
      for (const RoundingTerm& t : terms) EXPECT_TRUE(grid.Has(t.rounded));
    }
  }
}

TEST(RowClosure, SaysWhereThereIsNoSolution) {
  std::vector<RoundingTerm> pair = {{1.5, 2, 0}};
  EXPECT_FALSE(RoundToSum(3, kWide, &pair));    // an odd sum of an even number
  EXPECT_FALSE(RoundToSum(100, kWide, &pair));  // too far
  std::vector<RoundingTerm> edge = {{10, 1, 0}};
  EXPECT_FALSE(RoundToSum(11, {-10, 10, 10}, &edge));
}

}  // namespace
}  // namespace warplut
