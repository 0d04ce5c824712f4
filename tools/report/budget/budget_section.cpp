#include "tools/report/budget/budget_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "datasets/error.h"
#include "tools/judge/sequence_scores.h"
#include "tools/report/budget/budget_generation.h"
#include "tools/report/budget/budget_motion.h"
#include "tools/report/budget/budget_super_resolution.h"
#include "tools/report/section_time.h"
#include "train/metrics/psnr.h"
#include "train/metrics/same_surface.h"

namespace warplut {
namespace {

constexpr const char* kMethodNames[] = {"sr", "i", "e"};

// The stream that a clip lacks, or null.
const char* MissingStream(const Clip& clip) {
  for (const ClipFrame& frame : clip.frames) {
    if (const char* stream = MissingStream(frame, clip, Streams::kAll)) return stream;
  }
  return nullptr;
}

ErrorBudget BudgetOf(const ReportClip& clip, const ModeRunOptions& options, Executor& executor) {
  const MethodInfo& method = *options.method;
  if (method.generation == Generation::kNone) {
    return SuperResolutionBudget(clip.dense, EffectiveSuperResolution(clip.dense, options),
                                 executor);
  }
  return GenerationBudget(clip.dense, clip.sparse, method.generation,
                          EffectiveGeneration(clip.sparse, options), executor);
}

std::string Percent(double share) { return fmt::format("{:.1f}", 100 * share); }

ReportTable ShareTable(const MethodBudget& budget, const std::vector<ErrorBudget>& rows) {
  ReportTable table{.id = fmt::format("budget-{}", budget.method->name),
                    .caption = fmt::format(
                        "{}: shares of the mean squared error in percent, in the order of "
                        "replacement. MSE is in units of 1e-4 with exact motion, as the method "
                        "is shown; 100 % is the error with motion in halves.",
                        budget.method->meaning),
                    .table = {}};
  table.table.header = {"clip", "frames", "MSE", "PSNR", "SSIM"};
  for (const BudgetCause& cause : budget.plan.causes) table.table.header.emplace_back(cause.name);
  table.table.header.emplace_back(budget.plan.remainder.name);
  for (const ErrorBudget& row : rows) {
    const FrameScore& shown = row.rungs[kExactMotionRung];
    std::vector<std::string> cells = {row.clip, fmt::format("{}", row.frames),
                                      fmt::format("{:.2f}", 1e4 * shown.mean_squared_error),
                                      fmt::format("{:.2f}", shown.psnr),
                                      fmt::format("{:.4f}", shown.ssim)};
    for (const double share : row.Shares()) cells.push_back(Percent(share));
    table.table.rows.push_back(std::move(cells));
  }
  return table;
}

ReportTable RungTable(const MethodBudget& budget, const ErrorBudget& mean) {
  ReportTable table{
      .id = fmt::format("budget-{}-rungs", budget.method->name),
      .caption = fmt::format("{}: what is left after each replacement, means over clips.",
                             budget.method->meaning),
      .table = {{"in place of", "stands", "MSE 1e-4", "PSNR", "SSIM"}, {}}};
  for (int k = 0; k < budget.plan.rungs(); ++k) {
    const FrameScore& rung = mean.rungs[static_cast<std::size_t>(k)];
    const BudgetCause* cause =
        k == 0 ? nullptr : &budget.plan.causes[static_cast<std::size_t>(k - 1)];
    table.table.rows.push_back({cause == nullptr ? "nothing" : cause->name,
                                cause == nullptr ? "motion in halves" : cause->replacement,
                                fmt::format("{:.3f}", 1e4 * rung.mean_squared_error),
                                fmt::format("{:.2f}", rung.psnr),
                                fmt::format("{:.4f}", rung.ssim)});
  }
  return table;
}

PlotSeries RungSeries(const MethodBudget& budget, const ErrorBudget& mean) {
  PlotSeries series;
  series.name = budget.method->name;
  series.line = true;
  for (int k = 0; k < budget.plan.rungs(); ++k) {
    series.x.push_back(k);
    series.y.push_back(mean.rungs[static_cast<std::size_t>(k)].mean_squared_error);
    series.labels.emplace_back(k == 0 ? ""
                                      : budget.plan.causes[static_cast<std::size_t>(k - 1)].name);
  }
  return series;
}

// The causes from the largest share down, as far as they make a tenth.
std::string Ranking(const MethodBudget& budget, const ErrorBudget& mean) {
  const std::vector<double> shares = mean.Shares();
  std::vector<std::size_t> order(shares.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return shares[a] > shares[b]; });
  std::string text;
  for (const std::size_t k : order) {
    if (shares[k] < 0.1) break;
    const BudgetCause& cause =
        k < budget.plan.causes.size() ? budget.plan.causes[k] : budget.plan.remainder;
    text += fmt::format("{}{} {} %", text.empty() ? "" : ", ", cause.name, Percent(shares[k]));
  }
  return fmt::format("{} ({}): {}.", budget.method->meaning, budget.method->name, text);
}

}  // namespace

