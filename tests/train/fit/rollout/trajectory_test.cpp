#include "train/fit/rollout/trajectory.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "luts/contract.h"
#include "train/fit/random.h"

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

// The numerator of a component of a pan over `warps` warps, checked to be the double next to it.
int Numerator(double component, int warps) {
  const double numerator = std::round(component * warps);
  EXPECT_EQ(component, numerator / warps);
  return static_cast<int>(numerator);
}

TEST(Trajectory, PanReturnsAfterAnyNumberOfWarps) {
  for (const int warps : {2, 3, 6, 12, 24, 100}) {
    const std::array<int, 1> horizon = {warps};
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const auto trajectory = MakeTrajectory(Offsets::kPan, horizon, 1 << 16, seed);
      ASSERT_EQ(static_cast<int>(trajectory.size()), warps);
      const int x = Numerator(trajectory[0].x, warps), y = Numerator(trajectory[0].y, warps);
      EXPECT_TRUE(x != 0 || y != 0) << warps << " warps, seed " << seed;
      int sum_x = 0, sum_y = 0;
      for (const Displacement& v : trajectory) {
        sum_x += Numerator(v.x, warps);
        sum_y += Numerator(v.y, warps);
        EXPECT_EQ((Numerator(v.x, warps) - x) % warps, 0) << "another fraction";
        EXPECT_EQ((Numerator(v.y, warps) - y) % warps, 0) << "another fraction";
        EXPECT_LT(std::abs(sum_x), warps);
        EXPECT_LT(std::abs(sum_y), warps);
      }
      EXPECT_EQ(sum_x, 0);
      EXPECT_EQ(sum_y, 0);
    }
  }
}

TEST(Trajectory, PanReturnsAtEveryHorizon) {
  const std::array<int, 3> horizons = {12, 30, 48};  // sixths of a pixel
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    int sum_x = 0, warp = 0;
    for (const Displacement& v : MakeTrajectory(Offsets::kPan, horizons, kNodes, seed)) {
      sum_x += Numerator(v.x, 6);
      ++warp;
      if (warp == 12 || warp == 30 || warp == 48) {
        EXPECT_EQ(sum_x, 0) << warp;
      }
    }
  }
}

TEST(Trajectory, PanTakesEveryFraction) {
  const std::array<int, 1> horizon = {6};
  std::set<std::pair<int, int>> seen;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Displacement v = MakeTrajectory(Offsets::kPan, horizon, kNodes, seed)[0];
    seen.insert({(Numerator(v.x, 6) + 6) % 6, (Numerator(v.y, 6) + 6) % 6});
  }
  EXPECT_EQ(seen.size(), 35U) << "all of 6 x 6 but (0, 0)";
}

// What is trained on and judged by keeps its bits.
TEST(Trajectory, PanOfWholeTurnsIsANode) {
  const std::array<int, 1> horizon = {2 * kNodes};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const int x = random.Below(kNodes), y = random.Below(kNodes);
    for (const int steps : {kNodes, 1 << 16}) {
      const Displacement v = MakeTrajectory(Offsets::kPan, horizon, steps, seed)[0];
      EXPECT_EQ(v.x - std::floor(v.x), NodeOffset(x));
      EXPECT_EQ(v.y - std::floor(v.y), NodeOffset(y));
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
