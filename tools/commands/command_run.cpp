// warplut run: a method over a sequence, its frames as files.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "datasets/file.h"
#include "tools/commands/command.h"
#include "tools/commands/pipeline_options.h"
#include "tools/device.h"
#include "tools/judge/sequence_report.h"
#include "tools/pictures/hud_layer.h"
#include "tools/pictures/shown_file.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/terminal/warning.h"
#include "tools/thread_limit.h"
#include "train/replay/judged_frames.h"

namespace warplut {
namespace {

struct RunArguments {
  std::vector<std::string> modes;
  std::string sequence;
  std::string out;
  std::string format;
  std::string device = DeviceNames().front();
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

double ShownFrames(const ModeRunOptions& options, int count) {
  const int rendered = (count - 1) / options.every + 1;
  if (options.method->generation == Generation::kNone) return rendered;
  return rendered + (rendered - 1.0) * static_cast<double>(Alphas(options).size());
}

// What one mode wrote.
struct ModeOutput {
  std::string mode;
  std::filesystem::path folder;
  Json files = Json::array();
  std::optional<SequenceReport> scores;
};

std::vector<const MethodInfo*> MethodsOf(const std::vector<std::string>& modes) {
  std::vector<const MethodInfo*> methods;
  for (const std::string& mode : modes) {
    const MethodInfo& method = MethodOf(mode);
    if (std::find(methods.begin(), methods.end(), &method) != methods.end()) {
      throw Error(fmt::format("--mode has {} twice; expected it once", mode));
    }
    methods.push_back(&method);
  }
  return methods;
}

class Runner {
 public:
  explicit Runner(const RunArguments& arguments)
      : arguments_(arguments),
        methods_(AsUsage([&] {
          std::vector<const MethodInfo*> methods = MethodsOf(arguments.modes);
          CheckDevice(arguments.device);
          CheckArguments(arguments.pipeline);
          return methods;
        })),
        pipeline_(arguments.pipeline),
        sequence_(ReadSequenceFor(pipeline_, arguments.sequence, methods_)),
        format_(FormatOf(arguments, sequence_)),
        range_(ParseFrames(arguments.pipeline.frames, sequence_)),
        device_(OpenDevice(arguments.device)),
        pool_(arguments.pipeline.threads) {}

  std::vector<ModeOutput> Run() {
    RequireWritableFolder(arguments_.out);
    for (const MethodInfo* method : methods_) CheckMode(*method);
    std::vector<ModeOutput> outputs;
    for (const MethodInfo* method : methods_) outputs.push_back(RunOne(*method));
    return outputs;
  }

  const Sequence& sequence() const { return sequence_; }
  const std::string& filter_name() const { return pipeline_.filter_name(); }

 private:
  ModeRunOptions OptionsOf(const MethodInfo& method) const {
    ModeRunOptions options = pipeline_.Options(method, arguments_.every);
    options.device = device_.get();
    return options;
  }

  // The clip of the range, on which the method can run.
  Clip Load(const FrameRange& range, const MethodInfo& method) const {
    const ModeRunOptions options = OptionsOf(method);
    Clip clip = pipeline_.Load(sequence_, range, {&method}, Streams::kNone, options.every);
    std::string why;
    if (!options.IsValid(clip, &why)) throw Error(why);
    return clip;
  }

  // Streams and choices that a later mode lacks are told before the first one runs.
  void CheckMode(const MethodInfo& method) const {
    LoadFrame(sequence_, range_.first, NeededStreams(method, AvailableStreams(sequence_)));
    if (device_ == nullptr) return;
    // One frame that is rendered after the first.
    Load({range_.first, std::min(range_.count, arguments_.every + 1)}, method);
  }

  ModeOutput RunOne(const MethodInfo& method) {
    const ModeRunOptions options = OptionsOf(method);
    const Clip clip = Load(range_, method);
    std::optional<Clip> truth;
    std::optional<SequenceJudge> judge;
    if (arguments_.score) {
      truth = LoadClip(sequence_, range_.first, range_.count,
                       JudgingStreams(method, AvailableStreams(sequence_)));
      judge.emplace(*truth, method, kScoreBorder, arguments_.settled);
    }
    WarnOfLimitedColor({&clip, truth ? &*truth : nullptr});
    ModeOutput output;
    output.mode = method.name;
    output.folder = arguments_.out;
    if (methods_.size() > 1) output.folder /= output.mode;
    CreateFolder(output.folder);
    const int first = clip.frames.front().number;
    HudLayer hud(sequence_, range_.first, pool_);
    Progress progress("running " + output.mode,
                      ShownFrames(options, static_cast<int>(clip.frames.size())), "frames");
    RunMode(clip, options, pool_, [&](const ShownFrame& shown) {
      ThrowIfInterrupted("run", "the frames that are written are whole");
      WriteShownFrame(output.folder, first, hud.Over(shown), clip.encoding, format_);
      output.files.push_back(ShownFileName(first, shown.time, format_));
      if (judge) judge->Add(shown);
      progress.Add(1);
    });
    if (judge) {
      output.scores = SequenceReport{.sequence = sequence_.name,
                                     .methods = {judge->Finish()},
                                     .notes = JudgingNotes(sequence_, {&method})};
    }
    return output;
  }

  const RunArguments& arguments_;
  const std::vector<const MethodInfo*> methods_;
  const Pipeline pipeline_;
  const Sequence sequence_;
  const ShownFormat format_;
  const FrameRange range_;
  const std::unique_ptr<ModeDevice> device_;
  ThreadPool pool_;
};

Json ToJson(const ModeOutput& output) {
  Json json = {{"out", output.folder.string()}, {"files", output.files}};
  if (output.scores) json["scores"] = ToJson(*output.scores);
  return json;
}

ExitCode Run(const RunArguments& arguments) {
  const ThreadLimit limit(arguments.pipeline.threads);
  Runner runner(arguments);
  const std::vector<ModeOutput> outputs = runner.Run();
  if (arguments.json) {
    Json document = {{"out", arguments.out}, {"filter", runner.filter_name()}};
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
  RunArguments& a = *arguments;
  Command command =
      app.AddCommand("run", "Write the frames of a method: super resolution and frame generation");
  std::string modes;
  for (const MethodInfo& method : Methods()) {
    modes += fmt::format("{}{}: {}", modes.empty() ? "" : "; ", method.name, method.meaning);
  }
  command
      .Add("--mode", a.modes,
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
  AddJsonOption(command, &a.json);
  command.OnParsed([arguments, run] { *run = [arguments] { return Run(*arguments); }; });
}

}  // namespace warplut
