#include "tools/report/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <set>
#include <utility>

#include "datasets/error.h"
#include "datasets/file.h"
#include "tools/report/budget/budget_section.h"
#include "tools/report/kernels/growth_section.h"
#include "tools/report/kernels/kernels_section.h"
#include "tools/report/page/svg_plot.h"
#include "tools/report/report_clips.h"
#include "tools/report/report_files.h"
#include "tools/report/report_lut.h"
#include "tools/report/section_time.h"
#include "tools/report/sections/calibration_section.h"
#include "tools/report/sections/hardware_section.h"
#include "tools/report/sections/omissions_section.h"
#include "tools/report/sections/pipelines_section.h"
#include "tools/report/sections/stability_section.h"
#include "tools/report/trainer/trainer_section.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/terminal/warning.h"
#include "tools/thread_limit.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

constexpr ReportSectionInfo kSections[] = {
    {"kernels", 120, 30, KernelsSection},
    {"pipelines", 100, 25, PipelinesSection},
    {"budget", 60, 10, BudgetSection},
    {"trainers", 300, 25, TrainerSection, true},
    {"calibration", 120, 15, CalibrationSection},
    {"growth", 50, 10, GrowthSection},
    {"stability", 120, 20, StabilitySection},
    {"omissions", 110, 25, OmissionsSection},
    {"hardware", 1, 1, HardwareSection},
};

void StopIfInterrupted() { ThrowIfInterrupted("report", "the page was not written"); }

const ReportSectionInfo* FindSection(const std::string& id) {
  const auto found = std::find_if(std::begin(kSections), std::end(kSections),
                                  [&](const ReportSectionInfo& one) { return id == one.id; });
  return found == std::end(kSections) ? nullptr : found;
}

double SecondsOf(const ReportSectionInfo& info, bool quick) {
  return quick ? info.quick_seconds : info.seconds;
}

std::vector<ReportSectionInfo> Chosen(const ReportOptions& options) {
  std::vector<ReportSectionInfo> chosen;
  for (const ReportSectionInfo& info : kSections) {
    const auto& ids = options.sections;
    if (ids.empty() || std::find(ids.begin(), ids.end(), info.id) != ids.end())
      chosen.push_back(info);
  }
  return chosen;
}

std::vector<ReportClip> Render(const ReportOptions& options, const ReportScenes& scenes,
                               const char* label) {
  Progress progress(label, CountFrames(scenes), "frames");
  int rendered = 0;
  return RenderReportClips(scenes, options.seed, options.threads, options.folder / "scenes",
                           [&](const std::string& scene) {
                             StopIfInterrupted();
                             progress.Update(static_cast<double>(rendered++), scene);
                           });
}

// " --sequence A B", or "".
std::string SequencesOption(const ReportOptions& options) {
  if (options.sequences.empty()) return {};
  return fmt::format(" --sequence {}", fmt::join(options.sequences, " "));
}

ReportInputs LoadInputs(const ReportOptions& options) {
  ReportInputs inputs;
  inputs.quick = options.quick;
  inputs.seed = options.seed;
  inputs.threads = options.threads;
  inputs.command_line = options.command_line;
  if (options.lut.empty()) {
    inputs.warp_lut = ShippedWarpLut(options.folder);
    inputs.pipeline_lut = ShippedPipelineLut(options.folder);
  } else {
    inputs.warp_lut = LoadReportLut(options.lut);
    inputs.pipeline_lut = LoadReportLut(options.lut);
  }
  if (options.sequences.empty()) {
    inputs.clips = Render(options, OrdinaryScenes(options.quick), "rendering");
    inputs.larger_clips = Render(options, LargerScenes(options.quick), "rendering larger");
    return inputs;
  }
  inputs.sequences = SequencesOption(options);
  for (const std::string& path : options.sequences) {
    StopIfInterrupted();
    AddSequence(path, options.streams_below, options.quick, &inputs.clips, &inputs.larger_clips);
    if (Ranks::World().IsRoot()) WarnOfLimitedColor({&inputs.clips.back().dense});
  }
  return inputs;
}

// A page can be linked to only where every section has its place.
ReportSection FailedSection(const std::string& id, const std::string& why) {
  return {
      .id = id, .title = "Failed: " + id, .failures = {fmt::format("The section failed: {}", why)}};
}

// The command that makes the one section again.
std::string SectionCommand(const ReportOptions& options, const std::string& id) {
  std::string command = "warplut report --out DIR --sections " + id;
  if (options.quick) command += " --quick";
  if (options.seed != ReportOptions{}.seed) command += fmt::format(" --seed {}", options.seed);
  if (options.threads != 0) command += fmt::format(" --threads {}", options.threads);
  if (!options.lut.empty()) command += " --lut " + options.lut;
  return command + SequencesOption(options);
}

