#include "train/calibration/calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "datasets/file.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "train/calibration/gate_model.h"

namespace warplut {
namespace {

constexpr int kThreshold = 0, kA = 3, kB = 4;  // of kParameters

double LossAt(GateModel& model, const Parameters& parameters) {
  std::vector<double> residuals(model.Size());
  model.Evaluate(parameters, 0, residuals);
  return LossOf(residuals);
}

CalibrationOptions Options(std::vector<int> fitted, int random_starts = 0) {
  CalibrationOptions options;
  options.fitted = std::move(fitted);
  options.random_starts = random_starts;
  return options;
}

TEST(Calibration, FindsThePlantedParameters) {
  for (const double floor : {0.0, 0.05}) {
    GateModel model({.floor = floor});
    const CalibrationResult result = Calibrate(Options({kThreshold, kA, kB}), model);
    const Parameters truth = model.Best();
    for (const Candidate& found : {result.best, result.kept}) {
      EXPECT_NEAR(found.parameters.sr_depth_threshold / truth.sr_depth_threshold, 1, 0.05);
      EXPECT_NEAR(found.parameters.blend_a / truth.blend_a, 1, 0.05);
      EXPECT_NEAR(found.parameters.blend_b / truth.blend_b, 1, 0.05);
    }
    EXPECT_LE(result.best.loss, LossAt(model, truth) + 1e-5);
    EXPECT_EQ(result.runs, model.runs() - 1) << "every run is counted";
    EXPECT_EQ(result.optima.size(), 1U);
  }
}

TEST(Calibration, CostsATwentiethOfADenseGrid) {
  GateModel model({});
  const CalibrationResult result = Calibrate(Options({kThreshold, kA, kB}), model);
  const SearchSpace space({kThreshold, kA, kB}, {});
  constexpr int kSide = 16;
  double grid = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      for (int k = 0; k < kSide; ++k) {
        const Point point = {i / (kSide - 1.0), j / (kSide - 1.0), k / (kSide - 1.0)};
        grid = std::min(grid, LossAt(model, space.ToParameters(point)));
      }
    }
  }
  EXPECT_LE(result.best.loss, grid + 0.0005);
  EXPECT_LE(result.search_runs, kSide * kSide * kSide / 20);
}

TEST(Calibration, IsNeverWorseThanAStart) {
  // The defaults, or the paper's constants, are best to begin with.
  for (const Parameters& planted : {Parameters{}, kPaperParameters}) {
    GateModel model({.threshold = planted.sr_depth_threshold,
                     .share = planted.blend_a * (1 - 0.1 * planted.blend_b),
                     .slope = planted.blend_b,
                     .spread = 0});
    const CalibrationResult result = Calibrate(Options({kThreshold, kA, kB}, 1), model);
    EXPECT_LE(result.best.loss, result.default_loss);
    EXPECT_LE(result.best.loss, result.paper_loss);
    EXPECT_LE(result.best.loss, LossAt(model, planted));
    EXPECT_LE(result.kept.loss, result.default_loss);
    EXPECT_LE(result.kept.loss, result.paper_loss);
  }
}

TEST(Calibration, ReportsAParameterThatNothingHangsOn) {
  GateModel model({.threshold_acts = false});
  const CalibrationResult result = Calibrate(Options({kThreshold, kA}, 1), model);
  EXPECT_TRUE(result.parameters[0].NotNeeded());
  EXPECT_FALSE(result.parameters[0].standard_error.has_value());
  EXPECT_EQ(result.best.parameters.sr_depth_threshold, Parameters{}.sr_depth_threshold);
  EXPECT_FALSE(result.parameters[1].NotNeeded());
  EXPECT_TRUE(result.parameters[1].standard_error.has_value());
}

// The paper's share would be better, but it is not what was asked for.
TEST(Calibration, LeavesWhatIsNotFittedAlone) {
  const Parameters& paper = kPaperParameters;
  GateModel model({.threshold = paper.sr_depth_threshold,
                   .share = paper.blend_a * (1 - 0.1 * paper.blend_b),
                   .slope = paper.blend_b});
  const CalibrationResult result = Calibrate(Options({kThreshold}, 1), model);
  EXPECT_LT(result.paper_loss, result.default_loss);
  Parameters expected;
  expected.sr_depth_threshold = result.best.parameters.sr_depth_threshold;
  EXPECT_EQ(result.best.parameters, expected);
}

TEST(Calibration, WhatHardlyActsDoesNotWander) {
  GateModel model({.scale = 1e-9});
  const CalibrationResult result = Calibrate(Options({kThreshold, kA, kB}, 1), model);
  for (const CalibratedParameter& parameter : result.parameters) {
    EXPECT_TRUE(parameter.NotNeeded());
  }
  EXPECT_EQ(result.best.parameters, Parameters{});
  EXPECT_LE(result.best.loss, result.default_loss);
}

