#include "tests/stability/cases/history/history_loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/stability/cases/stability_clip.h"

namespace warplut {
namespace {

constexpr int kSize = 16;

// One wave along x.
void Wave(int, std::span<double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = 0.5 + 0.2 * std::cos(2 * std::numbers::pi / 8 * static_cast<double>(i % kSize));
  }
}

LoopOptions HalfPixel() {
  const WarpOptions warp = HistoryWarp();
  return {.warp = warp,
          .motion_x = -0.5f,
          .gain = GainOfMotion(warp, -0.5f, 0),
          .size = kSize,
          .frames = 50,
          .first = Wave,
          .input = Wave};
}

TEST(HistoryLoop, APredictionThatHoldsIsNotExceeded) {
  const LoopResult result = RunLoop(HalfPixel());
  EXPECT_LE(result.worst_ratio, 1);
  EXPECT_EQ(result.judged, 50);
  EXPECT_TRUE(result.finite);
  EXPECT_NEAR(result.first, 0.2 / std::numbers::sqrt2, 1e-6);
}

TEST(HistoryLoop, APredictionThatIsTooSmallIsSeen) {
  LoopOptions options = HalfPixel();
  options.gain = 0.9;
  EXPECT_GT(RunLoop(options).worst_ratio, 1);
  options.blend = 0.1;
  options.gain = 0.5;
  EXPECT_GT(RunLoop(options).worst_ratio, 1);
}

TEST(HistoryLoop, HasNoBorders) {
  // Whole pixels bring a wave that fits the torus back after its size, to the bit.
  LoopOptions options = HalfPixel();
  options.motion_x = 1;
  options.motion_y = -1;
  options.gain = 1;
  options.frames = kSize;
  const LoopResult result = RunLoop(options);
  EXPECT_EQ(result.last, result.first);
  EXPECT_LE(result.drift, 1e-12);
}

TEST(HistoryLoop, ABlendOfOneIsTheInput) {
  LoopOptions options = HalfPixel();
  options.blend = 1;
  options.first = [](int, std::span<double> values) { std::fill(values.begin(), values.end(), 0); };
  EXPECT_NEAR(RunLoop(options).last, 0.2 / std::numbers::sqrt2, 1e-6);
}

TEST(HistoryLoop, GainOfMotionIsOneForWholePixels) {
  EXPECT_NEAR(GainOfMotion(HistoryWarp(), 3, -2), 1, 1e-4);
  EXPECT_GT(GainOfMotion(HistoryWarp(), 0.5f, 0.5f), 1.005);
}

}  // namespace
}  // namespace warplut
