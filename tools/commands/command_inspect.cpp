// warplut dataset inspect: what is in a sequence, and whether its manifest is right.
#include <fmt/format.h>

#include <memory>

#include "datasets/file.h"
#include "datasets/sequence/sequence.h"
#include "tools/commands/command.h"
#include "tools/commands/command_dataset.h"
#include "tools/commands/pipeline_options.h"
#include "tools/inspection/exr_listing.h"
#include "tools/inspection/inspection_text.h"
#include "tools/inspection/sequence_inspection.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/terminal/warning.h"

namespace warplut {
namespace {

struct InspectArguments {
  std::string path;
  std::string write;
  std::string streams_below;
  bool all = false;
  std::string only;  // "streams", "questions", or empty: everything
  bool json = false;
};

void WriteAnswered(const Inspection& inspection, const Sequence& sequence,
                   const std::string& path) {
  Sequence answered = inspection.answered;
  const std::filesystem::path file = path;
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  std::error_code ignored;
  if (!std::filesystem::equivalent(folder, sequence.folder.empty() ? "." : sequence.folder,
                                   ignored)) {
    throw Error(
        fmt::format("'{}' lies outside the sequence's folder '{}'; expected a file in it, "
                    "as the paths of streams are relative to the manifest",
                    path, sequence.folder.string()));
  }
  WriteFile(file, SequenceJson(answered));
}

// The contents of files that could not be loaded or counted as the manifest says.
void ReportProblems(const InspectArguments& arguments, const Sequence& sequence,
                    const std::vector<StreamInspection>& streams) {
  std::size_t problems = 0;
  std::int64_t infinite = 0;
  for (const StreamInspection& stream : streams) {
    problems += stream.problems.size();
    if (stream.name == "color" || stream.name == "reference") infinite += stream.infinite;
  }
  if (infinite > 0) WarnOfInfiniteColor(infinite, sequence.name);
  if (problems > 0) {
    throw Error(
        fmt::format("{} has {} missing or damaged frames of streams.", arguments.path, problems));
  }
}

ExitCode RunInspect(const InspectArguments& arguments) {
  if (IsImageToList(arguments.path)) {
    const Json listing = ExrListing(arguments.path);
    if (arguments.json) {
      PrintJson(listing);
    } else {
      Print(ExrListingText(listing));
    }
    return ExitCode::kDone;
  }
  const Sequence sequence = ReadSequence(arguments.path, arguments.streams_below);
  const double loads =
      static_cast<double>(StreamNames(AvailableStreams(sequence)).size()) * sequence.count;
  std::vector<StreamInspection> streams;
  Inspection inspection;
  {
    Progress progress("inspecting", loads + InspectionSteps(sequence), "steps");
    const auto step = [&] {
      ThrowIfInterrupted("inspect", "nothing was printed");
      progress.Add(1);
    };
    if (arguments.only != "questions") streams = InspectSequence(sequence, step);
    if (arguments.only != "streams") {
      inspection = InspectQuietly(sequence, step, arguments.only.empty());
    } else {
      inspection.answered = sequence;
    }
  }
  if (arguments.json) {
    PrintJson(InspectionJson(sequence, streams, inspection));
  } else {
    Print(InspectionText(sequence, streams, inspection, arguments.all));
  }
  if (!arguments.write.empty()) WriteAnswered(inspection, sequence, arguments.write);
  ReportProblems(arguments, sequence, streams);
  return inspection.Contradictions() > 0 ? ExitCode::kMissed : ExitCode::kDone;
}

}  // namespace

void AddInspectCommand(Command dataset, CommandRun* run) {
  const auto arguments = std::make_shared<InspectArguments>();
  Command command = dataset.AddCommand(
      "inspect", "Report damaged files, faults, and whether the manifest's convention is right");
  command
      .Add("sequence", arguments->path,
           "Sequence to load, a sequence.json or its folder; or an .exr file to list")
      .Required();
  AddStreamsBelowOption(command, &arguments->streams_below);
  command.Add("--write", arguments->write,
              "Manifest to write with the convention that the frames show");
  command.AddFlag("--all", arguments->all, "Print every candidate of every question");
  command
      .Add("--only", arguments->only,
           "Part to do: streams (load every file) or questions (the convention)")
      .OneOf({"streams", "questions"});
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, run] { *run = [arguments] { return RunInspect(*arguments); }; });
}

}  // namespace warplut
