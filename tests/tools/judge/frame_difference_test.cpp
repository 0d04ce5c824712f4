#include "tools/judge/frame_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace warplut {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

FrameDifference Of(const std::vector<double>& differences) {
  return DifferenceOver(differences, std::vector<double>(differences.size(), 0.0));
}

TEST(FrameDifference, IsTheClassicErrorWhereNeighboursAreNotAlike) {
  const FrameDifference difference = DifferenceOver({3, 2, 5, 2, 4, 1}, {1, 1, 2, 1, 2, 0});
  // 2, 1, 3, 1, 2, 1: neighbours alternate, so no frame counts less.
  EXPECT_DOUBLE_EQ(difference.mean, 10.0 / 6);
  EXPECT_NEAR(difference.standard_error, std::sqrt((20 - 100.0 / 6) / 5 / 6), 1e-12);
  EXPECT_DOUBLE_EQ(difference.independent, 6);
  EXPECT_EQ(difference.frames, 6);
}

TEST(FrameDifference, FramesThatAreAlikeCountLess) {
  std::vector<double> drifting, shuffled;
  for (int i = 0; i < 40; ++i) {
    drifting.push_back(i);
    shuffled.push_back(i * 17 % 40);
  }
  const FrameDifference alike = Of(drifting), apart = Of(shuffled);
  EXPECT_DOUBLE_EQ(alike.mean, apart.mean);
  EXPECT_DOUBLE_EQ(alike.independent, 3);
  EXPECT_GT(apart.independent, 20);
  EXPECT_GT(alike.standard_error, 3 * apart.standard_error);
}

// Series of first order around 0: how often 0 is held to be wrong at 1 % (two sides of 0.5 %).
double FalseAlarms(double correlation, int frames, bool corrected) {
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal;
  constexpr int kSeries = 1000;
  int alarms = 0;
  for (int s = 0; s < kSeries; ++s) {
    std::vector<double> series;
    double value = normal(generator) / std::sqrt(1 - correlation * correlation);
    for (int i = 0; i < frames; ++i) {
      series.push_back(value);
      value = correlation * value + normal(generator);
    }
    FrameDifference difference = Of(series);
    if (!corrected) {
      difference.standard_error *= std::sqrt((difference.independent - 1) / (frames - 1));
      difference.independent = frames;
    }
    if (std::abs(difference.mean) > difference.Uncertainty()) ++alarms;
  }
  return static_cast<double>(alarms) / kSeries;
}

TEST(FrameDifference, CorrelatedFramesRaiseFewFalseAlarms) {
  EXPECT_LT(FalseAlarms(0, 40, true), 0.015);
  EXPECT_LT(FalseAlarms(0.5, 40, true), 0.03);
  EXPECT_LT(FalseAlarms(0.8, 60, true), 0.03);
  EXPECT_LT(FalseAlarms(0.8, 8, true), 0.14);
  EXPECT_GT(FalseAlarms(0.8, 60, false), 0.2) << "as if frames were independent";
}

TEST(FrameDifference, LeavesOutFramesWithoutFiniteScores) {
  const FrameDifference difference =
      DifferenceOver({kInfinity, kInfinity, 3, 4, 5, 6, 7}, {kInfinity, 2, 1, 2, 3, 4, 5});
  EXPECT_EQ(difference.frames, 6);
  EXPECT_DOUBLE_EQ(difference.mean, 10.0 / 6);
  EXPECT_TRUE(std::isnan(DifferenceOver({}, {}).mean));
}

TEST(FrameDifference, TooFewFramesHaveNoError) {
  const FrameDifference difference = Of({1, 2, 1});
  EXPECT_FALSE(difference.HasError());
  EXPECT_EQ(PayoffOf(difference, 0), Payoff::kCannotTell);
}

TEST(FrameDifference, TheMeanOfSequencesHasTheErrorOfItsParts) {
  const FrameDifference a{.mean = 1, .standard_error = 0.3, .independent = 10, .frames = 10};
  const FrameDifference b{.mean = 3, .standard_error = 0.4, .independent = 5, .frames = 8};
  const FrameDifference mean = MeanDifference({a, b});
  EXPECT_DOUBLE_EQ(mean.mean, 2);
  EXPECT_DOUBLE_EQ(mean.standard_error, 0.25);
  EXPECT_EQ(mean.frames, 18);
  // Welch and Satterthwaite: 0.25^2 / (0.09^2 / 9 + 0.16^2 / 4) degrees.
  EXPECT_NEAR(mean.independent, 1 + 0.0625 / (0.0081 / 9 + 0.0256 / 4), 1e-9);
  EXPECT_DOUBLE_EQ(Reversed(mean).mean, -2);
  EXPECT_FALSE(MeanDifference({a, Of({1, 2})}).HasError());
}

TEST(FrameDifference, PaysWhereTheGainIsTold) {
  const auto gain = [](double mean, double error) {
    return FrameDifference{.mean = mean, .standard_error = error, .independent = 31, .frames = 40};
  };
  EXPECT_EQ(PayoffOf(gain(0.01, 0.001), 0.0005), Payoff::kPays);
  EXPECT_EQ(PayoffOf(gain(0.01, 0.01), 0.0005), Payoff::kCannotTell);
  EXPECT_EQ(PayoffOf(gain(-0.01, 0.001), 0.0005), Payoff::kDoesNotPay);
  EXPECT_EQ(PayoffOf(gain(0, 0), 0.0005), Payoff::kDoesNotPay);
  EXPECT_EQ(PayoffOf(gain(0.0002, 0.00001), 0.0005), Payoff::kDoesNotPay) << "told, and too little";
  EXPECT_EQ(PayoffOf(gain(0.0002, 0.00001), 0), Payoff::kPays);
  EXPECT_EQ(PayoffOf(gain(0.0002, 0.001), 0.0005), Payoff::kCannotTell);
}

}  // namespace
}  // namespace warplut
