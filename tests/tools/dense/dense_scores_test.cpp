// The measure of displays as an eye sees them, on a pattern of which everything is known.
#include "tools/dense/dense_scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tools/dense/dense_report.h"
#include "tools/dense/dense_sweep.h"

namespace warplut {
namespace {

DenseWorldOptions Small() {
  DenseWorldOptions options;
  options.width = 64;
  options.height = 48;
  options.samples = 16;
  return options;
}

std::vector<Frame> References(const DenseWorld& world, int first, int count) {
  std::vector<Frame> frames;
  for (int i = 0; i < count; ++i) frames.push_back(world.reference(first + i));
  return frames;
}

std::vector<Image> Held(const std::vector<Image>& frames) {
  std::vector<Image> held;
  for (std::size_t i = 0; i < frames.size(); ++i) held.push_back(frames[i / kSlowStep * kSlowStep]);
  return held;
}

TEST(DenseJudge, IdealFramesAreEqual) {
  const DenseWorld world = PatternWorld(1.5, -0.5, Small());
  const DenseJudge judge(References(world, 0, 8));
  const DenseScores scores = judge.Judge(judge.Ideal());
  EXPECT_TRUE(std::isinf(scores.fixed.psnr));
  EXPECT_TRUE(std::isinf(scores.tracking.psnr));
  EXPECT_EQ(scores.temporal_error, 0);
  EXPECT_TRUE(std::isnan(scores.static_flicker));  // nothing stands still
}

// Frames that are held smear on an eye that tracks; four in place of one do not.
TEST(DenseJudge, HeldFramesSmearOnAnEyeThatTracks) {
  const DenseWorld world = PatternWorld(2, 0, Small());
  const DenseJudge judge(References(world, 0, 8));
  const DenseScores held = judge.Judge(Held(judge.Ideal()));
  EXPECT_LT(held.tracking.psnr, 25);
  // By whole pixels the mean that follows is the last frame, but for rounding and the edges.
  const FrameScore sharp =
      CompareImages("last", judge.Tracking(judge.Ideal(), 1), judge.Ideal().back(), 8);
  EXPECT_GT(sharp.psnr, 60);
}

TEST(DenseJudge, FlickerIsTheDeviationOnStaticEdges) {
  const DenseWorld world = PatternWorld(0, 0, Small());
  const DenseJudge judge(References(world, 0, 8));
  std::vector<Image> shown = judge.Ideal();
  for (std::size_t i = 0; i < shown.size(); i += 2) {
    for (float& value : shown[i].data) value += 0.1f;
  }
  EXPECT_NEAR(judge.Judge(shown).static_flicker, 0.05, 1e-6);
  EXPECT_EQ(judge.Judge(judge.Ideal()).static_flicker, 0);
}

double PsnrOf(const DenseReport& report, const std::string& display,
              FrameScore DenseScores::*score) {
  for (const DenseScores& scores : report.displays) {
    if (scores.display == display) return (scores.*score).psnr;
  }
  ADD_FAILURE() << display;
  return 0;
}

TEST(DenseReport, DenseFramesBeatSlowOnesWhereThePatternMoves) {
  DenseSettings settings;
  settings.world = Small();
  settings.warm_up = 8;
  settings.judged = 8;
  ASSERT_TRUE(settings.IsValid());
  const DenseReport report =
      MeasureDense("pattern", PatternWorld(1.4, 0.3, settings.world), settings, {});
  const double slow = PsnrOf(report, "60 Hz, one sample", &DenseScores::tracking);
  const double dense = PsnrOf(report, "240 Hz, dense, adaptive", &DenseScores::tracking);
  const double full = PsnrOf(report, "240 Hz, one sample", &DenseScores::tracking);
  EXPECT_GT(dense, slow + 3);
  EXPECT_GT(full, dense);
}

TEST(DenseReport, AtRestFourSamplesBeatOneAndDoNotFlicker) {
  DenseSettings settings;
  settings.world = Small();
  settings.warm_up = 20;
  settings.judged = 4;
  const DenseReport report =
      MeasureDense("pattern", PatternWorld(0, 0, settings.world), settings, {});
  EXPECT_GT(PsnrOf(report, "240 Hz, dense, adaptive", &DenseScores::fixed),
            PsnrOf(report, "60 Hz, one sample", &DenseScores::fixed) + 3);
  EXPECT_LT(report.displays[4].static_flicker, 1e-6);  // sums of the window are rounded
}

TEST(DenseSettings, AreChecked) {
  std::string why;
  const auto expect_refused = [&](auto change, const char* piece) {
    DenseSettings settings;
    change(settings);
    EXPECT_FALSE(settings.IsValid(&why));
    EXPECT_NE(why.find(piece), std::string::npos) << why;
  };
  expect_refused([](auto& s) { s.world.width = 10; }, "10 x 180");
  expect_refused([](auto& s) { s.world.width = 321; }, "321 x 180");
  expect_refused([](auto& s) { s.warm_up = 3; }, "warm-up is 3");
  expect_refused([](auto& s) { s.judged = 2; }, "judged subframes is 2");
  expect_refused([](auto& s) { s.world.samples = 0; }, "samples is 0");
  expect_refused([](auto& s) { s.world.speed = 0; }, "speed is 0");
  expect_refused([](auto& s) { s.dense.window = 9; }, "window is 9");
}

SweepCell Cell(double angle, double fraction, double hourglass, double bowtie) {
  SweepCell cell{angle, fraction, {}, {}};
  cell.hourglass.tracking.psnr = cell.hourglass.fixed.psnr = hourglass;
  cell.bowtie.tracking.psnr = cell.bowtie.fixed.psnr = bowtie;
  return cell;
}

TEST(DenseSweep, RulesAreScoredByTheirChoices) {
  const std::vector<SweepCell> cells = {Cell(0, 0.5, 30, 20), Cell(90, 0.5, 30, 26),
                                        Cell(45, 0.5, 22, 20)};
  const std::vector<RuleScore> rules = ScoreRules(cells, DenseParameters(), 1);
  ASSERT_EQ(rules.size(), std::size(kOrderRules) + 1);
  EXPECT_DOUBLE_EQ(rules[0].tracking_psnr, 82.0 / 3);  // hourglass
  EXPECT_DOUBLE_EQ(rules[1].tracking_psnr, 66.0 / 3);  // bowtie
  EXPECT_EQ(rules[5].rule, "mixed");
  EXPECT_DOUBLE_EQ(rules[5].tracking_psnr, (30 + 26 + 21) / 3.0);
  EXPECT_DOUBLE_EQ(rules.back().tracking_psnr, 82.0 / 3);
  const TextTable table = SweepTable(cells, DenseParameters(), 1);
  EXPECT_EQ(table.rows[0][1], "+10.00 (h)");
  EXPECT_EQ(table.rows[1][1], "+4.00 (b)");
  EXPECT_EQ(table.rows[2][1], "+2.00 (?)");
}

}  // namespace
}  // namespace warplut
