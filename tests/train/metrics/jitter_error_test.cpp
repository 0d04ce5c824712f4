#include "train/metrics/jitter_error.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace warplut {
namespace {

constexpr int kWidth = 96, kHeight = 80;
using Signal = std::function<double(int x, int y, int frame)>;

Image ErrorOf(const Signal& signal, int frame) {
  Image image(kWidth, kHeight, 1);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) image.at(x, y) = static_cast<float>(signal(x, y, frame));
  }
  return image;
}

ErrorEnergy Repeating(int period, int frames, const Signal& signal, int border = 0) {
  JitterErrorSum sum(period, border);
  for (int frame = 0; frame < frames; ++frame) sum.Add(ErrorOf(signal, frame));
  return sum.Energy();
}

Signal Noise(double amplitude, std::uint32_t seed) {
  return [amplitude, seed](int x, int y, int frame) {
    std::mt19937 random(seed + static_cast<std::uint32_t>((frame * 128 + y) * 128 + x));
    return amplitude * std::normal_distribution<>()(random);
  };
}

TEST(JitterPeriod, IsTheLeastThatRepeats) {
  const Vec2 a{0.25, 0.25}, b{-0.25, 0.25}, c{0, 0};
  EXPECT_EQ(JitterPeriod(std::array{a, b, a, b}), 2);
  EXPECT_EQ(JitterPeriod(std::array{a, b, c, a}), 3);
  EXPECT_EQ(JitterPeriod(std::array{a, a, b, a, a, b, a}), 3);
  EXPECT_FALSE(JitterPeriod(std::array{a, b, c})) << "not repeated";
  EXPECT_FALSE(JitterPeriod(std::array{a, a, a})) << "no jitter";
  EXPECT_FALSE(JitterPeriod({}));
}

// A sine, a square wave and one pulse per cycle have their mean squares about their means.
TEST(JitterErrorSum, ARepeatingErrorHasItsEnergy) {
  for (const int period : {2, 5, 8, 18}) {
    SCOPED_TRACE(period);
    const int frames = JitterErrorSum::LeastFrames(period);
    const double rate = 2 * std::numbers::pi / period;
    const auto sine = [&](int x, int, int f) { return 0.1 * std::cos(rate * f + 0.5 * x) + 0.3; };
    if (period > 2) {
      EXPECT_NEAR(Repeating(period, frames, sine).Mean(), 0.01 / 2, 1e-7);
    }
    const auto pulse = [&](int, int, int f) { return f % period == 1 ? 0.2 : 0.0; };
    const double mean = 0.2 / period;
    EXPECT_NEAR(Repeating(period, frames + 3, pulse).Mean(), 0.04 / period - mean * mean, 1e-7);
  }
}

TEST(JitterErrorSum, OtherErrorsHaveNone) {
  constexpr int kPeriod = 8;
  const auto of = [&](const Signal& signal) { return Repeating(kPeriod, 40, signal).Mean(); };
  EXPECT_NEAR(of([](int x, int y, int) { return 0.01 * x - 0.3 * y; }), 0, 1e-9) << "constant";
  EXPECT_NEAR(of([](int, int, int f) { return 0.002 * f; }), 1e-6, 1e-8) << "a slow drift";
  EXPECT_NEAR(of(Noise(0.1, 1)), 0, 1e-4) << "noise of energy 0.01";
  // Half the rate of the cycle changes its sign from cycle to cycle.
  EXPECT_LT(of([](int, int, int f) { return std::cos(std::numbers::pi * f / kPeriod); }), 0);
  EXPECT_EQ(ErrorEnergy({.sum = -1, .values = 4}).Rms(), 0);
}

TEST(JitterErrorSum, IsFoundUnderNoise) {
  const Signal noise = Noise(0.1, 7);
  const auto signal = [&](int x, int y, int f) {
    return noise(x, y, f) + 0.05 * std::sin(2 * std::numbers::pi * f / 8 + x);
  };
  EXPECT_NEAR(Repeating(8, 23, signal).Mean(), 0.05 * 0.05 / 2, 1e-4);
}

