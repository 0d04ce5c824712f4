#include "tools/commands/command_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "datasets/file.h"
#include "tools/commands/pipeline_options.h"
#include "tools/device.h"
#include "tools/judge/protocol_filter.h"
#include "tools/judge/sequence_judging.h"
#include "tools/payoff/payoff_report.h"
#include "tools/thread_limit.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

using MethodList = std::vector<const MethodInfo*>;

// Methods that read no parameter are there to compare with.
bool IsBaseline(const MethodInfo& method) {
  return method.parameters.empty() && !method.optical_flow;
}

void AddOnce(const MethodInfo& method, MethodList& methods) {
  if (std::find(methods.begin(), methods.end(), &method) == methods.end()) {
    methods.push_back(&method);
  }
}

// The baselines to compare the methods with.
MethodList BaselinesOf(const MethodList& asked) {
  MethodList baselines;
  for (const MethodInfo& method : Methods()) {
    if (!IsBaseline(method)) continue;
    if (std::any_of(asked.begin(), asked.end(),
                    [&](const MethodInfo* one) { return AreComparable(*one, method); })) {
      baselines.push_back(&method);
    }
  }
  return baselines;
}

// The methods and targets, or a UsageError.
struct CheckedArguments {
  MethodList methods;       // that were asked for, then baselines
  VariantOptions variants;  // of the same methods
  std::vector<SequenceTarget> targets;
};

CheckedArguments Check(const JudgeArguments& arguments) {
  CheckedArguments checked;
  VariantOptions& variants = checked.variants;
  for (const std::string& mode : arguments.modes) AddOnce(MethodOf(mode), variants.methods);
  variants.beside = BaselinesOf(variants.methods);
  variants.against = arguments.against;
  CheckAgainst(variants);
  checked.methods = variants.methods;
  for (const MethodInfo* baseline : variants.beside) AddOnce(*baseline, checked.methods);
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

struct CheckedRuns {
  std::optional<PipelineVariants> variants;  // with --against
  std::vector<JudgedRun> runs;
};

CheckedRuns RunsFor(CheckedArguments& checked, const PipelineArguments& arguments,
                    const std::vector<Sequence>& sequences) {
  CheckedRuns runs;
  if (checked.variants.against.empty()) {
    runs.runs = RunsOf(checked.methods);
    return runs;
  }
  checked.variants.one_grid =
      std::all_of(sequences.begin(), sequences.end(),
                  [](const Sequence& sequence) { return sequence.render == sequence.output; });
  runs.variants.emplace(checked.variants, arguments);
  runs.runs = runs.variants->runs();
  return runs;
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
  CheckedArguments checked = AsUsage([&] { return Check(arguments); });
  const std::unique_ptr<ModeDevice> device = OpenDevice(arguments.device);
  if (!arguments.pictures.empty() && Ranks::World().IsRoot()) {
    RequireWritableFolder(arguments.pictures);
  }
  const Pipeline pipeline(arguments.pipeline);
  std::vector<Sequence> sequences;
  for (const std::string& path : arguments.sequences) {
    sequences.push_back(ReadSequenceFor(pipeline, path, checked.methods));
  }
  CheckedRuns runs = RunsFor(checked, arguments.pipeline, sequences);
  JudgedSequences judged = JudgeSequences({.runs = runs.runs,
                                           .every = arguments.every,
                                           .border = arguments.border,
                                           .settled = arguments.settled,
                                           .pictures = arguments.pictures,
                                           .device = device.get(),
                                           .pipeline = arguments.pipeline},
                                          pipeline, sequences);
  std::vector<SequenceReport>& reports = judged.reports;
  std::optional<PayoffReport> payoff;
  if (runs.variants) {
    payoff = MakePayoffReport(runs.variants->list(), reports, pipeline.filter_name(),
                              !arguments.pipeline.lut.empty(), arguments.pipeline.params);
  }
  std::vector<std::string> missed;
  for (const SequenceTarget& target : checked.targets) {
    for (std::string& sentence : MissedSequences(target, reports)) {
      missed.push_back(std::move(sentence));
    }
  }

  if (arguments.json) {
    Json judged_sequences = Json::array();
    for (const SequenceReport& report : reports) judged_sequences.push_back(ToJson(report));
    Json document = {{"filter", pipeline.filter_name()},
                     {"texels", arguments.pipeline.texels},
                     {"sequences", judged_sequences},
                     {"pictures", judged.pictures},
                     {"missed", missed}};
    if (payoff) document["payoff"] = ToJson(*payoff);
    PrintJson(document);
  } else {
    const auto print_table = [&](const TextTable& table) {
      Print((arguments.markdown ? ToMarkdown(table) : ToText(table)) + "\n");
    };
    if (reports.size() > 1) reports.push_back(MeanReport(reports));
    for (std::size_t i = 0; i < reports.size(); ++i) {
      print_table(payoff ? ToTable(payoff->tables[i]) : MethodTable(reports[i]));
      for (const std::string& note : reports[i].notes) Print(note + "\n");
    }
    if (payoff) Print(PayoffText(*payoff, arguments.markdown));
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
  command
      .Add(
          "--against", a.against,
          "Filters, tables and methods to compare with, and what pays here: tables as files, names "
          "of methods, " +
              WarpNames())
      .Separated();
  command.Add("--target", a.targets, "Least values of a method, as METHOD,PSNR,SSIM");
  command.Add("--pictures", a.pictures,
              "Folder for pictures: the windows where the first method errs most");
  CommandOption markdown =
      command.AddFlag("--markdown", a.markdown, "Print the tables as Markdown");
  markdown.Excludes(AddJsonOption(command, &a.json));
  command.OnParsed([arguments, run] { *run = [arguments] { return RunJudge(*arguments); }; });
}

}  // namespace warplut
