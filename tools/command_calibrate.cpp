// warplut calibrate: the parameters that fit a person's clips.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <set>

#include "datasets/file.h"
#include "datasets/json_fields.h"
#include "tools/calibration_report.h"
#include "tools/command.h"
#include "tools/interrupt.h"
#include "tools/pipeline_options.h"
#include "tools/progress.h"
#include "tools/thread_limit.h"
#include "tools/warning.h"
#include "train/calibration/clip_crop.h"
#include "train/calibration/clip_loss.h"
#include "train/replay/judged_frames.h"
#include "train/replay/parameters_file.h"

namespace warplut {
namespace {

struct CalibrateArguments {
  std::vector<std::string> sequences;
  std::vector<std::string> modes = {"sr"};
  std::string out;
  std::vector<std::string> hold_out;
  bool split_frames = false;
  std::vector<std::string> fit;
  std::string keep = "near";
  int starts = 2;
  std::uint64_t seed = 1;
  double max_seconds = 0;
  int every = 2;
  int max_pixels = 0;
  int max_frames = 0;
  bool resume = false;
  bool json = false;
  bool generated_given = false;
  PipelineArguments pipeline;
};

// A clip's part in the calibration.
struct Part {
  Sequence sequence;
  FrameRange range;
  bool held_out = false;
};

std::vector<const MethodInfo*> MethodsOf(const std::vector<std::string>& names) {
  std::vector<const MethodInfo*> methods;
  for (const std::string& name : names) {
    const MethodInfo& method = MethodOf(name);
    RequireUsage(
        !method.paper && !method.parameters.empty(),
        fmt::format("the mode {} has no parameters to calibrate; expected one that has", name));
    RequireUsage(std::find(methods.begin(), methods.end(), &method) == methods.end(),
                 fmt::format("--modes has {} twice; expected it once", name));
    methods.push_back(&method);
  }
  return methods;
}

std::vector<int> FittedOf(const CalibrateArguments& arguments,
                          const std::vector<const MethodInfo*>& methods) {
  const std::vector<int> read = ParametersOf(methods);
  if (arguments.fit.empty()) return read;
  std::set<int> fitted;
  for (const std::string& name : arguments.fit) {
    const int index = FindParameter(name);
    RequireUsage(index >= 0, fmt::format("--fit has '{}'; expected {}", name, ParameterNames()));
    RequireUsage(std::find(read.begin(), read.end(), index) != read.end(),
                 fmt::format("--fit has {}, which none of the modes reads", name));
    fitted.insert(index);
  }
  return {fitted.begin(), fitted.end()};
}

std::vector<Part> PartsOf(const CalibrateArguments& arguments, const Pipeline& pipeline,
                          const std::vector<const MethodInfo*>& methods) {
  std::vector<Part> parts;
  std::set<std::string> names;
  for (const std::string& path : arguments.sequences) {
    Part part{.sequence = ReadSequenceFor(pipeline, path, methods), .range = {}};
    const std::string& name = part.sequence.name;
    if (!names.insert(name).second) {
      throw Error(fmt::format("two sequences have the name '{}'; expected different ones", name));
    }
    part.range = ParseFrames(arguments.pipeline.frames, part.sequence);
    if (arguments.max_frames > 0) {
      part.range.count = std::min(part.range.count, arguments.max_frames);
    }
    part.held_out = std::find(arguments.hold_out.begin(), arguments.hold_out.end(), name) !=
                    arguments.hold_out.end();
    if (arguments.split_frames) {
      const FrameRange whole = part.range;
      part.range.count = whole.count / 2;
      Part rest = part;
      rest.range = {whole.first + whole.count / 2, whole.count - whole.count / 2};
      rest.held_out = true;
      if (part.range.count > 0) parts.push_back(part);
      parts.push_back(std::move(rest));
    } else {
      parts.push_back(std::move(part));
    }
  }
  for (const std::string& name : arguments.hold_out) {
    RequireUsage(names.contains(name),
                 fmt::format("--hold-out names '{}', which no sequence has as its name", name));
  }
  RequireUsage(
      std::any_of(parts.begin(), parts.end(), [](const Part& part) { return !part.held_out; }),
      "every clip is held out; expected one at least to calibrate on");
  return parts;
}

// The runs of one part: super resolution on all frames, what generates on one in `every`.
std::vector<ClipRun> RunsOf(const CalibrateArguments& arguments, const Pipeline& pipeline,
                            const std::vector<const MethodInfo*>& methods, const Part& part) {
  std::vector<ClipRun> runs;
  std::vector<const Clip*> clips;
  for (const bool generates : {false, true}) {
    const int every = generates ? arguments.every : 1;
    std::vector<const MethodInfo*> same;
    for (const MethodInfo* method : methods) {
      if ((method->generation != Generation::kNone) == generates) same.push_back(method);
    }
    if (same.empty()) continue;
    Streams judging = Streams::kNone;
    for (const MethodInfo* method : same) {
      judging = judging | JudgingStreams(*method, AvailableStreams(part.sequence));
    }
    const auto clip = std::make_shared<const Clip>(
        CropClip(pipeline.Load(part.sequence, part.range, same,
                               judging & (Streams::kReference | Streams::kColor), every),
                 arguments.max_pixels));
    for (const MethodInfo* method : same) {
      runs.push_back({.clip = clip, .options = pipeline.Options(*method, every)});
    }
    clips.push_back(clip.get());
  }
  WarnOfLimitedColor(clips);
  return runs;
}

// The clips' runs, apart: those that are fitted and those that are held out.
struct Split {
  std::vector<ClipRun> fitted, held_out;
};

Split LoadParts(const CalibrateArguments& arguments, const Pipeline& pipeline,
                const std::vector<const MethodInfo*>& methods, const std::vector<Part>& parts) {
  Split split;
  Progress progress("loading", static_cast<double>(parts.size()), "clips");
  for (const Part& part : parts) {
    ThrowIfInterrupted("calibrate", "nothing was written");
    std::vector<ClipRun> runs = RunsOf(arguments, pipeline, methods, part);
    auto& to = part.held_out ? split.held_out : split.fitted;
    to.insert(to.end(), runs.begin(), runs.end());
    progress.Add(1);
  }
  return split;
}

// What the losses hang on, beside the files' contents.
std::string DataText(const CalibrateArguments& arguments, const Pipeline& pipeline,
                     const std::vector<Part>& parts) {
  std::string text =
      fmt::format("{} {} {}", pipeline.filter_name(), arguments.every, arguments.max_pixels);
  for (const std::string& mode : arguments.modes) text += " " + mode;
  for (const Part& part : parts) {
    if (part.held_out) continue;
    text +=
        fmt::format(" {} {} {}", SequenceJson(part.sequence), part.range.first, part.range.count);
  }
  return text;
}

void AddScores(const std::vector<ClipRun>& runs, bool held_out, const Parameters& calibrated,
               const Parameters& base, Executor& executor, CalibrationReport& report) {
  if (runs.empty()) return;
  ClipLoss loss(runs, executor);
  const std::vector<double> at_calibrated = loss.MeanSsim(calibrated);
  const std::vector<double> at_base = loss.MeanSsim(base);
  const std::vector<double> at_paper = loss.MeanSsim(kPaperParameters);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    report.scores.push_back({.clip = runs[i].clip->name,
                             .mode = runs[i].options.method->name,
                             .held_out = held_out,
                             .calibrated = at_calibrated[i],
                             .defaults = at_base[i],
                             .paper = at_paper[i]});
  }
}

CalibrationResult Search(const CalibrationOptions& options, ClipLoss& loss) {
  Progress progress("calibrating", 1, "");
  CalibrationOptions with_progress = options;
  with_progress.progress = [&](const CalibrationProgress& state) {
    progress.Update(std::min(1.0, state.fraction),
                    fmt::format("{} runs, loss {:.5f}", state.runs, state.loss));
    return !Interrupted();
  };
  return Calibrate(with_progress, loss);
}

CalibrationOptions OptionsOf(const CalibrateArguments& arguments,
                             const std::vector<const MethodInfo*>& methods) {
  CalibrationOptions options;
  options.fitted = FittedOf(arguments, methods);
  if (!arguments.pipeline.params.empty()) {
    options.base = ReadParameters(arguments.pipeline.params);
  }
  options.near_base = arguments.keep == "near";
  options.random_starts = arguments.starts;
  options.seed = arguments.seed;
  options.max_seconds = arguments.max_seconds;
  options.checkpoint = arguments.out + ".checkpoint";
  options.resume = arguments.resume;
  std::string why;
  RequireUsage(options.IsValid(&why), why);
  return options;
}

ExitCode RunCalibrate(CalibrateArguments arguments) {
  if (!arguments.generated_given) arguments.pipeline.generated = std::max(1, arguments.every - 1);
  const std::vector<const MethodInfo*> methods = AsUsage([&] {
    std::vector<const MethodInfo*> known = MethodsOf(arguments.modes);
    CheckArguments(arguments.pipeline);
    return known;
  });
  CalibrationOptions options = OptionsOf(arguments, methods);
  const ThreadLimit limit(arguments.pipeline.threads);
  const std::filesystem::path out = arguments.out;
  RequireWritable(out);
  RequireWritable(options.checkpoint);

  const Pipeline pipeline(arguments.pipeline);
  const std::vector<Part> parts = PartsOf(arguments, pipeline, methods);
  const Split split = LoadParts(arguments, pipeline, methods, parts);
  options.data = DataText(arguments, pipeline, parts);
  ThreadPool pool(arguments.pipeline.threads);
  if (!split.held_out.empty())
    ClipLoss(split.held_out, pool);  // an Error now rather than at the end

  CalibrationReport report{.filter = pipeline.filter_name(),
                           .modes = arguments.modes,
                           .every = arguments.every,
                           .max_pixels = arguments.max_pixels,
                           .seed = arguments.seed,
                           .result = {},
                           .scores = {}};
  if (out.has_parent_path()) CreateFolder(out.parent_path());
  {
    ClipLoss loss(split.fitted, pool);
    report.result = Search(options, loss);
  }
  if (report.result.stop == RunLog::Stop::kAsked) {
    throw Error(
        fmt::format("calibration was interrupted; the same command with --resume goes on from {}.",
                    options.checkpoint.string()));
  }
  const Parameters& kept = report.result.kept.parameters;
  AddScores(split.fitted, false, kept, options.base, pool, report);
  AddScores(split.held_out, true, kept, options.base, pool, report);
  const Json json = ToJson(report);
  WriteFile(out, ParametersJson(kept, JsonText(json)));
  if (report.result.stop == RunLog::Stop::kNone) std::filesystem::remove(options.checkpoint);
  if (arguments.json) {
    PrintJson({{"parameters", arguments.out}, {"calibration", json}});
  } else {
    Print(fmt::format("{}: {} runs of the pipeline in {:.1f} s\n\n{}", arguments.out,
                      report.result.runs, report.result.seconds, ToText(report)));
  }
  return ExitCode::kDone;
}

}  // namespace