TEST(Calibration, AllIsNotNeededWhereTheLossIsConstant) {
  for (const double floor : {0.0, 0.1}) {
    GateModel model({.floor = floor, .scale = 0});
    const CalibrationResult result = Calibrate(Options({kThreshold, kA, kB}, 1), model);
    for (const CalibratedParameter& parameter : result.parameters) {
      EXPECT_TRUE(parameter.NotNeeded());
    }
    EXPECT_EQ(result.best.parameters, Parameters{});
  }
}

TEST(Calibration, OneResidualIsEnough) {
  GateModel model({}, 1, 4000);
  const CalibrationResult result = Calibrate(Options({kThreshold, kA, kB}), model);
  EXPECT_LE(result.best.loss, LossAt(model, model.Best()) + 5e-4);
  for (const CalibratedParameter& parameter : result.parameters) {
    EXPECT_FALSE(parameter.standard_error.has_value());
  }
}

TEST(Calibration, FindsAnOptimumAtTheEndOfARange) {
  GateModel model({.slope = 20});
  const CalibrationResult result = Calibrate(Options({kA, kB}), model);
  EXPECT_TRUE(result.parameters[1].at_max);
  EXPECT_FALSE(result.parameters[1].standard_error.has_value());
}

// The error of the mean of independent tiles: spread / sqrt(tiles), relative for a logarithm.
TEST(Calibration, StandardErrorsAreThoseOfTheTiles) {
  GateModel model({.spread = 0.2});
  const CalibrationResult result = Calibrate(Options({kA, kB}), model);
  EXPECT_NEAR(*result.parameters[0].standard_error / result.best.parameters.blend_a,
              0.2 / std::sqrt(64), 0.012);
  EXPECT_NEAR(*result.parameters[1].standard_error, 0.2 / std::sqrt(64), 0.008);
  ASSERT_EQ(result.correlations.size(), 4U);
  EXPECT_EQ(result.correlations[0], 1.0);
  EXPECT_EQ(result.correlations[1], result.correlations[2]);
  EXPECT_LE(std::abs(result.correlations[1]), 1.0);
}

// Two valleys in the logarithm of a.
class TwoValleys final : public ResidualFunction {
 public:
  std::size_t Size() const override { return 8; }
  void Evaluate(const Parameters& p, float, std::span<double> residuals) override {
    const double left = std::log(p.blend_a / 0.05), right = std::log(p.blend_a / 5.0);
    const double loss = 0.05 + 0.02 * std::min(left * left, 0.1 + right * right);
    for (double& r : residuals) r = std::sqrt(2 * loss / static_cast<double>(residuals.size()));
  }
};

TEST(Calibration, TellsSeveralOptimaApart) {
  TwoValleys valleys;
  const CalibrationResult result = Calibrate(Options({kA}, 6), valleys);
  ASSERT_EQ(result.optima.size(), 2U);
  EXPECT_NEAR(result.optima[0].parameters.blend_a, 0.05, 0.003);
  EXPECT_NEAR(result.optima[1].parameters.blend_a, 5.0, 0.3);
  EXPECT_NEAR(result.best.parameters.blend_a, 0.05, 0.003);
}

TEST(Calibration, TheSameSeedGivesTheSameBits) {
  GateModel first({}), second({});
  const CalibrationResult a = Calibrate(Options({kThreshold, kA, kB}, 2), first);
  const CalibrationResult b = Calibrate(Options({kThreshold, kA, kB}, 2), second);
  EXPECT_EQ(a.best.parameters, b.best.parameters);
  EXPECT_EQ(a.best.loss, b.best.loss);
  EXPECT_EQ(a.runs, b.runs);
}

TEST(Calibration, GoesOnAfterAnInterruptionWithTheSameBits) {
  const TemporaryFolder folder;
  CalibrationOptions options = Options({kThreshold, kA}, 1);
  options.checkpoint = folder / "checkpoint";
  GateModel whole({});
  const CalibrationResult expected = Calibrate(options, whole);
  std::filesystem::remove(options.checkpoint);

  options.progress = [](const CalibrationProgress& state) { return state.runs < 40; };
  GateModel begun({});
  const CalibrationResult stopped = Calibrate(options, begun);
  EXPECT_EQ(stopped.stop, RunLog::Stop::kAsked);
  EXPECT_EQ(stopped.runs, 40);
  EXPECT_TRUE(std::isfinite(stopped.best.loss));
  EXPECT_LE(stopped.kept.loss, stopped.default_loss);

  options.progress = nullptr;
  options.resume = true;
  GateModel rest({});
  const CalibrationResult resumed = Calibrate(options, rest);
  EXPECT_EQ(resumed.best.parameters, expected.best.parameters);
  EXPECT_EQ(resumed.kept.parameters, expected.kept.parameters);
  EXPECT_EQ(resumed.runs, expected.runs);
  EXPECT_EQ(rest.runs(), expected.runs - 40 + 1) << "one run is made again to compare";
}

