// warplut report: error against run time, stability, and what content does without, on one page.
#include <fmt/format.h>

#include <memory>

#include "tools/commands/command.h"
#include "tools/commands/pipeline_options.h"
#include "tools/report/report.h"
#include "tools/tables/table_text.h"

namespace warplut {
namespace {

struct ReportArguments {
  ReportOptions options;
  bool json = false;
};

Json ToJson(const ReportOptions& options, const ReportOutcome& outcome) {
  Json parts = Json::array();
  for (const ReportOutcome::Part& part : outcome.parts) {
    Json entry = {{"id", part.id}, {"seconds", part.seconds}, {"left_out", part.left_out}};
    if (!part.failure.empty()) entry["failure"] = part.failure;
    parts.push_back(std::move(entry));
  }
  return {{"page", (options.folder / "index.html").string()},
          {"seconds", outcome.seconds},
          {"parts", parts}};
}

std::string ToText(const ReportOptions& options, const ReportOutcome& outcome) {
  TextTable table{.header = {"section", "seconds", "left out or failed"}, .rows = {}};
  std::string failures;
  for (const ReportOutcome::Part& part : outcome.parts) {
    table.rows.push_back(
        {part.id, fmt::format("{:.1f}", part.seconds), fmt::format("{}", part.left_out)});
    if (!part.failure.empty()) failures += fmt::format("{} failed: {}\n", part.id, part.failure);
  }
  return ToText(table) + failures +
         fmt::format("{}: {:.0f} seconds\n", (options.folder / "index.html").string(),
                     outcome.seconds);
}

ExitCode RunReport(const ReportArguments& arguments) {
  const ReportOptions& options = arguments.options;
  std::string why;
  RequireUsage(options.IsValid(&why), why);
  const ReportOutcome outcome = MakeReport(options);
  if (arguments.json) {
    PrintJson(ToJson(options, outcome));
  } else {
    Print(ToText(options, outcome));
  }
  for (const ReportOutcome::Part& part : outcome.parts) {
    if (!part.failure.empty()) return ExitCode::kMissed;
  }
  return ExitCode::kDone;
}

// As a person would type it again.
std::string ShellCommand(const ReportOptions& options) {
  std::string line = "warplut report --out " + options.folder.string();
  if (options.quick) line += " --quick";
  for (const std::string& path : options.sequences) line += " --sequence " + path;
  if (!options.streams_below.empty()) line += " --streams-below " + options.streams_below;
  if (!options.lut.empty()) line += " --lut " + options.lut;
  if (options.threads != 0) line += fmt::format(" --threads {}", options.threads);
  if (options.seed != ReportOptions{}.seed) line += fmt::format(" --seed {}", options.seed);
  for (const std::string& id : options.sections) line += " --sections " + id;
  return line;
}

}  // namespace

void AddReportCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<ReportArguments>();
  ReportOptions& options = arguments->options;
  Command report =
      app.AddCommand("report", "Write one page: error against time, stability, omissions");
  report.Add("--out", options.folder, "Folder for the page, its tables and plots").Required();
  report.AddFlag("--quick", options.quick, "Finish in under 3 minutes instead of under 20");
  report.Add("--sequence", options.sequences,
             "Sequences with references (default: the built-in scenes)");
  AddStreamsBelowOption(report, &options.streams_below);
  report.Add("--lut", options.lut, "Fit or table to report on (default: the fits that ship)");
  report.Add("--threads", options.threads, "Number of threads (default: all cores)");
  report.Add("--seed", options.seed, "Seed of scenes, offsets and starts").ShowDefault();
  std::string known;
  for (const ReportSectionInfo& info : ReportSections()) {
    known += fmt::format("{}{}", known.empty() ? "" : ", ", info.id);
  }
  report.Add("--sections", options.sections, "Sections to make, separated by commas: " + known)
      .Separated();
  AddJsonOption(report, &arguments->json);
  report.OnParsed([arguments, run] {
    arguments->options.command_line = ShellCommand(arguments->options);
    *run = [arguments] { return RunReport(*arguments); };
  });
}

}  // namespace warplut
