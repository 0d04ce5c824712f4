#include "tools/commands/command_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "datasets/file.h"
#include "tools/commands/pipeline_options.h"
#include "tools/device.h"
#include "tools/judge/sequence_judging.h"
#include "tools/thread_limit.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

using MethodList = std::vector<const MethodInfo*>;

// Methods that read no parameter are there to compare with.
bool IsBaseline(const MethodInfo& method) {
  return method.parameters.empty() && !method.optical_flow;
}

// Whether the two show frames of one kind, from inputs of one kind.
bool AreComparable(const MethodInfo& a, const MethodInfo& b) {
  return a.super_resolution == b.super_resolution && Generates(a) == Generates(b);
}

// The methods that were asked for, then the baselines to compare them with.
MethodList JudgedMethods(const std::vector<std::string>& modes) {
  MethodList methods;
  const auto add = [&](const MethodInfo& method) {
    if (std::find(methods.begin(), methods.end(), &method) == methods.end()) {
      methods.push_back(&method);
    }
  };
  for (const std::string& mode : modes) add(MethodOf(mode));
  const MethodList asked = methods;
  for (const MethodInfo& method : Methods()) {
    if (!IsBaseline(method)) continue;
    if (std::any_of(asked.begin(), asked.end(),
                    [&](const MethodInfo* one) { return AreComparable(*one, method); })) {
      add(method);
    }
  }
  return methods;
}

// The methods and targets, or a UsageError.
struct CheckedArguments {
  MethodList methods;
  std::vector<SequenceTarget> targets;
};

CheckedArguments Check(const JudgeArguments& arguments) {
  CheckedArguments checked;
  checked.methods = JudgedMethods(arguments.modes);
  CheckDevice(arguments.device);
  CheckArguments(arguments.pipeline);
  for (const std::string& text : arguments.targets) {
    const SequenceTarget target = ParseSequenceTarget(text);
    if (std::none_of(checked.methods.begin(), checked.methods.end(),
                     [&](const MethodInfo* method) { return target.method == method->name; })) {
      throw Error(fmt::format("the target '{}' names a method that --modes does not", text));
    }
    checked.targets.push_back(target);
  }
  return checked;
}

}  // namespace

CommandOption AddSequenceOptions(Command eval, JudgeArguments* arguments) {
  JudgeArguments& a = *arguments;
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
  const ThreadLimit limit(arguments.pipeline.threads);
  const CheckedArguments checked = AsUsage([&] { return Check(arguments); });
  const std::unique_ptr<ModeDevice> device = OpenDevice(arguments.device);
  if (!arguments.pictures.empty() && Ranks::World().IsRoot()) {
    RequireWritableFolder(arguments.pictures);
  }
  const Pipeline pipeline(arguments.pipeline);
  std::vector<Sequence> sequences;
  for (const std::string& path : arguments.sequences) {
    sequences.push_back(ReadSequenceFor(pipeline, path, checked.methods));
  }
  JudgedSequences judged = JudgeSequences({.methods = checked.methods,
                                           .every = arguments.every,
                                           .border = arguments.border,
                                           .settled = arguments.settled,
                                           .pictures = arguments.pictures,
                                           .device = device.get(),
                                           .pipeline = arguments.pipeline},
                                          pipeline, sequences);
  std::vector<SequenceReport>& reports = judged.reports;
  std::vector<std::string> missed;
  for (const SequenceTarget& target : checked.targets) {
    for (std::string& sentence : MissedSequences(target, reports)) {
      missed.push_back(std::move(sentence));
    }
  }

  if (arguments.json) {
    Json judged_sequences = Json::array();
    for (const SequenceReport& report : reports) judged_sequences.push_back(ToJson(report));
    PrintJson({{"filter", pipeline.filter_name()},
               {"texels", arguments.pipeline.texels},
               {"sequences", judged_sequences},
               {"pictures", judged.pictures},
               {"missed", missed}});
  } else {
    if (reports.size() > 1) reports.push_back(MeanReport(reports));
    for (const SequenceReport& report : reports) {
      const TextTable table = MethodTable(report);
      Print((arguments.markdown ? ToMarkdown(table) : ToText(table)) + "\n");
      for (const std::string& note : report.notes) Print(note + "\n");
    }
    for (const std::string& line : judged.pictures) Print(line + "\n");
    for (const std::string& sentence : missed) Print("missed: " + sentence + "\n");
  }
  return missed.empty() ? ExitCode::kDone : ExitCode::kMissed;
}

void AddJudgeCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<JudgeArguments>();
  JudgeArguments& a = *arguments;
  Command command =
      app.AddCommand("judge", "Judge methods on sequences, beside baselines that do without them");
  AddSequenceOptions(command, &a).Required();
  command.Add("--target", a.targets, "Least values of a method, as METHOD,PSNR,SSIM");
  command.Add("--pictures", a.pictures,
              "Folder for pictures: the windows where the first method errs most");
  CommandOption markdown =
      command.AddFlag("--markdown", a.markdown, "Print the tables as Markdown");
  markdown.Excludes(AddJsonOption(command, &a.json));
  command.OnParsed([arguments, run] { *run = [arguments] { return RunJudge(*arguments); }; });
}

}  // namespace warplut
