#include "train/calibration/kept_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "train/calibration/calibration.h"
#include "train/calibration/prior.h"

namespace warplut {
namespace {

constexpr int kA = 3, kB = 4;  // of kParameters

// Each residual has a floor of its own and is least at its own log a; b acts alike on all.
class Bowls final : public ResidualFunction {
 public:
  struct Bowl {
    double log_a = 0;
    int source = 0;
  };
  explicit Bowls(std::vector<Bowl> bowls, double floor = 0.05, double b_scale = 0,
                 double a_scale = 0.02)
      : bowls_(std::move(bowls)), floor_(floor), b_scale_(b_scale), a_scale_(a_scale) {}

  std::size_t Size() const override { return bowls_.size(); }
  int Source(std::size_t k) const override { return bowls_[k].source; }
  void Evaluate(const Parameters& p, float, std::span<double> residuals) override {
    for (std::size_t k = 0; k < residuals.size(); ++k) {
      const double a = std::log(p.blend_a) - bowls_[k].log_a, b = p.blend_b - 2;
      const double loss = floor_ + a_scale_ * a * a + b_scale_ * b * b;
      residuals[k] = std::sqrt(2 * loss / static_cast<double>(residuals.size()));
    }
  }

 private:
  std::vector<Bowl> bowls_;
  double floor_, b_scale_, a_scale_;
};

CalibrationResult Fit(Bowls& bowls, std::vector<int> fitted = {kA}, bool near_base = true) {
  CalibrationOptions options;
  options.fitted = std::move(fitted);
  options.random_starts = 0;
  options.near_base = near_base;
  return Calibrate(options, bowls);
}

double LogA(const Candidate& candidate) { return std::log(candidate.parameters.blend_a); }

// As many tiles of as many clips, all of which ask for the same.
std::vector<Bowls::Bowl> Alike(double log_a, int clips, int tiles = 10) {
  std::vector<Bowls::Bowl> bowls;
  for (int i = 0; i < clips * tiles; ++i) bowls.push_back({log_a, i / tiles});
  return bowls;
}

TEST(CompareLosses, ErrorsArePairedAndThoseOfTheSourcesIfTheyAreMore) {
  const auto residual = [](double loss) { return std::sqrt(2 * loss); };
  // Differences 1, 3, 1, 3: their sum has the variance 4 / 3 * 4.
  const std::vector<double> a = {residual(11), residual(23), residual(31), residual(43)};
  const std::vector<double> b = {residual(10), residual(20), residual(30), residual(40)};
  const LossDifference apart = CompareLosses(a, b, {0, 1, 2, 3});
  EXPECT_NEAR(apart.mean, 8, 1e-9);
  EXPECT_NEAR(apart.standard_error, std::sqrt(16.0 / 3), 1e-9);
  // Sums of the sources 2 and 6.
  EXPECT_NEAR(CompareLosses(a, b, {0, 1, 0, 1}).standard_error, 4, 1e-9);
  // Sums of the sources 4 and 4, which hide what the residuals show.
  EXPECT_NEAR(CompareLosses(a, b, {0, 0, 1, 1}).standard_error, std::sqrt(16.0 / 3), 1e-9);
  EXPECT_EQ(CompareLosses({1.0}, {0.5}, {0}).standard_error, 0);
}

TEST(KeptPoint, IsTheLeastLossTimesThePrior) {
  Bowls bowls(Alike(1.0, 1));
  const CalibrationResult result = Fit(bowls);
  EXPECT_NEAR(LogA(result.best), 1.0, 0.03);
  const SearchSpace space({kA}, {});
  const double base = space.Coordinate(0, Parameters{}.blend_a);
  double least = std::numeric_limits<double>::infinity(), expected = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double u = i / 1000.0, a = std::log(space.Value(0, u)) - 1.0;
    const double loss = (0.05 + 0.02 * a * a) * PriorFactor((u - base) * (u - base), 1);
    if (loss < least) least = loss, expected = std::log(space.Value(0, u));
  }
  EXPECT_NEAR(LogA(result.kept), expected, 0.03);
  EXPECT_EQ(result.parameters[0].value, result.kept.parameters.blend_a);
  EXPECT_EQ(result.parameters[0].optimum, result.best.parameters.blend_a);
  EXPECT_FALSE(result.parameters[0].at_base);
}

TEST(KeptPoint, MoreClipsCarryItFurther) {
  double before = 0;
  for (const int clips : {1, 2, 5, 20}) {
    Bowls bowls(Alike(1.0, clips));
    const double log_a = LogA(Fit(bowls).kept);
    EXPECT_GT(log_a, before) << clips;
    before = log_a;
  }
  EXPECT_NEAR(before, 1.0, 0.05);
}

TEST(KeptPoint, IsTheOptimumOfPlantedParameters) {
  Bowls bowls(Alike(1.0, 1), 0);
  const CalibrationResult result = Fit(bowls);
  EXPECT_NEAR(LogA(result.kept), 1.0, 0.02);
}

// Tiles dispute where a is best, far away, and agree on b; the prior alone would take back a and
// not b.
TEST(KeptPoint, IsTheBaseIfThatIsWithinAStandardErrorOfTheOptimum) {
  std::vector<Bowls::Bowl> bowls = Alike(0, 1, 8);
  for (std::size_t i = 0; i < bowls.size(); ++i) bowls[i].log_a = i % 2 == 0 ? -5.0 : 9.0;
  Bowls undecided(bowls, 0.05, 0.009, 0.002);
  const CalibrationResult result = Fit(undecided, {kA, kB});
  EXPECT_LT(result.best.loss, result.default_loss - 1e-4);
  EXPECT_EQ(result.kept.parameters, Parameters{});
  EXPECT_TRUE(result.parameters[0].at_base && result.parameters[1].at_base);
}

const double kDefaultLogA = std::log(static_cast<double>(Parameters{}.blend_a));

// The prior alone would keep a part of the way.
TEST(KeptPoint, IsTheBaseWhereTheDataDoesNotTell) {
  std::vector<Bowls::Bowl> bowls = Alike(0, 20);
  for (std::size_t i = 0; i < bowls.size(); ++i)
    bowls[i].log_a = kDefaultLogA + (i % 4 < 2 ? -1.0 : 1.05);
  Bowls undecided(bowls);
  const CalibrationResult result = Fit(undecided, {kA, kB});
  EXPECT_NE(result.best.parameters, Parameters{});
  EXPECT_EQ(result.kept.parameters, Parameters{});
  EXPECT_TRUE(result.parameters[0].at_base);
  ASSERT_TRUE(result.kept_error);
  EXPECT_GT(*result.kept_error, 0);
  EXPECT_LE(result.kept.loss - result.best.loss, *result.kept_error);
}

TEST(KeptPoint, GoesBackInOneCoordinateAlone) {
  std::vector<Bowls::Bowl> bowls = Alike(0, 20);
  for (std::size_t i = 0; i < bowls.size(); ++i)
    bowls[i].log_a = kDefaultLogA + (i % 4 < 2 ? -1.0 : 1.05);
  Bowls undecided(bowls, 0.05, 0.02);
  const CalibrationResult result = Fit(undecided, {kA, kB});
  EXPECT_TRUE(result.parameters[0].at_base);
  EXPECT_EQ(result.kept.parameters.blend_a, Parameters{}.blend_a);
  EXPECT_FALSE(result.parameters[1].at_base);
  // The prior keeps a tenth of the way from the default to 2.
  const double way = 2 - Parameters{}.blend_b;
  EXPECT_NEAR(result.kept.parameters.blend_b, 2, 0.105 * way);
}

TEST(KeptPoint, IsNoWorseThanAnyStart) {
  // The paper's share is best, and one clip does not lead there alone.
  Bowls bowls(Alike(std::log(kPaperParameters.blend_a), 1));
  const CalibrationResult result = Fit(bowls);
  EXPECT_LE(result.kept.loss, result.default_loss);
  EXPECT_LE(result.kept.loss, result.paper_loss);
}

TEST(KeptPoint, IsTheOptimumIfAskedFor) {
  Bowls bowls(Alike(1.0, 1));
  const CalibrationResult result = Fit(bowls, {kA}, false);
  EXPECT_EQ(result.kept.parameters, result.best.parameters);
  EXPECT_EQ(result.kept.loss, result.best.loss);
  EXPECT_EQ(result.kept_error, 0);
}

}  // namespace
}  // namespace warplut
