#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "datasets/error.h"
#include "luts/filters.h"
#include "tools/report/quartiles.h"
#include "tools/report/trainer/trainer_half_pixel.h"
#include "tools/report/trainer/trainer_profile.h"
#include "train/fit/rivals/keys_search.h"
#include "train/fit/rollout/noise_image.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TrainerRun MakeRun(std::size_t problem, double start, std::vector<TracePoint> trace) {
  return {problem, Trainer::kLbfgs, 1, start, std::move(trace)};
}

TEST(Quartiles, AreBetweenOrderStatistics) {
  const auto [low, median, high] = QuartilesOf({4, 1, 3, 2});
  EXPECT_DOUBLE_EQ(low, 1.75);
  EXPECT_DOUBLE_EQ(median, 2.5);
  EXPECT_DOUBLE_EQ(high, 3.25);
  EXPECT_EQ(QuartilesOf({kInfinity, kInfinity}).median, kInfinity);
}

TEST(HalfPixelOptimum, FindsThePlantedKernel) {
  int calls = 0;
  const HalfPixelOptimum optimum = FindHalfPixelOptimum(
      [&](const HalfPixelKernel& kernel) {
        ++calls;
        const double c = kernel.corner - 0.0137, e = kernel.edge + 0.0613;
        return 2 + c * c + 3 * e * e + 2 * c * e;
      },
      11);
  EXPECT_NEAR(optimum.kernel.corner, 0.0137, 1e-4);
  EXPECT_NEAR(optimum.kernel.edge, -0.0613, 1e-4);
  EXPECT_NEAR(optimum.loss, 2, 1e-8);
  EXPECT_EQ(optimum.evaluations, calls);
}

TEST(HalfPixelOptimum, KernelsAreSymmetricAndSumToOne) {
  const CanonicalWeights<double> weights =
      WithHalfPixelKernel({.corner = 1.0 / 256, .edge = -9.0 / 256});
  const Weights<double>& half =
      weights[static_cast<std::size_t>(ToCanonical(kHalfNode, kHalfNode).index)];
  const Weights<double> keys = KeysWeights(kCatmullRomA, 0.5, 0.5);
  for (int k = 0; k < kWeights; ++k) {
    EXPECT_NEAR(half[static_cast<std::size_t>(k)], keys[static_cast<std::size_t>(k)], 1e-12);
  }
}

