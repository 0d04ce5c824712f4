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
#include "tools/memory_size.h"
#include "tools/pipeline_options.h"
#include "tools/progress.h"
#include "tools/thread_limit.h"
#include "tools/warning.h"
#include "train/calibration/clip_crop.h"
#include "train/calibration/clip_loss.h"
#include "train/ranks/ranks.h"
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
  std::string memory;
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

// The runs of one part: super resolution on all frames, what generates on one in `every`. Its owner
// alone loads the clip, from the shelf. `part` and `pipeline` outlive the runs.
std::vector<ClipRun> RunsOf(const CalibrateArguments& arguments, const Pipeline& pipeline,
                            const std::vector<const MethodInfo*>& methods, const Part& part,
                            int owner, ClipShelf& shelf) {
  std::vector<ClipRun> runs;
  Clip limited;  // what there is to warn of
  limited.name = part.sequence.name;
  for (const bool generates : {false, true}) {
    const int every = generates ? arguments.every : 1;
    std::vector<const MethodInfo*> same;
    Streams judging = Streams::kNone;
    for (const MethodInfo* method : methods) {
      if ((method->generation != Generation::kNone) != generates) continue;
      same.push_back(method);
      judging = judging | JudgingStreams(*method, AvailableStreams(part.sequence));
    }
    if (same.empty()) continue;
    ClipSource source;
    if (owner == Ranks::World().rank()) {
      const Streams more = judging & (Streams::kReference | Streams::kColor);
      source = shelf.Add([&pipeline, &part, same, more, every, pixels = arguments.max_pixels] {
        return CropClip(pipeline.Load(part.sequence, part.range, same, more, every), pixels);
      });
      const std::shared_ptr<const Clip> clip = source.Take();
      limited.limited_color = std::max(limited.limited_color, clip->limited_color);
      limited.limited_reference = std::max(limited.limited_reference, clip->limited_reference);
    }
    for (const MethodInfo* method : same) {
      runs.push_back({.clip = source,
                      .options = pipeline.Options(*method, every),
                      .name = part.sequence.name,
                      .owner = owner});
    }
  }
  WarnOfLimitedColor({&limited});
  return runs;
}

// The rank that runs each part: those that are fitted and those that are held out are shared apart.
std::vector<int> OwnersOf(const std::vector<Part>& parts) {
  std::vector<int> owners(parts.size());
  for (const bool held_out : {false, true}) {
    std::vector<std::size_t> indices;
    std::vector<double> work;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].held_out != held_out) continue;
      const GridSize& output = parts[i].sequence.output;
      indices.push_back(i);
      work.push_back(static_cast<double>(parts[i].range.count) * output.width * output.height);
    }
    const std::vector<int> balanced = BalancedOwners(work, Ranks::World().count());
    for (std::size_t k = 0; k < indices.size(); ++k) owners[indices[k]] = balanced[k];
  }
  return owners;
}

// The clips' runs, apart: those that are fitted and those that are held out.
struct Split {
  std::vector<ClipRun> fitted, held_out;
};

Split LoadParts(const CalibrateArguments& arguments, const Pipeline& pipeline,
                const std::vector<const MethodInfo*>& methods, const std::vector<Part>& parts,
                ClipShelf& shelf) {
  Split split;
  const std::vector<int> owners = OwnersOf(parts);
  Progress progress("loading", static_cast<double>(parts.size()), "clips");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    ThrowIfInterrupted("calibrate", "nothing was written");
    const Part& part = parts[i];
    std::vector<ClipRun> runs = RunsOf(arguments, pipeline, methods, part, owners[i], shelf);
    auto& to = part.held_out ? split.held_out : split.fitted;
    to.insert(to.end(), runs.begin(), runs.end());
    progress.Add(1);
  }
  return split;
}

// The input that the losses depend on, beside the files' contents.
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
    report.scores.push_back({.clip = runs[i].name,
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
  const std::size_t memory = AsUsage([&] { return ParseMemorySize(arguments.memory); });
  const ThreadLimit limit(arguments.pipeline.threads);
  const std::filesystem::path out = arguments.out;
  Ranks& ranks = Ranks::World();
  if (ranks.IsRoot()) {
    RequireWritable(out);
    RequireWritable(options.checkpoint);
  }

  const Pipeline pipeline(arguments.pipeline);
  const std::vector<Part> parts = PartsOf(arguments, pipeline, methods);
  ClipShelf shelf(memory);
  const Split split = LoadParts(arguments, pipeline, methods, parts, shelf);
  options.data = DataText(arguments, pipeline, parts);
  ranks.RequireSame("the options or the sequences", options.Identity());
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
  if (ranks.IsRoot() && out.has_parent_path()) CreateFolder(out.parent_path());
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
  if (!ranks.IsRoot()) return ExitCode::kDone;
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

void AddCalibrateCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<CalibrateArguments>();
  CalibrateArguments& a = *arguments;
  Command command = app.AddCommand(
      "calibrate", "Fit the parameters of the pipeline to clips and write PARAMS.json");
  command.Add("--sequence", a.sequences, "Sequences to fit, with references").Required();
  command.Add("--modes", a.modes, "Methods to fit the parameters to, with equal weight")
      .Separated()
      .ShowDefault();
  command
      .Add("--out", a.out,
           "Parameters to write; PARAMS.json.checkpoint stands next to them meanwhile")
      .Required();
  CommandOption hold_out =
      command.Add("--hold-out", a.hold_out, "Names of sequences to judge by, not to fit")
          .Separated();
  command
      .AddFlag("--split-frames", a.split_frames,
               "Fit the first half of each clip and judge by the second")
      .Excludes(hold_out);
  command.Add("--fit", a.fit, "Names of parameters to fit (default: all that the modes read)")
      .Separated();
  command
      .Add("--keep", a.keep,
           "Point to keep: near (as near to the defaults as the clips allow) or optimum (the "
           "optimum of these clips)")
      .OneOf({"near", "optimum"})
      .ShowDefault();
  command
      .Add("--starts", a.starts,
           "Number of random starts, besides the defaults and the paper's constants")
      .Within(0, 1000)
      .ShowDefault();
  command.Add("--seed", a.seed, "Seed of the random starts").ShowDefault();
  command.Add("--max-seconds", a.max_seconds, "Time limit of the search in seconds (default: none)")
      .NotNegative();
  command.Add("--every", a.every, "Render every N-th frame, in modes that generate")
      .Within(2, 64)
      .ShowDefault();
  command
      .Add("--max-pixels", a.max_pixels,
           "Number of output pixels to fit, in the middle of each frame (default: all; 500000 "
           "are quick)")
      .Within(1, std::numeric_limits<int>::max());
  command
      .Add("--max-frames", a.max_frames,
           "Number of frames to fit, from the first of each clip (default: all)")
      .Within(1, std::numeric_limits<int>::max());
  command.Add("--memory", a.memory,
              "Most memory for clips, as 2G or 500M, on each rank; clips that find no room are "
              "loaded for every run of the pipeline (default: all are kept)");
  command.AddFlag("--resume", a.resume, "Continue an interrupted calibration from its checkpoint");
  AddTableOptions(command, &a.pipeline);
  AddPipelineOptions(command, &a.pipeline);
  AddJsonOption(command, &a.json);
  command.OnParsed([arguments, run, command] {
    arguments->generated_given = command.Given("--generated") || command.Given("--alpha");
    *run = [arguments] { return RunCalibrate(*arguments); };
  });
}

}  // namespace warplut
