// warplut run: a method over a sequence, its frames as files.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "datasets/file.h"
#include "tools/command.h"
#include "tools/interrupt.h"
#include "tools/judge/sequence_report.h"
#include "tools/pipeline_options.h"
#include "tools/progress.h"
#include "tools/shown_file.h"
#include "tools/thread_limit.h"
#include "tools/warning.h"

namespace warplut {
namespace {

struct RunArguments {
  std::string mode;
  std::string sequence;
  std::string out;
  std::string format;
  int every = 1;
  bool score = false;
  int settled = 0;  // of --score
  bool json = false;
  PipelineArguments pipeline;
};

ShownFormat FormatOf(const RunArguments& arguments, const Sequence& sequence) {
  const bool linear = sequence.color_space == ColorSpace::kLinear;
  if (arguments.format.empty()) return linear ? ShownFormat::kExr : ShownFormat::kPng;
  RequireUsage(!linear || arguments.format == "exr",
               fmt::format("'{}' has linear colour, which .png cannot hold; expected --format exr",
                           sequence.name));
  return arguments.format == "exr" ? ShownFormat::kExr : ShownFormat::kPng;
}

// The clip that a method's frames are judged by, when it is not the clip that it runs on.
Clip LoadTruth(const Sequence& sequence, const FrameRange& range) {
  return LoadClip(sequence, range.first, range.count, kTruthStreams);
}

double ShownFrames(const ModeRunOptions& options, int count) {
  const int rendered = (count - 1) / options.every + 1;
  if (options.method->generation == Generation::kNone) return rendered;
  return rendered + (rendered - 1.0) * static_cast<double>(Alphas(options).size());
}

ExitCode Run(const RunArguments& arguments) {
  const MethodInfo* method = AsUsage([&] {
    CheckArguments(arguments.pipeline);
    return &MethodOf(arguments.mode);
  });
  const ThreadLimit limit(arguments.pipeline.threads);
  const Pipeline pipeline(arguments.pipeline);
  const Sequence sequence = ReadSequenceFor(pipeline, arguments.sequence);
  const ShownFormat format = FormatOf(arguments, sequence);
  const FrameRange range = ParseFrames(arguments.pipeline.frames, sequence);

  RequireWritableFolder(arguments.out);
  const ModeRunOptions options = pipeline.Options(*method, arguments.every);
  const Clip clip = pipeline.Load(sequence, range, {method}, Streams::kNone, arguments.every);
  std::string why;
  if (!options.IsValid(clip, &why)) throw Error(why);
  std::optional<Clip> truth;
  std::optional<SequenceJudge> judge;
  if (arguments.score) {
    truth = LoadTruth(sequence, range);
    judge.emplace(*truth, *method, kScoreBorder, arguments.settled);
  }
  WarnOfLimitedColor({&clip, truth ? &*truth : nullptr});

  const std::filesystem::path folder = arguments.out;
  CreateFolder(folder);
  const int first = clip.frames.front().number;
  Json files = Json::array();
  {
    Progress progress("running " + arguments.mode,
                      ShownFrames(options, static_cast<int>(clip.frames.size())), "frames");
    ThreadPool pool(arguments.pipeline.threads);
    RunMode(clip, options, pool, [&](const ShownFrame& shown) {
      ThrowIfInterrupted("run", "the frames that are written are whole");
      WriteShownFrame(folder, first, shown, clip.encoding, format);
      files.push_back(ShownFileName(first, shown.time, format));
      if (judge) judge->Add(shown);
      progress.Add(1);
    });
  }
  if (arguments.json) {
    Json document = {{"out", arguments.out}, {"filter", pipeline.filter_name()}, {"files", files}};
    if (judge) {
      document["scores"] = ToJson(SequenceReport{sequence.name, {judge->Finish()}});
    }
    PrintJson(document);
  } else {
    Print(fmt::format("{} frames of {} in {}\n", files.size(), sequence.name, arguments.out));
    if (judge) Print(ToText(FrameTable(judge->Finish())));
  }
  return ExitCode::kDone;
}

}  // namespace

void AddRunCommand(CLI::App& app, CommandRun* run) {
  const auto arguments = std::make_shared<RunArguments>();
  RunArguments& a = *arguments;
  CLI::App* command = app.add_subcommand(
      "run", "Write the frames of a method: super resolution and frame generation");
  std::string modes;
  for (const MethodInfo& method : Methods()) {
    modes += fmt::format("{}{}: {}", modes.empty() ? "" : "; ", method.name, method.meaning);
  }
  command->add_option("--mode", a.mode, "Method to run: " + modes)->required();
  command->add_option("--sequence", a.sequence, "Sequence to read: a sequence.json or its folder")
      ->required();
  command->add_option("--out", a.out, "Folder for the frames")->required();
  command->add_option("--format", a.format, "Format of the files (default: png, exr if linear)")
      ->check(CLI::IsMember({"png", "exr"}));
  command->add_option("--every", a.every, "Render every N-th frame")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  AddTableOptions(*command, &a.pipeline);
  AddPipelineOptions(*command, &a.pipeline);
  CLI::Option* score = command->add_flag("--score", a.score,
                                         "Judge the frames by the references and print the table");
  AddSettledOption(*command, &a.settled)->needs(score);
  AddJsonOption(*command, &a.json);
  command->callback([arguments, run] { *run = [arguments] { return Run(*arguments); }; });
}

}  // namespace warplut
