#include "tools/commands/command_judge.h"

#include <memory>

#include "tools/commands/pipeline_options.h"
#include "tools/judge/images/protocol_filter.h"

namespace warplut {

CommandOption AddSequenceOptions(Command eval, JudgeArguments* arguments) {
  JudgeRequest& a = arguments->request;
  CommandOption sequence =
      eval.Add("--sequence", a.sequences,
               "Sequences with references to judge methods on, instead of images");
  eval.Add("--modes", a.modes, "Methods to judge ('run --help' lists them); baselines are added")
      .Separated()
      .ShowDefault();
  eval.Add("--every", a.every, "Render every N-th frame, for methods that generate")
      .Within(2, 64)
      .ShowDefault();
  eval.Add("--border", a.border, "Number of pixels to cut at each edge, on sequences")
      .Within(0, 4096)
      .ShowDefault();
  AddSettledOption(eval, &a.settled).Needs(sequence);
  AddDeviceOption(eval, &a.device).Needs(sequence);
  AddTableOptions(eval, &a.pipeline);
  AddPipelineOptions(eval, &a.pipeline);
  return sequence;
}

ExitCode RunJudge(const JudgeArguments& arguments) {
  const JudgeOutcome outcome = Judge(arguments.request);
  if (arguments.json) {
    PrintJson(ToJson(outcome));
  } else {
    Print(ToText(outcome, arguments.markdown));
  }
  return outcome.missed.empty() ? ExitCode::kDone : ExitCode::kMissed;
}

void AddJudgeCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<JudgeArguments>();
  JudgeRequest& a = arguments->request;
  Command command =
      app.AddCommand("judge", "Judge methods on sequences, beside baselines that do without them");
  AddSequenceOptions(command, arguments.get()).Required();
  CommandOption against = command
                              .Add("--against", a.against,
                                   "Filters, tables and methods to compare with, and what pays "
                                   "here: tables as files, names "
                                   "of methods, " +
                                       WarpNames())
                              .Separated();
  command
      .AddFlag("--jitter", a.jitter,
               "Also print the errors that repeat with the jitter and the render grid")
      .Excludes(against);
  command.Add("--target", a.targets, "Least values of a method, as METHOD,PSNR,SSIM");
  command.Add("--pictures", a.pictures,
              "Folder for pictures: the windows where the first method errs most");
  CommandOption markdown =
      command.AddFlag("--markdown", arguments->markdown, "Print the tables as Markdown");
  markdown.Excludes(AddJsonOption(command, &arguments->json));
  command.OnParsed([arguments, run] { *run = [arguments] { return RunJudge(*arguments); }; });
}

}  // namespace warplut
