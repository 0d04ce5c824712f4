#include <gtest/gtest.h>

#include "tools/report/sections/calibration_study.h"
#include "train/calibration/gate_model.h"
#include "train/calibration/search_space.h"

namespace warplut {
namespace {

CalibrationStudyOptions Options() {
  CalibrationStudyOptions options;
  options.fitted = {FindParameter("sr_depth_threshold"), FindParameter("blend_a"),
                    FindParameter("blend_b")};
  options.base = kPaperParameters;
  options.seeds = 2;
  options.random_seeds = 3;
  options.grids = {2, 3};
  return options;
}

void ExpectNeverRises(const SearchTrace& trace) {
  for (std::size_t i = 1; i < trace.loss.size(); ++i) {
    ASSERT_LE(trace.loss[i], trace.loss[i - 1]) << i;
  }
}

TEST(CalibrationStudy, SearchesStartAlikeAndGain) {
  GateModel model({}, 16, 100);
  const CalibrationStudy study = StudyCalibration(model, Options());
  ASSERT_TRUE(study.complete);
  ASSERT_EQ(study.calibrations.size(), 2u);
  ASSERT_EQ(study.random.size(), 3u);
  ASSERT_EQ(study.grids.size(), 2u);
  int longest = 0;
  for (const SearchTrace& trace : study.calibrations) {
    ExpectNeverRises(trace);
    EXPECT_EQ(trace.loss.front(), study.base_loss);
    longest = std::max(longest, trace.runs());
  }
  for (const SearchTrace& trace : study.random) {
    ExpectNeverRises(trace);
    EXPECT_EQ(trace.runs(), longest);
    EXPECT_EQ(trace.loss.front(), study.base_loss);
  }
  EXPECT_EQ(study.grids[0].trace.runs(), 2 + 8);
  EXPECT_EQ(study.grids[1].trace.runs(), 2 + 27);
}

// The model has one optimum, which calibration is made to find; coarse grids and random points come
// near it at best.
TEST(CalibrationStudy, CalibrationIsBestOnThePlantedModel) {
  GateModel model({}, 16, 100);
  const CalibrationStudy study = StudyCalibration(model, Options());
  const double best = study.Best().loss.back();
  for (const SearchTrace& trace : study.calibrations) EXPECT_LT(trace.loss.back(), best + 1e-4);
  for (const GridTrace& grid : study.grids) EXPECT_GE(grid.trace.loss.back(), best);
}

TEST(CalibrationStudy, BestIsWhereItsLossWasFound) {
  GateModel model({}, 16, 100);
  const CalibrationStudy study = StudyCalibration(model, Options());
  std::vector<double> residuals(model.Size());
  for (const SearchTrace* trace :
       {&study.calibrations[0], &study.random[1], &study.grids[1].trace}) {
    model.Evaluate(trace->best, 0, residuals);
    EXPECT_NEAR(LossOf(residuals), trace->loss.back(), 1e-12);
  }
}

TEST(CalibrationStudy, TraceOfAnEndedSearchKeepsItsLoss) {
  const SearchTrace trace{{3, 2, 2, 1}, {}};
  EXPECT_EQ(trace.After(1), 3);
  EXPECT_EQ(trace.After(3), 2);
  EXPECT_EQ(trace.After(100), 1);
}

TEST(CalibrationStudy, EndsWhenToldTo) {
  GateModel model({}, 16, 100);
  CalibrationStudyOptions options = Options();
  int asked = 0;
  options.go_on = [&] { return ++asked < 3; };
  const CalibrationStudy study = StudyCalibration(model, options);
  EXPECT_FALSE(study.complete);
  EXPECT_EQ(study.calibrations.size(), 2u);
  EXPECT_TRUE(study.random.empty());
}

}  // namespace
}  // namespace warplut