TEST(TrainerProblem, HeadKeepsCatmullRomAndFirstMoments) {
  EXPECT_EQ(KeysByHead(kCatmullRomA), KeysCanonicalWeights(kCatmullRomA));
  const CanonicalWeights<double> weights = KeysByHead(-0.7);
  for (int c = 0; c < kCanonicalNodes; ++c) {
    double sum = 0, moment = 0;
    for (int k = 0; k < kWeights; ++k) {
      sum += weights[static_cast<std::size_t>(c)][static_cast<std::size_t>(k)];
      moment += weights[static_cast<std::size_t>(c)][static_cast<std::size_t>(k)] * TapX(k);
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(moment, NodeOffset(CanonicalPosition(c)[0]), 1e-12);
  }
}

// Crops that a half-pixel kernel can do well or badly on: the optimum is no worse than any Keys
// kernel.
TEST(TrainerProblem, HalfPixelOptimumBeatsKeys) {
  std::vector<BorderedPlane> crops;
  crops.push_back(ToPlane(NoiseImage(40, 40, 5)));
  const auto problem =
      HalfPixelProblem("half", std::make_unique<HalfPixelObjective>(std::move(crops), 4), 11, 1);
  for (const double a : {-0.5, -0.6, -0.7}) {
    EXPECT_LE(*problem->Optimum(), problem->Loss(KeysCanonicalWeights(a)) + 1e-9) << a;
  }
}

// The best Keys kernel is the kernel itself: no trainer of the MLP can do better.
TEST(RunTrainer, KeysIsOptimalWhereTheKernelIsOne) {
  const auto problem = KernelProblem("keys", KeysCanonicalWeights(-0.62), 1);
  const std::vector<TracePoint> keys = RunTrainer(*problem, Trainer::kKeys, 1, 50);
  EXPECT_LT(keys.back().loss, 1e-6);
  const std::vector<TracePoint> lbfgs = RunTrainer(*problem, Trainer::kLbfgs, 1, 10);
  EXPECT_LT(keys.back().loss, lbfgs.back().loss);
}

TEST(RunTrainer, EveryTrainerGainsOnAKernelAndKeepsItsBudget) {
  const auto problem = KernelProblem("keys", KeysByHead(-0.7), 10);
  for (const Trainer trainer : {Trainer::kLbfgs, Trainer::kAdam, Trainer::kLevenbergMarquardt}) {
    SCOPED_TRACE(Name(trainer));
    const std::vector<TracePoint> trace = RunTrainer(*problem, trainer, 2, 30);
    ASSERT_GT(trace.size(), 2u);
    EXPECT_EQ(trace.front().evaluations, 1);
    EXPECT_NEAR(trace.front().loss,
                problem->Function()->Evaluate(problem->Start(2).data(), nullptr), 1e-12);
    EXPECT_LT(trace.back().loss, 0.1 * trace.front().loss);
    EXPECT_LE(trace.back().evaluations, 90);
    for (std::size_t i = 1; i < trace.size(); ++i) {
      EXPECT_LT(trace[i].loss, trace[i - 1].loss);
      EXPECT_GT(trace[i].evaluations, trace[i - 1].evaluations);
    }
  }
}

TEST(RunTrainer, LevenbergMarquardtAppliesToKernelsAlone) {
  std::vector<BorderedPlane> crops;
  crops.push_back(ToPlane(NoiseImage(40, 40, 5)));
  const auto half =
      HalfPixelProblem("half", std::make_unique<HalfPixelObjective>(std::move(crops), 2), 5, 1);
  const auto kernel = KernelProblem("keys", KeysByHead(-0.7), 1);
  EXPECT_FALSE(Applies(Trainer::kLevenbergMarquardt, *half));
  EXPECT_TRUE(Applies(Trainer::kLevenbergMarquardt, *kernel));
  EXPECT_TRUE(Applies(Trainer::kAdam, *half));
}

TEST(StudyTrainers, RunsEveryPairAndEndsWithTheSameLosses) {
  std::vector<std::unique_ptr<const TrainerProblem>> problems;
  problems.push_back(KernelProblem("a", KeysByHead(-0.7), 1));
  problems.push_back(KernelProblem("b", KeysByHead(-0.4), 10));
  const TrainerStudy one = StudyTrainers(problems, {.seeds = 2, .evaluations = 6, .threads = 1});
  const TrainerStudy two = StudyTrainers(problems, {.seeds = 2, .evaluations = 6, .threads = 2});
  ASSERT_EQ(one.runs.size(), 2 * 2 * std::size(kTrainers));
  ASSERT_EQ(two.runs.size(), one.runs.size());
  EXPECT_EQ(one.best, (std::vector<double>{0, 0}));
  EXPECT_EQ(one.left_out, 0);
  for (std::size_t i = 0; i < one.runs.size(); ++i) {
    EXPECT_EQ(one.runs[i].problem, two.runs[i].problem);
    EXPECT_EQ(one.runs[i].trace.back().loss, two.runs[i].trace.back().loss);
    const AloneOnRank alone;
    const auto [problem, trainer, seed, start, trace] = one.runs[i];
    const std::vector<TracePoint> again = RunTrainer(*problems[problem], trainer, seed, 6);
    EXPECT_EQ(trace.size(), again.size());
    EXPECT_EQ(trace.back().loss, again.back().loss);
    EXPECT_EQ(trace.back().evaluations, again.back().evaluations);
  }
}

TEST(StudyTrainers, StopsWhenToldAndCountsWhatItLeavesOut) {
  std::vector<std::unique_ptr<const TrainerProblem>> problems;
  problems.push_back(KernelProblem("a", KeysByHead(-0.7), 1));
  const TrainerStudy none =
      StudyTrainers(problems, {.seeds = 3, .evaluations = 2, .threads = 2, .seconds = -1});
  EXPECT_TRUE(none.runs.empty());
  EXPECT_EQ(none.left_out, 3);
  EXPECT_THROW(StudyTrainers(problems, {.seeds = 3,
                                        .evaluations = 2,
                                        .threads = 2,
                                        .progress = [](double) { throw Error("interrupted"); }}),
               Error);
}

TEST(DataProfile, GapFallsFromOneToZero) {
  const TrainerRun run = MakeRun(0, 3, {{1, 0.1, 3.5}, {2, 0.2, 2}, {5, 0.5, 1}});
  EXPECT_DOUBLE_EQ(GapAfter(run, 1, Work::kEvaluations, 0.5), 1);
  EXPECT_DOUBLE_EQ(GapAfter(run, 1, Work::kEvaluations, 1), 1);
  EXPECT_DOUBLE_EQ(GapAfter(run, 1, Work::kEvaluations, 4), 0.5);
  EXPECT_DOUBLE_EQ(GapAfter(run, 1, Work::kSeconds, 0.6), 0);
  EXPECT_DOUBLE_EQ(GapAfter(run, 4, Work::kSeconds, 0.1), 0);
}

TEST(DataProfile, CountsSolvedRunsAndNeverFalls) {
  TrainerStudy study;
  study.best = {0, 1};
  study.runs.push_back(MakeRun(0, 1, {{1, 1, 1.0}, {10, 2, 0.05}, {20, 3, 0.0005}}));
  study.runs.push_back(MakeRun(1, 2, {{1, 1, 2.0}, {30, 9, 1.5}}));
  EXPECT_EQ(WorkToSolve(study.runs[0], 0, 0.1, Work::kEvaluations), 10);
  EXPECT_EQ(WorkToSolve(study.runs[0], 0, 1e-3, Work::kSeconds), 3);
  EXPECT_EQ(WorkToSolve(study.runs[1], 1, 0.1, Work::kSeconds), kInfinity);
  const auto all = [](const TrainerRun&) { return true; };
  const std::vector<double> amounts = {1, 5, 10, 20, 40};
  EXPECT_EQ(DataProfile(study, all, 0.1, Work::kEvaluations, amounts),
            (std::vector<double>{0, 0, 0.5, 0.5, 0.5}));
  EXPECT_EQ(DataProfile(study, all, 0.5, Work::kEvaluations, amounts),
            (std::vector<double>{0, 0, 0.5, 0.5, 1}));
}

}  // namespace
}  // namespace warplut