TEST(Calibration, RefusesAnotherCheckpoint) {
  const TemporaryFolder folder;
  CalibrationOptions options = Options({kA});
  options.checkpoint = folder / "checkpoint";
  GateModel model({});
  Calibrate(options, model);
  options.resume = true;
  options.seed = 2;
  ExpectError([&] { Calibrate(options, model); }, {"checkpoint", "other options"});
  options.seed = 1;
  GateModel changed({.floor = 0.04});
  ExpectError([&] { Calibrate(options, changed); }, {"checkpoint", "do not repeat"});
  const std::string text = ReadFile(options.checkpoint);
  WriteFile(options.checkpoint, text.substr(0, text.size() / 2));
  ExpectError([&] { Calibrate(options, model); }, {"checkpoint", "JSON"});
}

TEST(Calibration, EndsAtATimeLimit) {
  GateModel model({});
  CalibrationOptions options = Options({kThreshold, kA, kB}, 2);
  options.max_seconds = 1e-9;
  const CalibrationResult result = Calibrate(options, model);
  EXPECT_EQ(result.stop, RunLog::Stop::kTime);
  EXPECT_LE(result.runs, 1);
  // Nothing was judged: the defaults stay, and nothing is said to be known.
  EXPECT_EQ(result.kept.parameters, options.base);
  EXPECT_FALSE(result.kept_error);
  EXPECT_EQ(result.planned_starts, 4);
  for (const CalibrationStart& start : result.starts) EXPECT_FALSE(start.complete);
  for (const CalibratedParameter& parameter : result.parameters) {
    EXPECT_FALSE(parameter.profiled);
    EXPECT_FALSE(parameter.at_base);
    EXPECT_FALSE(parameter.standard_error);
  }
}

// A model one run of which takes long.
class SlowModel final : public ResidualFunction {
 public:
  SlowModel(int slow_run, double seconds) : slow_run_(slow_run), seconds_(seconds) {}
  std::size_t Size() const override { return model_.Size(); }
  int Source(std::size_t k) const override { return model_.Source(k); }
  void Evaluate(const Parameters& parameters, float gate_width,
                std::span<double> residuals) override {
    model_.Evaluate(parameters, gate_width, residuals);
    if (++run_ == slow_run_) std::this_thread::sleep_for(std::chrono::duration<double>(seconds_));
  }

 private:
  GateModel model_{{}};
  const int slow_run_;
  const double seconds_;
  int run_ = 0;
};

TEST(Calibration, ATimeLimitLeavesTimeToJudgeWhatIsKept) {
  const CalibrationOptions whole_options = Options({kThreshold, kA, kB}, 1);
  SlowModel fast(0, 0);
  const CalibrationResult whole = Calibrate(whole_options, fast);
  ASSERT_TRUE(whole.kept_error);
  for (const CalibrationStart& start : whole.starts) EXPECT_TRUE(start.complete);

  CalibrationOptions options = whole_options;
  options.max_seconds = 1;
  SlowModel slow(30, (kSearchShare + 0.05) * options.max_seconds);
  const CalibrationResult cut = Calibrate(options, slow);
  EXPECT_EQ(cut.stop, RunLog::Stop::kTime);
  EXPECT_EQ(cut.search_runs, 30);
  EXPECT_LT(cut.search_runs, whole.search_runs);
  EXPECT_FALSE(cut.starts.front().complete);
  ASSERT_TRUE(cut.kept_error) << "what is kept was judged in the time that was left";
  EXPECT_LE(cut.kept.loss, cut.default_loss);
  EXPECT_LT(cut.seconds, 1);

  SlowModel slower(30, 1.1 * options.max_seconds);
  const CalibrationResult none = Calibrate(options, slower);
  EXPECT_FALSE(none.kept_error);
  EXPECT_EQ(none.kept.parameters, options.base);
}

TEST(Calibration, OptionsNameWhatIsWrong) {
  const auto expect = [](const CalibrationOptions& options, const std::string& piece) {
    std::string why;
    EXPECT_FALSE(options.IsValid(&why));
    EXPECT_THAT(why, testing::HasSubstr(piece));
    EXPECT_FALSE(options.IsValid());
  };
  EXPECT_TRUE(Options({kA}).IsValid());
  expect(Options({}), "no parameter");
  expect(Options({kA, kA}), "each once");
  expect(Options({17}), "17");
  expect(Options({kA}, -1), "random starts");
  CalibrationOptions options = Options({kA});
  options.widths = {0.2f, 0.4f};
  expect(options, "0.4");
  options.widths = {};
  expect(options, "gate widths");
  options = Options({kA});
  options.max_seconds = -1;
  expect(options, "max_seconds");
  options = Options({kA});
  options.resume = true;
  expect(options, "checkpoint");
  options = Options({kA});
  options.base.blend_b = 7;
  expect(options, "blend_b");
}

}  // namespace
}  // namespace warplut
