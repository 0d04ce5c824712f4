#include "train/trajectory.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "luts/contract.h"

namespace warplut {
namespace {

constexpr std::array<int, 4> kHorizons = {6, 12, 24, 64};

TEST(Trajectory, ReturnsToTheStartAtEveryHorizon) {
  for (const Offsets offsets : {Offsets::kHalf, Offsets::kRandom}) {
    for (const int steps : {kNodes, 1 << 16}) {
      const auto trajectory = MakeTrajectory(offsets, kHorizons, steps, 5);
      ASSERT_EQ(trajectory.size(), 64u);
      double x = 0, y = 0;
      std::size_t h = 0;
      for (std::size_t i = 0; i < trajectory.size(); ++i) {
        x += trajectory[i].x;
        y += trajectory[i].y;
        EXPECT_LT(std::abs(trajectory[i].x), 1);
        EXPECT_LT(std::abs(trajectory[i].y), 1);
        EXPECT_LE(std::abs(x), 1);
        EXPECT_LE(std::abs(y), 1);
        EXPECT_EQ(trajectory[i].x * steps, std::round(trajectory[i].x * steps));
        if (static_cast<int>(i) + 1 == kHorizons[h]) {
          EXPECT_EQ(x, 0);
          EXPECT_EQ(y, 0);
          ++h;
        }
      }
    }
  }
}

TEST(Trajectory, HalfIsHalfEveryTime) {
  for (const Displacement& v : MakeTrajectory(Offsets::kHalf, kHorizons, kNodes, 0)) {
    EXPECT_EQ(std::abs(v.x), 0.5);
    EXPECT_EQ(v.x, v.y);
  }
}

TEST(Trajectory, PanRepeatsOneFractionAndReturns) {
  const std::array<int, 1> horizon = {2 * kNodes};
  for (const int steps : {kNodes, 1 << 16}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const auto trajectory = MakeTrajectory(Offsets::kPan, horizon, steps, seed);
      double x = 0, y = 0;
      for (const Displacement& v : trajectory) {
        x += v.x;
        y += v.y;
        EXPECT_EQ(v.x - std::floor(v.x), trajectory[0].x - std::floor(trajectory[0].x));
        EXPECT_EQ(v.y - std::floor(v.y), trajectory[0].y - std::floor(trajectory[0].y));
        EXPECT_LT(std::abs(v.x), 1);
      }
      EXPECT_EQ(x, 0);
      EXPECT_EQ(y, 0);
    }
  }
}

TEST(Trajectory, RandomFractionsCoverTheUnitSquareEvenly) {
  std::array<int, 4> quarter{};
  int total = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    for (const Displacement& v : MakeTrajectory(Offsets::kRandom, kHorizons, 1 << 16, seed)) {
      const double fraction = v.x - std::floor(v.x);
      ++quarter[static_cast<std::size_t>(4 * fraction)];
      ++total;
    }
  }
  for (const int count : quarter) EXPECT_NEAR(4.0 * count / total, 1, 0.05);
}

TEST(Trajectory, SeedDecides) {
  const auto at = [](std::uint64_t seed) {
    return MakeTrajectory(Offsets::kRandom, kHorizons, kNodes, seed)[0].x;
  };
  EXPECT_EQ(at(1), at(1));
  int different = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) different += at(seed) != at(seed + 1);
  EXPECT_GT(different, 5);
}

}  // namespace
}  // namespace warplut
