#include "tools/report/sections/omissions_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/judge/sequence_scores.h"
#include "tools/pipeline.h"
#include "tools/profile/profile_report.h"
#include "tools/report/report_clips.h"
#include "tools/report/section_time.h"

namespace warplut {
namespace {

constexpr const char* kMethod = "sr";
constexpr int kFrames = 7, kQuickFrames = 5;

// Built-in scenes in the order in which they show what can be left out: a camera at rest, changing
// light, disocclusion.
constexpr std::array<std::string_view, 3> kFirst = {"still", "plaza", "colonnade"};

std::vector<const ReportClip*> InOrder(const std::vector<ReportClip>& clips) {
  std::vector<const ReportClip*> order;
  for (const ReportClip& clip : clips) order.push_back(&clip);
  const auto place = [](const ReportClip* clip) {
    return clip->built_in ? std::find(kFirst.begin(), kFirst.end(), clip->name) - kFirst.begin()
                          : 0;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](const ReportClip* a, const ReportClip* b) { return place(a) < place(b); });
  return order;
}

ProfileReport Profile(const ReportInputs& inputs, const ReportClip& clip,
                      const std::function<void(double)>& step) {
  const ModeRunOptions options = ReportRunOptions(inputs, MethodOf(kMethod));
  const Clip& dense = clip.dense;
  const bool one_grid = dense.render == dense.output;
  const int frames = inputs.quick ? kQuickFrames : kFrames;
  std::vector<ProfileClip> clips;
  clips.push_back({.input = ReloadClip(clip, Streams::kRenderGrid, frames),
                   .truth = ReloadClip(clip, kTruthStreams, frames),
                   .has_reference = true});
  ProfileReport report{.version = {},
                       .mode = kMethod,
                       .filter = inputs.pipeline_lut.name,
                       .within = kReportWithin,
                       .sequences = {{.name = clip.name, .sha1 = {}}},
                       .searched_frames = {},
                       .full = FullPipeline(options, one_grid),
                       .result = {},
                       .tables = {},
                       .table = {},
                       .tiles = {},
                       .time_by_tiles = {}};
  PipelineMeter meter(std::move(clips), report.full, options, inputs.threads, [] {});
  const ProfileSearch search(report.full, kReportWithin, step);
  report.result = search.Search(meter);
  search.Check(meter, ShippedPipeline(options, one_grid), &report.result);
  report.tiles = CountTiles(meter, report.full);
  report.time_by_tiles = TimeByTiles(meter, report.full, kRoundPasses);
  return report;
}

std::vector<std::string> SummaryRow(const ProfileReport& report) {
  const ProfileResult& result = report.result;
  std::vector<std::string> taken;
  for (const OmissionTrial& trial : result.taken) taken.emplace_back(trial.omission->name);
  return {report.sequences.front().name,
          fmt::format("{:.2f}", result.checked_full_milliseconds),
          fmt::format("{:.2f}", result.checked.time.median),
          fmt::format("{:.2f}", result.shipped.time.median),
          fmt::format("{:.5f}", result.checked.loss),
          fmt::format("{:.2f}", report.time_by_tiles.median),
          taken.empty() ? "nothing" : fmt::format("{}", fmt::join(taken, ", "))};
}

PlotSeries AloneSeries(const ProfileReport& report) {
  PlotSeries series{.name = report.sequences.front().name};
  for (const OmissionTrial& trial : report.result.alone) {
    series.x.push_back(100 * (1 - trial.cost.time.median));
    series.y.push_back(trial.cost.loss);
    series.labels.emplace_back(trial.omission->name);
  }
  return series;
}

}  // namespace

ReportSection OmissionsSection(const ReportInputs& inputs) {
  ReportSection section{.id = "omissions", .title = "What content can do without"};
  section.paragraphs = {fmt::format(
      "The full pipeline of {} has every pass on. Each pass is left out or made cheaper alone, "
      "then greedily several together as long as the SSIM lost against the full pipeline stays "
      "within {}; one sequence at a time, with its first frames. Times are shares of that of the "
      "full pipeline, processor time of one thread. `warplut profile` does the same for content as "
      "a whole and writes the pipeline that is left as a constexpr configuration.",
      kMethod, kReportWithin)};
  ReportTable summary{
      .id = "omissions",
      .caption = "The cheapest pipeline within the bound, for each sequence alone",
      .table = {.header = {"sequence", "full ms", "chosen / full", "as shipped / full", "SSIM lost",
                           "time by tiles", "left out"},
                .rows = {}}};
  ReportPlot plot{.id = "omissions-alone",
                  .caption = "Each pass left out alone: what it loses against the time it saves",
                  .x_label = "time saved, %",
                  .y_label = "SSIM lost",
                  .series = {}};
  std::vector<ReportTable> details;
  const SectionTime time(inputs.seconds);
  const std::vector<const ReportClip*> clips = InOrder(inputs.clips);
  std::vector<std::string> left;
  for (const ReportClip* clip : clips) {
    const auto done = static_cast<double>(summary.table.rows.size());
    if (done > 0 && time.Lacks(time.Spent() / done)) {
      left.push_back(clip->name);
      continue;
    }
    const ProfileReport report = Profile(inputs, *clip, [&](double share) {
      inputs.progress((done + share) / static_cast<double>(clips.size()), clip->name);
    });
    summary.table.rows.push_back(SummaryRow(report));
    plot.series.push_back(AloneSeries(report));
    details.push_back({.id = "omissions-alone-" + clip->name,
                       .caption = clip->name + ": each pass alone",
                       .table = AloneTable(report)});
    details.push_back({.id = "omissions-together-" + clip->name,
                       .caption = clip->name + ": taken one after the other",
                       .table = TogetherTable(report)});
    details.push_back({.id = "omissions-tiles-" + clip->name,
                       .caption = clip->name + ": shares of tiles",
                       .table = TileTable(report)});
  }
  section.plots.push_back(std::move(plot));
  section.tables.push_back(std::move(summary));
  section.tables.insert(section.tables.end(), std::make_move_iterator(details.begin()),
                        std::make_move_iterator(details.end()));
  if (!left.empty()) {
    section.failures.push_back(
        fmt::format("{} left out: the time of the section was over.", fmt::join(left, ", ")));
  }
  return section;
}

}  // namespace warplut
