#include "tools/report/trainer/trainer_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "luts/filters.h"
#include "tools/judge/sequence_scores.h"
#include "tools/report/quartiles.h"
#include "tools/report/section_time.h"
#include "tools/report/trainer/trainer_profile.h"
#include "train/fit/rivals/keys_search.h"
#include "train/metrics/luma.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

constexpr double kTolerances[] = {1e-1, 1e-2, 1e-3};
constexpr int kAmounts = 24;  // of work, in plots

struct StudySize {
  std::size_t contents;
  int seeds, evaluations;
  ProblemSet problems;
};

StudySize SizeOf(const ReportInputs& inputs) {
  StudySize size{.contents = 3, .seeds = 5, .evaluations = 200, .problems = {}};
  if (inputs.quick) {
    size = {.contents = 2, .seeds = 2, .evaluations = 80, .problems = {}};
    size.problems.scales = {1.5};
    size.problems.kernels = {-0.6};
    size.problems.all_horizons = false;
    size.problems.half_grid = 11;
  }
  size.problems.seed = inputs.seed;
  return size;
}

// Of clips that lie evenly among those that are there.
std::vector<Content> Contents(const ReportInputs& inputs, const StudySize& size) {
  std::vector<Content> contents;
  const std::size_t count = std::min(size.contents, inputs.clips.size());
  for (std::size_t i = 0; i < count; ++i) {
    const ReportClip& clip = inputs.clips[i * inputs.clips.size() / count];
    const Image luma =
        Luma(JudgedImage(clip.dense.frames.front().reference.view(), clip.dense.encoding));
    if (std::min(luma.width, luma.height) < size.problems.crop_size) continue;
    contents.push_back({clip.name, luma});
  }
  return contents;
}

// One kind of problems and the trainers that were run on it.
struct Group {
  ProblemKind kind;
  const char* id;
  const char* name;
  std::vector<Trainer> trainers;
};

class Presentation {
 public:
  Presentation(const TrainerStudy& study,
               const std::vector<std::unique_ptr<const TrainerProblem>>& problems, int evaluations)
      : study_(study), problems_(problems), evaluations_(evaluations) {
    groups_ = {{ProblemKind::kObjective,
                "objective",
                "repeated warps",
                {Trainer::kLbfgs, Trainer::kAdam, Trainer::kKeys}},
               {ProblemKind::kKernel,
                "kernel",
                "fit of a kernel",
                {Trainer::kLbfgs, Trainer::kAdam, Trainer::kLevenbergMarquardt, Trainer::kKeys}}};
  }

  void Add(ReportSection& section) const {
    ReportTable gaps{.id = "trainers-gap",
                     .caption =
                         "Gap to the best known loss, (f - best) / (start - best): median "
                         "[quartiles] over problems and seeds.",
                     .table = {}};
    gaps.table.header = {"problems", "trainer", "runs"};
    for (const int part : {4, 2, 1}) {
      gaps.table.header.push_back(fmt::format("{} evaluations", evaluations_ / part));
    }
    gaps.table.header.emplace_back("seconds for all");
    ReportTable solved{
        .id = "trainers-solved",
        .caption =
            "Share of runs with f <= best + tau (start - best) at the end, and "
            "the median work of those that got there.",
        .table = {{"problems", "trainer", "tau", "solved", "evaluations", "seconds"}, {}}};
    for (const Group& group : groups_) {
      for (const Trainer trainer : group.trainers) {
        if (Runs(group, trainer).empty()) continue;
        AddGapRow(group, trainer, gaps.table);
        for (const double tau : kTolerances) AddSolvedRow(group, trainer, tau, solved.table);
      }
      for (const Work work : {Work::kSeconds, Work::kEvaluations}) {
        section.plots.push_back(GapPlot(group, work));
      }
      for (const double tau : kTolerances) {
        for (const Work work : {Work::kSeconds, Work::kEvaluations}) {
          section.plots.push_back(ProfilePlot(group, tau, work));
        }
      }
    }
    section.tables.push_back(std::move(gaps));
    section.tables.push_back(std::move(solved));
    section.tables.push_back(OptimumTable());
  }

 private:
  bool Selects(const Group& group, Trainer trainer, const TrainerRun& run) const {
    return run.trainer == trainer && problems_[run.problem]->kind() == group.kind;
  }

  std::vector<const TrainerRun*> Runs(const Group& group, Trainer trainer) const {
    std::vector<const TrainerRun*> runs;
    for (const TrainerRun& run : study_.runs) {
      if (Selects(group, trainer, run)) runs.push_back(&run);
    }
    return runs;
  }

  Quartiles Gaps(const std::vector<const TrainerRun*>& runs, Work work, double amount) const {
    std::vector<double> gaps;
    for (const TrainerRun* run : runs) {
      gaps.push_back(GapAfter(*run, study_.best[run->problem], work, amount));
    }
    return QuartilesOf(std::move(gaps));
  }