BudgetStudy StudyBudget(const ReportInputs& inputs) {
  const SectionTime time(inputs.seconds);
  ThreadPool executor(inputs.threads);
  BudgetStudy study;
  for (const char* name : kMethodNames) {
    const MethodInfo& method = *FindMethod(name);
    study.methods.push_back({.method = &method,
                             .plan = method.generation == Generation::kNone
                                         ? SuperResolutionPlan()
                                         : GenerationPlan(method.generation),
                             .clips = {}});
  }
  double longest = 0;  // seconds of a clip
  double done = 0;
  for (const ReportClip& clip : inputs.clips) {
    const double begin = time.Spent();
    if (const char* stream = MissingStream(clip.dense)) {
      study.failures.push_back(fmt::format(
          "{} has no stream '{}', without which its error cannot be divided.", clip.name, stream));
    } else if (time.Lacks(longest)) {
      study.failures.push_back(fmt::format(
          "{} was left out of the error budget: the {:.0f} s of this section were spent.",
          clip.name, inputs.seconds));
    } else {
      for (MethodBudget& budget : study.methods) {
        inputs.progress(done / static_cast<double>(inputs.clips.size()),
                        fmt::format("{}, {}", clip.name, budget.method->name));
        const ModeRunOptions options = ReportRunOptions(inputs, *budget.method);
        try {
          budget.clips.push_back(BudgetOf(clip, options, executor));
        } catch (const Error& error) {
          study.failures.push_back(fmt::format("{} has no budget of {}: {}.", clip.name,
                                               budget.method->name, error.what()));
        }
        done += 1.0 / static_cast<double>(study.methods.size());
      }
      longest = std::max(longest, time.Spent() - begin);
    }
  }
  std::erase_if(study.methods, [](const MethodBudget& budget) { return budget.clips.empty(); });
  return study;
}

ReportSection BudgetSection(const ReportInputs& inputs) {
  const BudgetStudy study = StudyBudget(inputs);
  ReportSection section;
  section.id = "budget";
  section.title = "Where the error comes from";
  section.failures = study.failures;
  section.paragraphs = {
      "One cause of error after the other is replaced by ground truth, and the drop of the mean "
      "squared error is its share, so that the shares of a row add up to 100 %. They depend on the "
      "order, which is that of the columns; a share below zero says that the replacement did harm.",
      fmt::format(
          "Truth is what the sequence holds: references, exact motion and depth of the output "
          "grid. A surface was visible if its depth where it came from differs by at most {:g} of "
          "itself; its shading changed if the mean luma of its 5 x 5 pixels, followed along the "
          "exact motion, differs by more than {:g}: that share no warp can have. The best blend "
          "looks at the reference and so is out of reach of any rule; its share is an upper bound "
          "of what a better one could gain.",
          kSameSurface, kShadingChange),
      fmt::format(
          "Motion in halves: a game stores it as a share of the screen from 0 to 1, here in half "
          "floats, as a {} x {} display has it, or in two bytes, with steps 16 to 32 times finer. "
          "Samples (super resolution): the frame before and the shares of new samples are kept, "
          "the samples are values of the reference itself instead of aliased ones of the render "
          "grid. What remains is resampling: of a loop that repeats its warps, or of one warp "
          "where frames are generated. Frames after a cut are left out.",
          kStoredDisplay.width, kStoredDisplay.height),
      "Largest shares in the mean over clips."};
  ReportPlot plot{.id = "budget-ladder",
                  .caption =
                      "Mean squared error that is left after each replacement, means over "
                      "clips.",
                  .x_label = "replacements",
                  .y_label = "mean squared error",
                  .logarithmic_y = true,
                  .series = {}};
  for (const MethodBudget& budget : study.methods) {
    const ErrorBudget mean = MeanBudget("mean", budget.clips);
    std::vector<ErrorBudget> rows = budget.clips;
    rows.push_back(mean);
    section.paragraphs.back() += " " + Ranking(budget, mean);
    section.tables.push_back(ShareTable(budget, rows));
    section.tables.push_back(RungTable(budget, mean));
    plot.series.push_back(RungSeries(budget, mean));
  }
  section.plots.push_back(std::move(plot));
  return section;
}

}  // namespace warplut
