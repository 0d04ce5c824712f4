#include "tools/report/trainer/trainer_study.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>

#include "tools/bench/timing.h"
#include "tools/report/section_time.h"
#include "tools/report/trainer/trainer_kernel_fit.h"
#include "train/fit/golden_section.h"
#include "train/fit/keys_search.h"
#include "train/fit/minimize.h"

namespace warplut {
namespace {

constexpr double kSoftestKeys = 0, kSharpestKeys = -1, kKeysWidth = 0.005;

// Notes what evaluations find.
class Trace {
 public:
  void Spend(int evaluations, double loss) {
    evaluations_ += evaluations;
    if (loss < least_) {
      least_ = loss;
      points_.push_back({evaluations_, (ThreadMilliseconds() - begin_) / 1000, loss});
    }
  }
  int evaluations() const { return evaluations_; }
  std::vector<TracePoint> points() && { return std::move(points_); }

 private:
  const double begin_ = ThreadMilliseconds();
  int evaluations_ = 0;
  double least_ = std::numeric_limits<double>::infinity();
  std::vector<TracePoint> points_;
};

class TracedFunction final : public ParameterFunction {
 public:
  TracedFunction(ParameterFunction& function, Trace& trace) : function_(function), trace_(trace) {}

  double Evaluate(const double* parameters, double* gradient) override {
    const double value = function_.Evaluate(parameters, gradient);
    trace_.Spend(1, value);
    return value;
  }

 private:
  ParameterFunction& function_;
  Trace& trace_;
};

}  // namespace

bool Applies(Trainer trainer, const TrainerProblem& problem) {
  return trainer != Trainer::kLevenbergMarquardt || problem.Kernel() != nullptr;
}

std::vector<TracePoint> RunTrainer(const TrainerProblem& problem, Trainer trainer,
                                   std::uint64_t seed, int evaluations) {
  const std::unique_ptr<ParameterFunction> function = problem.Function();
  std::vector<double> parameters = problem.Start(seed);
  Trace trace;
  TracedFunction traced(*function, trace);
  const MinimizeCallback go_on = [&](const double*, double) {
    return trace.evaluations() < evaluations;
  };
  switch (trainer) {
    case Trainer::kLbfgs:
      MinimizeLbfgs(traced, evaluations, go_on, parameters);
      break;
    case Trainer::kAdam: {
      AdamState state;
      MinimizeAdam(traced, evaluations, go_on, state, parameters);
      break;
    }
    case Trainer::kLevenbergMarquardt:
      FitKernelByLevenbergMarquardt(
          *problem.Kernel(),
          [&](int spent, double loss) {
            trace.Spend(spent, loss);
            return trace.evaluations() < evaluations;
          },
          parameters);
      break;
    case Trainer::kKeys:
      GoldenSection(
          [&](double a) {
            const double loss = problem.Loss(KeysCanonicalWeights(a));
            trace.Spend(1, loss);
            return -loss;
          },
          kSharpestKeys, kSoftestKeys, kKeysWidth);
      break;
  }
  return std::move(trace).points();
}

TrainerStudy StudyTrainers(std::span<const std::unique_ptr<const TrainerProblem>> problems,
                           const TrainerStudyOptions& options) {
  const SectionTime time(options.seconds);
  const std::size_t jobs = problems.size() * static_cast<std::size_t>(options.seeds);
  std::vector<std::vector<TrainerRun>> results(jobs);
  std::atomic<std::size_t> next = 0, done = 0;
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto report = [&] {
    const std::lock_guard lock(mutex);
    if (!thrown) options.progress(static_cast<double>(done) / static_cast<double>(jobs));
  };
  const auto run_job = [&](std::size_t job) {
    const std::size_t p = job % problems.size();
    const std::uint64_t seed = 1 + job / problems.size();
    const TrainerProblem& problem = *problems[p];
    const double start = problem.Function()->Evaluate(problem.Start(seed).data(), nullptr);
    for (const Trainer trainer : kTrainers) {
      if (!Applies(trainer, problem)) continue;
      results[job].push_back(
          {p, trainer, seed, start, RunTrainer(problem, trainer, seed, options.evaluations)});
      report();
    }
    ++done;
  };
  const auto work = [&] {
    // One thread for each run, so that its processor time is all that the run took.
    tbb::task_arena arena(1);
    try {
      for (std::size_t job = next++; job < jobs && !time.Lacks(); job = next++) {
        arena.execute([&] { run_job(job); });
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!thrown) thrown = std::current_exception();
      next = jobs;
    }
  };
  std::vector<std::thread> threads;
  const int count = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
  for (int i = 1; i < count; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (thrown) std::rethrow_exception(thrown);

  TrainerStudy study;
  for (const auto& problem : problems) {
    study.best.push_back(problem->Optimum().value_or(std::numeric_limits<double>::infinity()));
  }
  for (std::vector<TrainerRun>& result : results) {
    study.left_out += result.empty() ? 1 : 0;
    for (TrainerRun& run : result) {
      if (!run.trace.empty()) {
        study.best[run.problem] = std::min(study.best[run.problem], run.trace.back().loss);
      }
      study.runs.push_back(std::move(run));
    }
  }
  return study;
}

}  // namespace warplut