void AddCalibrateCommand(CLI::App& app, CommandRun* run) {
  const auto arguments = std::make_shared<CalibrateArguments>();
  CalibrateArguments& a = *arguments;
  CLI::App* command = app.add_subcommand(
      "calibrate", "Fit the parameters of the pipeline to clips and write PARAMS.json");
  command->add_option("--sequence", a.sequences, "Sequences to fit, with references")->required();
  command->add_option("--modes", a.modes, "Methods to fit the parameters to, with equal weight")
      ->delimiter(',')
      ->capture_default_str();
  command
      ->add_option("--out", a.out,
                   "Parameters to write; PARAMS.json.checkpoint stands next to them meanwhile")
      ->required();
  CLI::Option* hold_out =
      command->add_option("--hold-out", a.hold_out, "Names of sequences to judge by, not to fit")
          ->delimiter(',');
  command
      ->add_flag("--split-frames", a.split_frames,
                 "Fit the first half of each clip and judge by the second")
      ->excludes(hold_out);
  command
      ->add_option("--fit", a.fit, "Names of parameters to fit (default: all that the modes read)")
      ->delimiter(',');
  command
      ->add_option(
          "--keep", a.keep,
          "Point to keep: near (as near to the defaults as the clips allow) or optimum (the "
          "optimum of these clips)")
      ->check(CLI::IsMember({"near", "optimum"}))
      ->capture_default_str();
  command
      ->add_option("--starts", a.starts,
                   "Number of random starts, besides the defaults and the paper's constants")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command->add_option("--seed", a.seed, "Seed of the random starts")->capture_default_str();
  command
      ->add_option("--max-seconds", a.max_seconds,
                   "Time limit of the search in seconds (default: none)")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--every", a.every, "Render every N-th frame, in modes that generate")
      ->check(CLI::Range(2, 64))
      ->capture_default_str();
  command
      ->add_option(
          "--max-pixels", a.max_pixels,
          "Number of output pixels to fit, in the middle of each frame (default: all; 500000 "
          "are quick)")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));
  command
      ->add_option("--max-frames", a.max_frames,
                   "Number of frames to fit, from the first of each clip (default: all)")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));
  command->add_flag("--resume", a.resume,
                    "Continue an interrupted calibration from its checkpoint");
  AddTableOptions(*command, &a.pipeline);
  AddPipelineOptions(*command, &a.pipeline);
  AddJsonOption(*command, &a.json);
  command->callback([arguments, run, command] {
    arguments->generated_given = command->count("--generated") > 0 || command->count("--alpha") > 0;
    *run = [arguments] { return RunCalibrate(*arguments); };
  });
}

}  // namespace warplut