  void AddGapRow(const Group& group, Trainer trainer, TextTable& table) const {
    const std::vector<const TrainerRun*> runs = Runs(group, trainer);
    std::vector<std::string> row = {group.name, Name(trainer), fmt::format("{}", runs.size())};
    for (const int part : {4, 2, 1}) {
      const auto [low, median, high] = Gaps(runs, Work::kEvaluations, evaluations_ / part);
      row.push_back(fmt::format("{:.2g} [{:.2g}, {:.2g}]", median, low, high));
    }
    std::vector<double> seconds;
    for (const TrainerRun* run : runs) seconds.push_back(run->trace.back().seconds);
    row.push_back(fmt::format("{:.2f}", QuartilesOf(seconds).median));
    table.rows.push_back(std::move(row));
  }

  void AddSolvedRow(const Group& group, Trainer trainer, double tau, TextTable& table) const {
    std::vector<double> evaluations, seconds;
    const std::vector<const TrainerRun*> runs = Runs(group, trainer);
    for (const TrainerRun* run : runs) {
      const double best = study_.best[run->problem];
      const double needed = WorkToSolve(*run, best, tau, Work::kEvaluations);
      if (!std::isfinite(needed)) continue;
      evaluations.push_back(needed);
      seconds.push_back(WorkToSolve(*run, best, tau, Work::kSeconds));
    }
    const double share = static_cast<double>(evaluations.size()) / static_cast<double>(runs.size());
    std::vector<std::string> row = {group.name, Name(trainer), fmt::format("{:g}", tau),
                                    fmt::format("{:.0f} %", 100 * share)};
    if (!evaluations.empty()) {
      row.push_back(fmt::format("{:.0f}", QuartilesOf(evaluations).median));
      row.push_back(fmt::format("{:.2f}", QuartilesOf(seconds).median));
    }
    table.rows.push_back(std::move(row));
  }

  // Evenly spaced in their logarithm, from the first evaluation of any run of the group to its last
  // gain.
  std::vector<double> Amounts(const Group& group, Work work) const {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const Trainer trainer : group.trainers) {
      for (const TrainerRun* run : Runs(group, trainer)) {
        const auto amount = [&](const TracePoint& point) {
          return work == Work::kSeconds ? point.seconds : point.evaluations;
        };
        least = std::min(least, amount(run->trace.front()));
        most = std::max(most, amount(run->trace.back()));
      }
    }
    std::vector<double> amounts;
    if (!(most > 0)) return amounts;
    for (int i = 0; i < kAmounts; ++i) {
      amounts.push_back(least * std::pow(most / least, i / (kAmounts - 1.0)));
    }
    return amounts;
  }

  ReportPlot Plot(const char* what, const Group& group, Work work, std::string caption) const {
    const bool seconds = work == Work::kSeconds;
    ReportPlot plot;
    plot.id = fmt::format("trainers-{}-{}-{}", group.id, what, seconds ? "seconds" : "evaluations");
    plot.caption = std::move(caption);
    plot.x_label = seconds ? "processor seconds" : "evaluations";
    plot.logarithmic_x = true;
    return plot;
  }

  ReportPlot GapPlot(const Group& group, Work work) const {
    ReportPlot plot =
        Plot("gap", group, work,
             fmt::format("{}: gap to the best known loss, median and quartiles.", group.name));
    plot.y_label = "(f - best) / (start - best)";
    plot.logarithmic_y = true;
    for (const Trainer trainer : group.trainers) {
      const std::vector<const TrainerRun*> runs = Runs(group, trainer);
      if (runs.empty()) continue;
      PlotSeries& series = plot.series.emplace_back();
      series.name = Name(trainer);
      series.line = true;
      for (const double amount : Amounts(group, work)) {
        const auto [low, median, high] = Gaps(runs, work, amount);
        series.x.push_back(amount);
        series.y.push_back(median);
        series.low.push_back(low);
        series.high.push_back(high);
      }
    }
    return plot;
  }

  ReportPlot ProfilePlot(const Group& group, double tau, Work work) const {
    const int exponent = static_cast<int>(std::lround(-std::log10(tau)));
    ReportPlot plot = Plot(fmt::format("profile-{}", exponent).c_str(), group, work,
                           fmt::format("{}: share of runs solved to tau = {:g}.", group.name, tau));
    plot.y_label = "share solved";
    for (const Trainer trainer : group.trainers) {
      if (Runs(group, trainer).empty()) continue;
      PlotSeries& series = plot.series.emplace_back();
      series.name = Name(trainer);
      series.line = true;
      series.x = Amounts(group, work);
      series.y = DataProfile(
          study_, [&](const TrainerRun& run) { return Selects(group, trainer, run); }, tau, work,
          series.x);
    }
    return plot;
  }

  // Half-pixel warps, whose optimum is known.
  ReportTable OptimumTable() const {
    ReportTable table{
        .id = "trainers-half-pixel",
        .caption =
            "Half-pixel warps: 1 - SSIM (with what the bound on gain adds) of "
            "the best symmetric 4 x 4 kernel, found by exhaustive search, and "
            "of what trainers end with, median over seeds.",
        .table = {{"problem", "Catmull-Rom", "best Keys", "Adam", "L-BFGS", "exhaustive search"},
                  {}}};
    for (std::size_t p = 0; p < problems_.size(); ++p) {
      const TrainerProblem& problem = *problems_[p];
      if (problem.kind() != ProblemKind::kObjective || !problem.Optimum()) continue;
      std::vector<std::string> row = {
          problem.name(), fmt::format("{:.5f}", problem.Loss(KeysCanonicalWeights(kCatmullRomA)))};
      for (const Trainer trainer : {Trainer::kKeys, Trainer::kAdam, Trainer::kLbfgs}) {
        std::vector<double> losses;
        for (const TrainerRun& run : study_.runs) {
          if (run.problem == p && run.trainer == trainer) losses.push_back(run.trace.back().loss);
        }
        row.push_back(losses.empty() ? "" : fmt::format("{:.5f}", QuartilesOf(losses).median));
      }
      row.push_back(fmt::format("{:.5f}", *problem.Optimum()));
      table.table.rows.push_back(std::move(row));
    }
    return table;
  }

  const TrainerStudy& study_;
  const std::vector<std::unique_ptr<const TrainerProblem>>& problems_;
  int evaluations_;
  std::vector<Group> groups_;
};

