// Trainers on the same problems from the same starts: what they have reached after how much work.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/report/trainer/trainer_problem.h"

namespace warplut {

// kLbfgs and kAdam are those of train/fit/minimize.h; kLevenbergMarquardt fits kernels alone
// (trainer_kernel_fit.h); kKeys is the best of the kernels that Keys has, by golden section over a
// in [-1, 0].
enum class Trainer : std::uint8_t { kLbfgs, kAdam, kLevenbergMarquardt, kKeys };

inline constexpr Trainer kTrainers[] = {Trainer::kLbfgs, Trainer::kAdam,
                                        Trainer::kLevenbergMarquardt, Trainer::kKeys};

constexpr const char* Name(Trainer trainer) {
  switch (trainer) {
    case Trainer::kLbfgs:
      return "L-BFGS";
    case Trainer::kAdam:
      return "Adam";
    case Trainer::kLevenbergMarquardt:
      return "Levenberg-Marquardt";
    case Trainer::kKeys:
      return "best Keys";
  }
  return "";
}

bool Applies(Trainer trainer, const TrainerProblem& problem);

// A point of a trajectory: the least loss so far. Evaluations are those of the loss, with or
// without gradient; seconds are of the processor.
struct TracePoint {
  int evaluations = 0;
  double seconds = 0;
  double loss = 0;
};

// From the problem's start of that seed, until `evaluations` are spent or nothing more is gained.
// One point for each gain, the first for the first evaluation. The same arguments give the same
// losses. Runs on the calling thread if that lies in an arena of one (TBB).
std::vector<TracePoint> RunTrainer(const TrainerProblem& problem, Trainer trainer,
                                   std::uint64_t seed, int evaluations);

struct TrainerRun {
  std::size_t problem = 0;
  Trainer trainer = Trainer::kLbfgs;
  std::uint64_t seed = 0;
  double start = 0;  // the loss at the start that the other trainers had too
  std::vector<TracePoint> trace;
};

struct TrainerStudyOptions {
  int seeds = 5;  // 1 .. seeds
  int evaluations = 150;
  int threads = 0;       // 0: one per core
  double seconds = 1e9;  // wall time after which no run begins
  std::function<void(double share)> progress = [](double) {
  };  // by one thread at a time; what it throws ends the study
};

struct TrainerStudy {
  std::vector<TrainerRun> runs;  // by seed, problem, trainer
  std::vector<double> best;  // of each problem: the known optimum, or the least loss of all runs
  int left_out = 0;          // pairs of problem and seed that there was no time for
};

// Every trainer on every problem it applies to. A collective call of Ranks::World(): pairs of
// problem and seed are shared, each rank runs its own on `threads` threads, and all receive the
// same study.
TrainerStudy StudyTrainers(std::span<const std::unique_ptr<const TrainerProblem>> problems,
                           const TrainerStudyOptions& options);

}  // namespace warplut
