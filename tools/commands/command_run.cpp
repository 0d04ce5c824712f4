// warplut run: a method over a sequence, its frames as files.
#include <fmt/format.h>

#include <memory>

#include "tools/commands/command.h"
#include "tools/commands/pipeline_options.h"
#include "tools/run/mode_runner.h"
#include "tools/thread_limit.h"

namespace warplut {
namespace {

struct RunArguments {
  RunRequest request;
  bool json = false;
};

Json ToJson(const ModeOutput& output) {
  Json json = {{"out", output.folder.string()}, {"files", output.files}};
  if (output.scores) json["scores"] = ToJson(*output.scores);
  return json;
}

ExitCode Run(const RunArguments& arguments) {
  const ThreadLimit limit(arguments.request.pipeline.threads);
  ModeRunner runner(arguments.request);
  const std::vector<ModeOutput> outputs = runner.Run();
  if (arguments.json) {
    Json document = {{"out", arguments.request.out}, {"filter", runner.filter_name()}};
    if (outputs.size() == 1) document.update(ToJson(outputs.front()));
    for (const ModeOutput& output : outputs) {
      if (outputs.size() > 1) document["modes"][output.mode] = ToJson(output);
    }
    PrintJson(document);
    return ExitCode::kDone;
  }
  for (const ModeOutput& output : outputs) {
    Print(fmt::format("{} frames of {} in {}\n", output.files.size(), runner.sequence().name,
                      output.folder.string()));
    if (!output.scores) continue;
    Print(ToText(FrameTable(output.scores->methods.front())));
    const bool generates = MethodOf(output.mode).generation != Generation::kNone;
    Print(fmt::format("Judged without {} pixels at each edge{}.\n", kScoreBorder,
                      generates ? "" : " and without the first frame, which has no history"));
    for (const std::string& note : output.scores->notes) Print(note + "\n");
  }
  return ExitCode::kDone;
}

}  // namespace

void AddRunCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<RunArguments>();
  RunRequest& a = arguments->request;
  Command command =
      app.AddCommand("run", "Write the frames of a method: super resolution and frame generation");
  std::string modes;
  for (const MethodInfo& method : Methods()) {
    modes += fmt::format("{}{}: {}", modes.empty() ? "" : "; ", method.name, method.meaning);
  }
  command
      .Add("--mode,--modes", a.modes,
           "Methods to run, separated by commas; several write into OUT/MODE each: " + modes)
      .Separated()
      .Required();
  command.Add("--sequence", a.sequence, "Sequence to read: a sequence.json or its folder")
      .Required();
  command.Add("--out", a.out, "Folder for the frames").Required();
  command.Add("--format", a.format, "Format of the files (default: png, exr if linear)")
      .OneOf({"png", "exr"});
  AddDeviceOption(command, &a.device);
  command.Add("--every", a.every, "Render every N-th frame").Within(1, 64).ShowDefault();
  AddTableOptions(command, &a.pipeline);
  AddPipelineOptions(command, &a.pipeline);
  CommandOption score =
      command.AddFlag("--score", a.score, "Judge the frames by the references and print the table");
  AddSettledOption(command, &a.settled).Needs(score);
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, run] { *run = [arguments] { return Run(*arguments); }; });
}

}  // namespace warplut
