#include "tools/report/trainer/trainer_study.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>

#include "tools/bench/timing.h"
#include "tools/report/section_time.h"
#include "tools/report/trainer/trainer_kernel_fit.h"
#include "train/fit/minimize.h"
#include "train/fit/rivals/golden_section.h"
#include "train/fit/rivals/keys_search.h"
#include "train/ranks/ranks.h"

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

// Runs the jobs first, first + stride, ... on this rank alone; problems would call on all ranks.
void RunJobs(std::span<const std::unique_ptr<const TrainerProblem>> problems,
             const TrainerStudyOptions& options, std::size_t first, std::size_t stride,
             std::vector<std::vector<TrainerRun>>& results) {
  const AloneOnRank alone;
  const SectionTime time(options.seconds);
  const std::size_t jobs = results.size();
  std::atomic<std::size_t> next = first, done = 0;
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto report = [&] {
    const std::lock_guard lock(mutex);
    if (!thrown) options.progress(static_cast<double>(done * stride) / static_cast<double>(jobs));
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
      for (std::size_t job = next.fetch_add(stride); job < jobs && !time.Lacks();
           job = next.fetch_add(stride)) {
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
}

// Completes the runs of the other ranks' jobs.
void ExchangeRuns(std::size_t problems, std::vector<std::vector<TrainerRun>>& results) {
  Ranks& ranks = Ranks::World();
  if (ranks.count() == 1) return;
  std::vector<int> owners;
  std::vector<std::vector<double>> numbers(results.size());
  for (std::size_t job = 0; job < results.size(); ++job) {
    owners.push_back(static_cast<int>(job % static_cast<std::size_t>(ranks.count())));
    for (const TrainerRun& run : results[job]) {
      numbers[job].insert(numbers[job].end(), {static_cast<double>(run.trainer), run.start,
                                               static_cast<double>(run.trace.size())});
      for (const TracePoint& point : run.trace) {
        numbers[job].insert(numbers[job].end(),
                            {static_cast<double>(point.evaluations), point.seconds, point.loss});
      }
    }
  }
  ranks.Exchange(owners, numbers);
  for (std::size_t job = 0; job < results.size(); ++job) {
    results[job].clear();
    std::size_t at = 0;
    const auto next = [&] { return numbers[job].at(at++); };
    while (at < numbers[job].size()) {
      TrainerRun run{.problem = job % problems,
                     .trainer = static_cast<Trainer>(static_cast<int>(next())),
                     .seed = 1 + job / problems,
                     .start = next(),
                     .trace = {}};
      for (auto points = static_cast<std::size_t>(next()); points > 0; --points) {
        TracePoint& point = run.trace.emplace_back();
        point.evaluations = static_cast<int>(next());
        point.seconds = next();
        point.loss = next();
      }
      results[job].push_back(std::move(run));
    }
  }
}

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
  Ranks& ranks = Ranks::World();
  const std::size_t jobs = problems.size() * static_cast<std::size_t>(options.seeds);
  std::vector<std::vector<TrainerRun>> results(jobs);
  const auto first = static_cast<std::size_t>(ranks.rank());
  const auto stride = static_cast<std::size_t>(ranks.count());
  RunJobs(problems, options, first, stride, results);
  ExchangeRuns(problems.size(), results);
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
