#include "tools/report/sections/pipelines_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "datasets/error.h"
#include "tools/bench/timed_executor.h"
#include "tools/judge/sequence_report.h"
#include "tools/judge/sequence_scores.h"
#include "tools/report/pareto.h"
#include "tools/report/section_time.h"
#include "tools/report/sections/pipeline_pictures.h"

namespace warplut {
namespace {

using MethodList = std::vector<const MethodInfo*>;

constexpr std::size_t kPictureClips = 3;

// Methods that show frames of one kind, from inputs of one kind: only those are compared.
enum class Group : std::uint8_t { kUpscaled, kGenerated, kBoth };
constexpr Group kGroups[] = {Group::kUpscaled, Group::kGenerated, Group::kBoth};

constexpr const char* Name(Group group) {
  return group == Group::kUpscaled    ? "super resolution"
         : group == Group::kGenerated ? "frame generation"
                                      : "both";
}

Group GroupOf(const MethodInfo& method) {
  if (method.generation == Generation::kNone) return Group::kUpscaled;
  return method.super_resolution ? Group::kBoth : Group::kGenerated;
}

// The scores of one resolution.
struct Scores {
  std::string id;    // "small", "large"
  std::string size;  // "480 x 270"
  MethodList methods;
  std::vector<SequenceReport> clips;
};

std::string SizeText(const std::vector<ReportClip>& clips) {
  std::set<std::string> sizes;
  for (const ReportClip& clip : clips) {
    sizes.insert(fmt::format("{} x {}", clip.dense.output.width, clip.dense.output.height));
  }
  return fmt::format("{}", fmt::join(sizes, ", "));
}

std::string CountText(std::size_t sequences) {
  return fmt::format("{} sequence{}", sequences, sequences == 1 ? "" : "s");
}

class PipelineStudy {
 public:
  PipelineStudy(const ReportInputs& inputs, ReportSection& section)
      : inputs_(inputs), section_(section), time_(inputs.seconds) {}

  std::optional<Scores> Judge(const std::string& id, const std::vector<ReportClip>& clips) {
    Scores scores{.id = id, .size = SizeText(clips), .methods = Runnable(clips), .clips = {}};
    const double before = time_.Spent();
    for (const ReportClip& clip : clips) {
      const auto done = static_cast<double>(scores.clips.size());
      if (done > 0 && time_.Lacks((time_.Spent() - before) / done)) {
        section_.failures.push_back(fmt::format(
            "{} and what comes after it at {} are left out: the time of the section was over.",
            clip.name, scores.size));
        break;
      }
      scores.clips.push_back(JudgeClip(clip, scores.methods));
    }
    if (scores.clips.empty() || scores.methods.empty()) return std::nullopt;
    return scores;
  }

  void AddPictures() {
    std::size_t made = 0;
    // The scenes that the tables were not fitted on come last.
    for (auto clip = inputs_.clips.rbegin(); clip != inputs_.clips.rend(); ++clip) {
      if (made == kPictureClips) return;
      if (time_.Lacks()) {
        section_.failures.emplace_back(
            "Some pictures are left out: the time of the section was over.");
        return;
      }
      inputs_.progress(0.95, "pictures of " + clip->name);
      for (ReportPicture& picture : PipelinePictures(inputs_, *clip, executor_)) {
        section_.pictures.push_back(std::move(picture));
      }
      ++made;
    }
  }

  std::size_t runs = 0;  // of a method on a clip, that are to be done

 private:
  // The methods that every clip has the streams for.
  MethodList Runnable(const std::vector<ReportClip>& clips) {
    MethodList methods;
    for (const MethodInfo& method : Methods()) {
      std::string why;
      const bool valid = std::all_of(clips.begin(), clips.end(), [&](const ReportClip& clip) {
        return ReportRunOptions(inputs_, method)
            .IsValid(clip.ClipFor(method.generation != Generation::kNone), &why);
      });
      if (valid) {
        methods.push_back(&method);
      } else {
        section_.failures.push_back(fmt::format("{} is left out: {}.", method.name, why));
      }
    }
    return methods;
  }

  SequenceReport JudgeClip(const ReportClip& clip, const MethodList& methods) {
    SequenceReport report{.sequence = clip.name, .methods = {}};
    for (const MethodInfo* method : methods) {
      SequenceJudge judge(clip.dense, *method);
      TimedExecutor executor;
      std::vector<double> marks;  // processor time when each frame was made
      RunMode(clip.ClipFor(method->generation != Generation::kNone),
              ReportRunOptions(inputs_, *method), executor, [&](const ShownFrame& shown) {
                inputs_.progress(0.95 * static_cast<double>(done_) /
                                     static_cast<double>(std::max<std::size_t>(runs, 1)),
                                 clip.name);
                if (shown.seconds > 0) marks.push_back(executor.milliseconds());
                judge.Add(shown);
              });
      ++done_;
      report.methods.push_back(judge.Finish());
      if (marks.size() > 1 && marks.back() > marks.front()) {
        report.methods.back().milliseconds =
            (marks.back() - marks.front()) / static_cast<double>(marks.size() - 1);
      }
    }
    return report;
  }