PageHead MakeHead(const ReportOptions& options, const ReportInputs& inputs,
                  const ReportOutcome& outcome) {
  std::vector<std::string> names;
  for (const ReportClip& clip : inputs.clips) names.push_back(clip.name);
  PageHead head{
      .title = "warplut: error against run time, stability, and what content does without",
      .paragraphs = {}};
  head.paragraphs.push_back(fmt::format(
      "Made in {:.1f} minutes on {}: {}.", outcome.seconds / 60,
      options.sequences.empty() ? "built-in scenes" : "your sequences", fmt::join(names, ", ")));
  if (options.quick) {
    head.paragraphs.emplace_back(
        "This is the quick form: fewer scenes, fewer and smaller frames, fewer repeats and less "
        "time for each section. Its "
        "numbers have more noise; leave out --quick for those to decide by.");
  }
  if (!options.sections.empty()) {
    head.paragraphs.push_back(
        fmt::format("Only some sections were asked for: {}.", fmt::join(options.sections, ", ")));
  }
  return head;
}

// The section, made by all ranks or by the root; then it is empty on the others, which rest.
ReportSection Make(const ReportSectionInfo& info, const ReportInputs& inputs) {
  Ranks& ranks = Ranks::World();
  if (info.shared) return info.make(inputs);
  if (!ranks.IsRoot()) {
    ranks.WaitForRoot();
    return {.id = info.id, .title = {}};
  }
  ReportSection section;
  std::exception_ptr failure;
  try {
    const AloneOnRank alone;
    section = info.make(inputs);
  } catch (...) {
    failure = std::current_exception();
  }
  ranks.WaitForRoot();
  if (failure) std::rethrow_exception(failure);
  return section;
}

// All that decides what is made.
std::string Identity(const ReportOptions& options) {
  return fmt::format("{} {} {} {} {} {}", options.folder.string(), options.quick, options.lut,
                     options.seed, fmt::join(options.sequences, " "),
                     fmt::join(options.sections, " "));
}

}  // namespace

std::span<const ReportSectionInfo> ReportSections() { return kSections; }

bool ReportOptions::IsValid(std::string* why) const {
  std::string reason;
  if (folder.empty()) reason = "the report has no folder; expected --out DIR";
  if (threads < 0) reason = fmt::format("threads is {}; expected 0 or more", threads);
  std::set<std::string> seen;
  for (const std::string& id : sections) {
    std::vector<std::string> known;
    for (const ReportSectionInfo& info : kSections) known.emplace_back(info.id);
    if (FindSection(id) == nullptr) {
      reason = fmt::format("'{}' is not a section; expected {}", id, fmt::join(known, ", "));
    } else if (!seen.insert(id).second) {
      reason = fmt::format("the section {} is named twice", id);
    }
  }
  if (!reason.empty() && why != nullptr) *why = reason;
  return reason.empty();
}

ReportOutcome MakeReport(const ReportOptions& options) {
  std::string why;
  if (!options.IsValid(&why)) throw Error(why);
  Ranks& ranks = Ranks::World();
  if (ranks.IsRoot()) {
    RequireWritableFolder(options.folder);
    RequireGnuplot();
    CreateFolder(options.folder);
  }
  ranks.RequireSame("the options", Identity(options));
  const SectionTime whole(0);
  const ThreadLimit limit(options.threads);
  ReportInputs inputs = LoadInputs(options);
  ReportOutcome outcome;
  outcome.parts.push_back({.id = "sequences", .seconds = whole.Spent()});

  const std::vector<ReportSectionInfo> chosen = Chosen(options);
  double total = 0, done = 0;
  for (const ReportSectionInfo& info : chosen) total += SecondsOf(info, options.quick);
  Progress progress("report", total, "");
  std::vector<ReportSection> sections;
  for (const ReportSectionInfo& info : chosen) {
    const SectionTime time(0);
    inputs.seconds = SecondsOf(info, options.quick);
    inputs.progress = [&](double share, const std::string& note) {
      StopIfInterrupted();
      progress.Update(done + std::clamp(share, 0.0, 1.0) * inputs.seconds,
                      fmt::format("{}: {}", info.id, note));
    };
    ReportOutcome::Part part{.id = info.id};
    try {
      inputs.progress(0, "");
      sections.push_back(Make(info, inputs));
    } catch (const std::exception& failure) {
      StopIfInterrupted();
      if (info.shared && ranks.count() > 1) throw;  // the other ranks wait for this one
      part.failure = failure.what();
      sections.push_back(FailedSection(info.id, failure.what()));
    }
    if (sections.back().command.empty()) {
      sections.back().command = SectionCommand(options, info.id);
    }
    done += inputs.seconds;
    part.seconds = time.Spent();
    part.left_out = sections.back().failures.size();
    outcome.parts.push_back(std::move(part));
  }
  outcome.seconds = whole.Spent();
  if (!ranks.IsRoot()) return outcome;
  WriteReport(options.folder, MakeHead(options, inputs, outcome), std::move(sections),
              StopIfInterrupted);
  return outcome;
}

}  // namespace warplut
