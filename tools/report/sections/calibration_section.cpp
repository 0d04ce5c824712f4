#include "tools/report/sections/calibration_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "datasets/error.h"
#include "tools/report/quartiles.h"
#include "tools/report/report_clips.h"
#include "tools/report/section_time.h"
#include "tools/report/sections/calibration_study.h"
#include "train/calibration/clip_crop.h"
#include "train/calibration/clip_loss.h"
#include "train/calibration/search_space.h"

namespace warplut {
namespace {

constexpr const char* kFitted[] = {"sr_depth_threshold", "blend_a", "blend_b"};
constexpr int kMostFrames = 6;
constexpr int kShownRuns[] = {10, 20, 50, 100, 200, 500};

struct StudySize {
  std::size_t clips;
  int pixels;
  CalibrationStudyOptions options;
};

StudySize SizeOf(const ReportInputs& inputs) {
  StudySize size{.clips = 2, .pixels = 16000, .options = {}};
  if (inputs.quick) {
    size.clips = 1;
    size.pixels = 8000;
    size.options.seeds = 3;
    size.options.random_seeds = 7;
    size.options.grids = {2, 3, 4, 6};
  }
  for (const char* name : kFitted) size.options.fitted.push_back(FindParameter(name));
  return size;
}

// A piece of one clip and its study.
struct ClipStudy {
  std::string name;
  GridSize size;
  int frames = 0;
  CalibrationStudy study;
};

std::shared_ptr<const Clip> PieceOf(const ReportClip& clip, int pixels) {
  return std::make_shared<const Clip>(
      CropClip(ReloadClip(clip, Streams::kRenderGrid | Streams::kReference, kMostFrames), pixels));
}

std::unique_ptr<ClipLoss> LossOn(const std::shared_ptr<const Clip>& piece,
                                 const ReportInputs& inputs, Executor& executor) {
  ClipRun run;
  run.clip = piece;
  run.options.method = FindMethod("sr");
  run.options.super_resolution.warp = inputs.pipeline_lut.Warp();
  std::vector<ClipRun> runs;
  runs.push_back(std::move(run));
  return std::make_unique<ClipLoss>(std::move(runs), executor);
}

std::string Spread(const Quartiles& quartiles) {
  return fmt::format("{:.2g} [{:.2g}, {:.2g}]", quartiles.median, quartiles.low, quartiles.high);
}

Quartiles GapsAfter(const std::vector<SearchTrace>& traces, double best, int runs) {
  std::vector<double> gaps;
  for (const SearchTrace& trace : traces) gaps.push_back(trace.After(runs) - best);
  return QuartilesOf(std::move(gaps));
}

// The finest grid that so many runs allow; null if none does.
const GridTrace* GridWithin(const CalibrationStudy& study, int runs) {
  const GridTrace* finest = nullptr;
  for (const GridTrace& grid : study.grids) {
    if (grid.trace.runs() <= runs) finest = &grid;
  }
  return finest;
}

int Longest(const CalibrationStudy& study) {
  int longest = 0;
  for (const SearchTrace& trace : study.calibrations) longest = std::max(longest, trace.runs());
  return longest;
}

PlotSeries TraceSeries(const char* name, const std::vector<SearchTrace>& traces, double best,
                       int longest) {
  PlotSeries series;
  series.name = name;
  series.line = true;
  for (double at = 1; at <= longest; at = std::max(at + 1, at * 1.15)) {
    const int runs = static_cast<int>(at);
    const auto [low, median, high] = GapsAfter(traces, best, runs);
    series.x.push_back(runs);
    series.y.push_back(median);
    series.low.push_back(low);
    series.high.push_back(high);
  }
  return series;
}

ReportPlot GapPlot(const ClipStudy& clip, const std::string& id) {
  const CalibrationStudy& study = clip.study;
  const double best = study.Best().loss.back();
  ReportPlot plot;
  plot.id = id;
  plot.caption = fmt::format(
      "{}: loss above the best known ({:.5f}) against runs of the pipeline, median and quartiles.",
      clip.name, best);
  plot.x_label = "runs of the pipeline";
  plot.y_label = "loss - best";
  plot.logarithmic_x = plot.logarithmic_y = true;
  plot.series.push_back(TraceSeries("calibration", study.calibrations, best, Longest(study)));
  plot.series.push_back(TraceSeries("random", study.random, best, Longest(study)));
  PlotSeries& grid = plot.series.emplace_back();
  grid.name = "grid";
  for (const GridTrace& searched : study.grids) {
    grid.x.push_back(searched.trace.runs());
    grid.y.push_back(searched.trace.loss.back() - best);
    grid.labels.push_back(fmt::format("{0} x {0} x {0}", searched.per_axis));
  }
  return plot;
}

void AddGapRows(const ClipStudy& clip, TextTable& table) {
  const CalibrationStudy& study = clip.study;
  const double best = study.Best().loss.back();
  const int longest = Longest(study);
  for (const int runs : kShownRuns) {
    const GridTrace* grid = GridWithin(study, runs);
    if (runs > longest && grid == nullptr) break;
    table.rows.push_back(
        {clip.name, fmt::format("{}", runs), Spread(GapsAfter(study.calibrations, best, runs)),
         runs <= longest ? Spread(GapsAfter(study.random, best, runs)) : "",
         grid == nullptr ? "" : fmt::format("{:.2g}", grid->trace.loss.back() - best)});
  }
}

std::string ParametersText(const Parameters& parameters) {
  return fmt::format("{:.3g}, {:.3g}, {:.3g}", parameters.sr_depth_threshold, parameters.blend_a,
                     parameters.blend_b);
}

void AddResultRow(const ClipStudy& clip, TextTable& table) {
  const CalibrationStudy& study = clip.study;
  std::vector<double> losses, runs;
  for (const SearchTrace& trace : study.calibrations) {
    losses.push_back(trace.loss.back());
    runs.push_back(trace.runs());
  }
  const SearchTrace& best = *std::min_element(
      study.calibrations.begin(), study.calibrations.end(),
      [](const SearchTrace& a, const SearchTrace& b) { return a.loss.back() < b.loss.back(); });
  table.rows.push_back(
      {clip.name, fmt::format("{} x {}, {} frames", clip.size.width, clip.size.height, clip.frames),
       fmt::format("{:.5f}", study.paper_loss), fmt::format("{:.5f}", study.base_loss),
       fmt::format("{:.5f} in {:.0f}", QuartilesOf(losses).median, QuartilesOf(runs).median),
       ParametersText(best.best),
       fmt::format("{:.5f} in {}", study.Best().loss.back(), study.Best().runs()),
       ParametersText(study.Best().best)});
}

std::vector<std::string> Paragraphs() {
  return {
      "Super resolution, its parameters T_D, a and b, the others at their defaults; the loss is 1 "
      "- SSIM on hard gates, what warplut calibrate minimises. Every search knows the defaults and "
      "the paper's constants at first, and is charged each run of the pipeline, those with gates "
      "of finite width as well.",
      "Calibration: the search of warplut calibrate with two random starts, without the profiles "
      "and standard errors that follow it. Random: uniform over the ranges, logarithmic where "
      "calibration is. Grid: the best of n x n x n points, a point of the plot for each n."};
}

}  // namespace

ReportSection CalibrationSection(const ReportInputs& inputs) {
  const SectionTime time(inputs.seconds);
  ThreadPool executor(inputs.threads);
  const StudySize size = SizeOf(inputs);
  ReportSection section;
  section.id = "calibration";
  section.title = "Calibration";
  section.paragraphs = Paragraphs();
  ReportTable results{.id = "calibration-results",
                      .caption =
                          "1 - SSIM and the runs of the pipeline that it took (median over "
                          "seeds); T_D, a, b of the best calibration, and of the best that any "
                          "search found.",
                      .table = {{"clip", "piece", "paper", "default", "calibration", "T_D, a, b",
                                 "best known", "T_D, a, b there"},
                                {}}};
  ReportTable gaps{.id = "calibration-runs",
                   .caption =
                       "Loss above the best known after so many runs: median [quartiles] over "
                       "seeds; of grids the finest that is done by then.",
                   .table = {{"clip", "runs", "calibration", "random", "grid"}, {}}};
  const std::size_t count = std::min(size.clips, inputs.clips.size());
  for (std::size_t i = 0; i < count; ++i) {
    const ReportClip& clip = inputs.clips[(2 * i + 1) * inputs.clips.size() / (2 * count)];
    CalibrationStudyOptions options = size.options;
    options.progress = [&](double share) {
      inputs.progress((static_cast<double>(i) + share) / static_cast<double>(count), clip.name);
    };
    options.go_on = [&] { return !time.Lacks(); };
    std::shared_ptr<const Clip> piece;
    std::unique_ptr<ClipLoss> loss;
    try {
      piece = PieceOf(clip, size.pixels);
      loss = LossOn(piece, inputs, executor);
    } catch (const Error& error) {
      section.failures.push_back(
          fmt::format("{} could not be calibrated on: {}.", clip.name, error.what()));
      continue;
    }
    const ClipStudy result{clip.name, piece->output, static_cast<int>(piece->frames.size()),
                           StudyCalibration(*loss, options)};
    if (!result.study.complete) {
      section.failures.push_back(
          fmt::format("{} was left out of the comparison of searches: the {:.0f} s of this section "
                      "were spent.",
                      clip.name, inputs.seconds));
      continue;
    }
    AddResultRow(result, results.table);
    AddGapRows(result, gaps.table);
    section.plots.push_back(GapPlot(result, fmt::format("calibration-{}", i + 1)));
  }
  if (!results.table.rows.empty()) {
    section.tables.push_back(std::move(results));
    section.tables.push_back(std::move(gaps));
  }
  return section;
}

}  // namespace warplut