TEST(JitterErrorSum, CountsWholeCyclesInARow) {
  const auto pulse = [](int, int, int f) { return f % 4 == 0 ? 1.0 : 0.0; };
  EXPECT_TRUE(std::isnan(Repeating(4, JitterErrorSum::LeastFrames(4) - 1, pulse).Rms()));
  EXPECT_EQ(Repeating(4, 11, pulse).values, 4 * kWidth * kHeight);
  EXPECT_EQ(Repeating(4, 14, pulse).values, 4 * kWidth * kHeight);
  EXPECT_EQ(Repeating(4, 15, pulse, 3).values, 8 * (kWidth - 6) * (kHeight - 6));
  JitterErrorSum cut(4, 0);
  for (int frame = 0; frame < 20; ++frame) {
    if (frame == 10) cut.Restart();
    cut.Add(ErrorOf(pulse, frame));
  }
  EXPECT_EQ(cut.Energy().values, 0) << "ten frames on both sides";
  for (int frame = 0; frame < 25; ++frame) {
    if (frame == 0 || frame == 12) cut.Restart();
    cut.Add(ErrorOf(pulse, frame));
  }
  EXPECT_EQ(cut.Energy().values, 8 * kWidth * kHeight);
  EXPECT_NEAR(cut.Energy().Mean(), 0.25 - 0.0625, 1e-6);
}

TEST(LatticeEnergy, IsThatOfThePatternOfTheGrid) {
  const auto of = [](double scale, const Signal& signal) {
    return LatticeEnergy(ErrorOf(signal, 0), scale, scale, 5).Mean();
  };
  const auto sign = [](int i) { return i % 2 == 0 ? 1.0 : -1.0; };
  EXPECT_NEAR(of(2, [&](int x, int y, int) { return 0.1 * sign(x + y); }), 0.01, 1e-6);
  EXPECT_NEAR(of(2, [&](int x, int, int) { return 0.1 * sign(x); }), 0.01, 1e-6);
  EXPECT_NEAR(of(2, [&](int, int y, int) { return 0.1 * sign(y); }), 0.01, 1e-6);
  // One bright pixel in each cell: three lines of amplitude 1/4.
  EXPECT_NEAR(of(2, [](int x, int y, int) { return x % 2 == 0 && y % 2 == 0 ? 0.4 : 0.0; }),
              3 * 0.01, 1e-6);
  for (const double scale : {1.5, 3.0}) {
    SCOPED_TRACE(scale);
    const double rate = 2 * std::numbers::pi / scale;
    EXPECT_NEAR(of(scale, [&](int x, int, int) { return 0.1 * std::cos(rate * x); }), 0.005, 2e-4);
    EXPECT_NEAR(of(scale, [&](int x, int y, int) { return 0.1 * std::cos(rate * (x - y)); }), 0.005,
                2e-4);
  }
}

TEST(LatticeEnergy, OtherErrorsHaveNone) {
  const auto of = [](const Signal& signal) {
    return LatticeEnergy(ErrorOf(signal, 0), 2, 2, 0).Mean();
  };
  EXPECT_NEAR(of([](int x, int y, int) { return 0.01 * x - 0.02 * y; }), 0, 1e-8);
  EXPECT_NEAR(of([](int x, int y, int) { return 0.1 * std::sin(0.3 * x + 0.5 * y); }), 0, 1e-6);
  EXPECT_NEAR(of(Noise(0.1, 3)), 0, 2e-4) << "noise of energy 0.01";
  const Image flat = ErrorOf([](int x, int, int) { return x % 2; }, 0);
  EXPECT_TRUE(std::isnan(LatticeEnergy(flat, 1, 1, 0).Mean())) << "no lattice";
  EXPECT_TRUE(std::isnan(LatticeEnergy(flat, 2, 2, 40).Mean())) << "no window fits";
}

}  // namespace
}  // namespace warplut
