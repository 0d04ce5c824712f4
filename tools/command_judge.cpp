#include "tools/command_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "datasets/file.h"
#include "tools/interrupt.h"
#include "tools/judge/sequence_report.h"
#include "tools/pictures/sequence_pictures.h"
#include "tools/pipeline_options.h"
#include "tools/progress.h"
#include "tools/thread_limit.h"
#include "tools/warning.h"
#include "train/replay/judged_frames.h"

namespace warplut {
namespace {

using MethodList = std::vector<const MethodInfo*>;

bool Generates(const MethodInfo& method) { return method.generation != Generation::kNone; }

// Methods that read no parameter are there to compare with.
bool IsBaseline(const MethodInfo& method) { return method.parameters.empty(); }

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

// One sequence in memory: what is judged by, which is also what methods that see every frame run
// on, and what methods that generate run on.
struct LoadedSequence {
  std::string name;
  std::vector<std::string> notes;
  Clip truth;
  std::optional<Clip> sparse;

  const Clip& ClipFor(const MethodInfo& method) const {
    return Generates(method) ? *sparse : truth;
  }
};

LoadedSequence LoadSequence(const JudgeArguments& arguments, const Pipeline& pipeline,
                            const std::string& path, const MethodList& methods) {
  const Sequence sequence = ReadSequenceFor(pipeline, path, methods);
  const FrameRange range = ParseFrames(arguments.pipeline.frames, sequence);
  MethodList dense, sparse;
  for (const MethodInfo* method : methods) {
    (Generates(*method) ? sparse : dense).push_back(method);
  }
  LoadedSequence loaded;
  loaded.name = sequence.name + (arguments.pipeline.texels ? ", texels" : "");
  loaded.notes = JudgingNotes(sequence, methods);
  Streams truth = Streams::kNone;
  for (const MethodInfo* method : methods) {
    truth = truth | JudgingStreams(*method, AvailableStreams(sequence));
  }
  loaded.truth = pipeline.Load(sequence, range, dense, truth, 1);
  if (!sparse.empty()) {
    loaded.sparse = pipeline.Load(sequence, range, sparse, Streams::kNone, arguments.every);
  }
  WarnOfLimitedColor({&loaded.truth, loaded.sparse ? &*loaded.sparse : nullptr});
  return loaded;
}

class JudgeOfSequences {
 public:
  JudgeOfSequences(const JudgeArguments& arguments, MethodList methods)
      : arguments_(arguments),
        methods_(std::move(methods)),
        pipeline_(arguments.pipeline),
        pool_(arguments.pipeline.threads) {}

  const std::string& filter_name() const { return pipeline_.filter_name(); }

  SequenceReport Judge(const std::string& path) {
    const LoadedSequence loaded = LoadSequence(arguments_, pipeline_, path, methods_);
    SequenceReport report{.sequence = loaded.name, .methods = {}, .notes = loaded.notes};
    Progress progress("judging " + loaded.name, static_cast<double>(methods_.size()), "methods");
    for (const MethodInfo* method : methods_) {
      SequenceJudge judge(loaded.truth, *method, arguments_.border, arguments_.settled);
      Run(loaded, *method, [&](const ShownFrame& shown) { judge.Add(shown); });
      report.methods.push_back(judge.Finish());
      progress.Add(1);
    }
    if (!arguments_.pictures.empty()) WritePictures(loaded);
    return report;
  }

  // One line for each picture that was written.
  const std::vector<std::string>& pictures() const { return pictures_; }

 private:
  void Run(const LoadedSequence& loaded, const MethodInfo& method, const ShownFrameSink& sink) {
    const ModeRunOptions options =
        pipeline_.Options(method, Generates(method) ? arguments_.every : 1);
    const Clip& clip = loaded.ClipFor(method);
    std::string why;
    if (!options.IsValid(clip, &why)) throw Error(why);
    RunMode(clip, options, pool_, [&](const ShownFrame& shown) {
      ThrowIfInterrupted("eval", "nothing was printed");
      sink(shown);
    });
  }

  void RunJudged(const LoadedSequence& loaded, const MethodInfo& method,
                 const ShownFrameSink& sink) {
    Run(loaded, method, [&](const ShownFrame& shown) {
      if (IsJudged(method, shown)) sink(shown);
    });
  }

  void WritePictures(const LoadedSequence& loaded) {
    WindowChooser chooser(loaded.truth);
    RunJudged(loaded, *methods_.front(), [&](const ShownFrame& shown) { chooser.Add(shown); });
    SequencePictures pictures(loaded.truth, chooser.Windows());
    for (const MethodInfo* method : methods_) {
      RunJudged(loaded, *method,
                [&](const ShownFrame& shown) { pictures.Add(method->name, shown); });
    }
    for (const std::string& line : pictures.Write(arguments_.pictures)) pictures_.push_back(line);
  }

  const JudgeArguments& arguments_;
  const MethodList methods_;
  const Pipeline pipeline_;
  ThreadPool pool_;
  std::vector<std::string> pictures_;
};

// The methods and targets, or a UsageError.
struct CheckedArguments {
  MethodList methods;
  std::vector<SequenceTarget> targets;
};

CheckedArguments Check(const JudgeArguments& arguments) {
  CheckedArguments checked;
  checked.methods = JudgedMethods(arguments.modes);
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
  AddTableOptions(eval, &a.pipeline);
  AddPipelineOptions(eval, &a.pipeline);
  return sequence;
}

ExitCode RunJudge(const JudgeArguments& arguments) {
  if (!arguments.pictures.empty()) RequireWritableFolder(arguments.pictures);
  const ThreadLimit limit(arguments.pipeline.threads);
  const CheckedArguments checked = AsUsage([&] { return Check(arguments); });
  JudgeOfSequences judge(arguments, checked.methods);
  std::vector<SequenceReport> reports;
  for (const std::string& path : arguments.sequences) reports.push_back(judge.Judge(path));
  std::vector<std::string> missed;
  for (const SequenceTarget& target : checked.targets) {
    for (std::string& sentence : MissedSequences(target, reports)) {
      missed.push_back(std::move(sentence));
    }
  }

  if (arguments.json) {
    Json sequences = Json::array();
    for (const SequenceReport& report : reports) sequences.push_back(ToJson(report));
    PrintJson({{"filter", judge.filter_name()},
               {"texels", arguments.pipeline.texels},
               {"sequences", sequences},
               {"pictures", judge.pictures()},
               {"missed", missed}});
  } else {
    if (reports.size() > 1) reports.push_back(MeanReport(reports));
    for (const SequenceReport& report : reports) {
      const TextTable table = MethodTable(report);
      Print((arguments.markdown ? ToMarkdown(table) : ToText(table)) + "\n");
      for (const std::string& note : report.notes) Print(note + "\n");
    }
    for (const std::string& line : judge.pictures()) Print(line + "\n");
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