  const ReportInputs& inputs_;
  ReportSection& section_;
  const SectionTime time_;
  SerialExecutor executor_;
  std::size_t done_ = 0;
};

// For each method the name of one of its group that is no slower and no worse, or "-".
std::vector<std::string> DominatedBy(const MethodList& methods, const SequenceReport& mean) {
  std::vector<std::string> names(methods.size(), "-");
  for (const Group group : kGroups) {
    std::vector<std::size_t> members;
    std::vector<CostPoint> points;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (GroupOf(*methods[m]) != group) continue;
      members.push_back(m);
      points.push_back({mean.methods[m].milliseconds, 1 - mean.methods[m].mean.ssim});
    }
    const auto dominators = Dominators(points);
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (dominators[i]) names[members[i]] = methods[members[*dominators[i]]]->name;
    }
  }
  return names;
}

ReportTable MeanTable(const Scores& scores, const SequenceReport& mean) {
  ReportTable table{
      .id = "pipelines-" + scores.id,
      .caption = fmt::format("Means over {}, {}", CountText(scores.clips.size()), scores.size),
      .table = MethodTable(mean)};
  const std::vector<std::string> dominated = DominatedBy(scores.methods, mean);
  table.table.header[0] = "method";
  table.table.header.insert(table.table.header.end(), {"dominated by", "what it is"});
  for (std::size_t m = 0; m < scores.methods.size(); ++m) {
    std::vector<std::string>& row = table.table.rows[m];
    row.insert(row.end(), {dominated[m], scores.methods[m]->meaning});
  }
  return table;
}

ReportTable SceneTable(const Scores& scores) {
  ReportTable table{
      .id = "pipelines-scenes-" + scores.id,
      .caption = "Every sequence, " + scores.size,
      .table = {.header = {"sequence", "method", "PSNR dB", "SSIM", "temporal", "ms/frame"},
                .rows = {}}};
  for (const SequenceReport& report : scores.clips) {
    for (std::vector<std::string> row : MethodTable(report).rows) {
      row.insert(row.begin(), report.sequence);
      table.table.rows.push_back(std::move(row));
    }
  }
  return table;
}

ReportPlot ScorePlot(const Scores& scores, const SequenceReport& mean) {
  ReportPlot plot{.id = "pipelines-" + scores.id,
                  .caption = fmt::format("Error against time, means over {}, {}; the groups do "
                                         "not compare with each other",
                                         CountText(scores.clips.size()), scores.size),
                  .x_label = "ms per frame, one thread",
                  .y_label = "1 - SSIM",
                  .logarithmic_x = true,
                  .logarithmic_y = true,
                  .series = {}};
  for (const Group group : kGroups) {
    PlotSeries series{.name = Name(group)};
    for (std::size_t m = 0; m < scores.methods.size(); ++m) {
      // What repeats a frame takes no time that could be drawn.
      if (GroupOf(*scores.methods[m]) != group) continue;
      if (scores.methods[m]->generator == Generator::kRepeat) continue;
      series.x.push_back(mean.methods[m].milliseconds);
      series.y.push_back(1 - mean.methods[m].mean.ssim);
      series.labels.emplace_back(scores.methods[m]->name);
    }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

ReportSection PipelinesSection(const ReportInputs& inputs) {
  ReportSection section{.id = "pipelines", .title = "Pipelines: error against time"};
  section.paragraphs = {
      fmt::format("Every method of the registry with its default parameters and the table '{}', "
                  "judged by the references: PSNR over "
                  "RGB, SSIM of luma, {} pixels at each edge cut, and the temporal error, the "
                  "change of the error along the motion. Super "
                  "resolution is judged from the second frame on; methods that generate see one "
                  "frame in {} and are judged by the "
                  "frames between.",
                  inputs.pipeline_lut.name, kScoreBorder, kReportEvery),
      "Time is processor time of the passes on one thread, the mean over the frames that were made "
      "but the first (of the baselines "
      "repeat and average, which have no passes, wall time). A method "
      "is dominated by one that shows the same kind of frames, no slower and with no less SSIM."};
  PipelineStudy study(inputs, section);
  study.runs = Methods().size() * (inputs.clips.size() + inputs.larger_clips.size());
  for (const auto& [id, clips] :
       {std::pair<const char*, const std::vector<ReportClip>&>{"small", inputs.clips},
        {"large", inputs.larger_clips}}) {
    if (clips.empty()) continue;
    const std::optional<Scores> scores = study.Judge(id, clips);
    if (!scores) continue;
    const SequenceReport mean = MeanReport(scores->clips);
    section.plots.push_back(ScorePlot(*scores, mean));
    section.tables.push_back(MeanTable(*scores, mean));
    section.tables.push_back(SceneTable(*scores));
  }
  if (inputs.larger_clips.empty()) {
    section.failures.emplace_back("There is one resolution: the sequences have no second one.");
  }
  study.AddPictures();
  return section;
}

}  // namespace warplut