std::vector<std::string> Paragraphs(const StudySize& size, std::size_t problems) {
  return {
      fmt::format(
          "{} problems, {} seeds, at most {} evaluations for each run. Repeated warps: objective "
          "warp with the bound on gain, in one stage with the exponent by which fits are finally "
          "judged, on {} crops of {} x {} pixels of a frame of each content, with the horizons of "
          "an upscale factor; near starts lie by Catmull-Rom, as in warplut train, far ones do "
          "not. Half: {} half-pixel warps alone, where the best kernel of all has two free weights "
          "and is found by exhaustive search. Fits of a kernel: the MLP against a Keys kernel with "
          "the first moment of the head.",
          problems, size.seeds, size.evaluations, size.problems.crops, size.problems.crop_size,
          size.problems.crop_size, size.problems.half_warps),
      "L-BFGS is what warplut train runs, Adam the paper's recipe (learning rate 1e-3), best Keys "
      "a golden section over its one parameter. Levenberg-Marquardt needs residuals that become "
      "small: it applies to the fit of a kernel. Of repeated warps each piece loses 1 - SSIM, "
      "which no weights bring near to 0, the power mean of pieces is no sum of squares, and a "
      "Gauss-Newton matrix of some tens of pieces says nothing about 3744 parameters; there it is "
      "left out.",
      "The best known loss is the least of all runs, or the known optimum: of the exhaustive "
      "search, and 0 for the fit of a kernel, which the MLP can come near to without end. An "
      "evaluation is one of the loss, with or without gradient; a step of conjugate gradients "
      "inside Levenberg-Marquardt counts as one. Seconds are of one processor."};
}

}  // namespace

ReportSection TrainerSection(const ReportInputs& inputs) {
  const SectionTime time(inputs.seconds);
  const StudySize size = SizeOf(inputs);
  ReportSection section;
  section.id = "trainers";
  section.title = "Trainers";
  const std::vector<Content> contents = Contents(inputs, size);
  if (contents.empty()) {
    section.failures.push_back(
        fmt::format("No clip has {0} x {0} pixels, which a crop takes: trainers were not compared.",
                    size.problems.crop_size));
    return section;
  }
  inputs.progress(0, "known optima");
  const auto problems = [&] {
    const AloneOnRank alone;  // each rank makes them all
    return MakeProblems(size.problems, contents);
  }();
  section.paragraphs = Paragraphs(size, problems.size());
  const TrainerStudy study = StudyTrainers(
      problems, {.seeds = size.seeds,
                 .evaluations = size.evaluations,
                 .threads = inputs.threads,
                 .seconds = std::max(0.0, inputs.seconds - time.Spent()),
                 .progress = [&](double share) { inputs.progress(share, "trainers"); }});
  if (study.left_out > 0) {
    section.failures.push_back(fmt::format(
        "{} of {} pairs of a problem and a seed were left out: the {:.0f} s of this section were "
        "spent.",
        study.left_out, problems.size() * static_cast<std::size_t>(size.seeds), inputs.seconds));
  }
  if (!study.runs.empty()) Presentation(study, problems, size.evaluations).Add(section);
  return section;
}

}  // namespace warplut
