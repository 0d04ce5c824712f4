// What the report computes: fronts, exponents, axes, labels.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tools/report/page/label_placement.h"
#include "tools/report/page/plot_axis.h"
#include "tools/report/pareto.h"
#include "tools/report/power_law.h"

namespace warplut {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Pareto, NamesWhatDominates) {
  const auto dominators = Dominators({{1, 5}, {2, 3}, {3, 3}, {4, 1}, {2, 6}, {kNan, 0}});
  EXPECT_FALSE(dominators[0]);
  EXPECT_FALSE(dominators[1]);
  EXPECT_EQ(dominators[2], 1U);
  EXPECT_FALSE(dominators[3]);
  EXPECT_EQ(dominators[4], 1U) << "the least error of those that dominate";
  EXPECT_FALSE(dominators[5]);
}

TEST(Pareto, EqualPointsDoNotDominateEachOther) {
  for (const auto& dominator : Dominators({{1, 1}, {1, 1}})) EXPECT_FALSE(dominator);
}

TEST(PowerLaw, FindsTheExponentThatWasPutIn) {
  const std::vector<double> x = {1, 2, 4, 8};
  std::vector<double> y;
  for (const double one : x) y.push_back(3 * std::pow(one, 1.5));
  const PowerLaw law = FitPowerLaw(x, y);
  EXPECT_NEAR(law.exponent, 1.5, 1e-12);
  EXPECT_NEAR(law.factor, 3, 1e-12);
  EXPECT_NEAR(law.error, 0, 1e-7);
}

// In logarithms to base e: x = 0, 1, 2, y = 0, 1, 0; slope 0, residuals -1/3, 2/3, -1/3, so the
// error is sqrt((6/9) / 1 / 2).
TEST(PowerLaw, StandardErrorByHand) {
  const std::vector<double> x = {1, std::exp(1), std::exp(2)}, y = {1, std::exp(1), 1};
  const PowerLaw law = FitPowerLaw(x, y);
  EXPECT_NEAR(law.exponent, 0, 1e-12);
  EXPECT_NEAR(law.error, std::sqrt(1.0 / 3), 1e-12);
}

TEST(PowerLaw, SaysSoWhereItCannotBeFitted) {
  const std::vector<double> one = {1}, same = {2, 2}, two = {1, 2}, zero = {0, 1};
  EXPECT_TRUE(std::isnan(FitPowerLaw(one, one).exponent));
  EXPECT_TRUE(std::isnan(FitPowerLaw(same, two).exponent));
  EXPECT_TRUE(std::isnan(FitPowerLaw(two, zero).exponent));
  EXPECT_TRUE(std::isnan(FitPowerLaw(two, two).error));
  EXPECT_NEAR(FitPowerLaw(two, two).exponent, 1, 1e-12);
}

TEST(PlotAxis, CoversTheValuesAndFewTics) {
  for (const bool logarithmic : {false, true}) {
    for (const std::vector<double>& values : std::vector<std::vector<double>>{
             {1, 2}, {1e-5, 3e4}, {7, 7}, {0.1, 0.12}, {}, {kNan, 5, 1000}}) {
      const PlotAxis axis(logarithmic, values);
      ASSERT_LT(axis.low(), axis.high());
      for (const double value : values) {
        if (!axis.CanDraw(value)) continue;
        EXPECT_GE(axis.Share(value), 0);
        EXPECT_LE(axis.Share(value), 1);
      }
      const std::vector<double> tics = axis.Tics(8);
      EXPECT_LE(tics.size(), 10U);
      for (const double tic : tics) {
        EXPECT_GE(tic, axis.low() * (1 - 1e-9));
        EXPECT_LE(tic, axis.high() * (1 + 1e-9));
      }
    }
  }
  EXPECT_FALSE(PlotAxis(true, {}).CanDraw(0));
  EXPECT_TRUE(PlotAxis(false, {}).CanDraw(-1));
  EXPECT_FALSE(PlotAxis(false, {}).CanDraw(kNan));
}

TEST(LabelPlacement, LabelsCoverNothing) {
  std::vector<LabelledPoint> points;
  for (int i = 0; i < 12; ++i) {
    points.push_back(
        {.x = 60.0 + 14 * (i % 4), .y = 60.0 + 13 * (i / 4), .width = 40, .height = 12});
  }
  const LabelBox area{0, 0, 160, 150};
  const std::vector<PlacedLabel> placed = PlaceLabels(points, area);
  int shown = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (!placed[i].shown) continue;
    ++shown;
    EXPECT_TRUE(placed[i].box.IsInside(area));
    for (const LabelledPoint& point : points) {
      EXPECT_FALSE(placed[i].box.Overlaps({point.x - 1, point.y - 1, point.x + 1, point.y + 1}));
    }
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(placed[j].shown && placed[i].box.Overlaps(placed[j].box));
    }
  }
  EXPECT_GE(shown, 3);
}

}  // namespace
}  // namespace warplut
