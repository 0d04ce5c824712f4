// warplut train: images to a fit.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "datasets/file.h"
#include "luts/fit/fit.h"
#include "luts/fit/prefilter_json.h"
#include "luts/footprint_names.h"
#include "tools/commands/command.h"
#include "tools/judge/image_set.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/training/training_report.h"
#include "train/fit/trainer.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

struct TrainArguments {
  TrainOptions options;
  std::vector<std::string> data;
  std::string out;
  std::string name;
  std::string objective = Name(TrainObjective::kWarp);
  std::string prefilter = PrefilterName({});
  int taps = TapCount(TrainOptions().footprint);
  std::string optimizer = Name(Optimizer::kLbfgs);
  bool json = false;
};

ExitCode RunTrain(TrainArguments arguments) {
  TrainOptions& options = arguments.options;
  const fs::path out = arguments.out;
  const std::string name = arguments.name.empty() ? out.stem().string() : arguments.name;
  options.objective = arguments.objective == Name(TrainObjective::kSr) ? TrainObjective::kSr
                                                                       : TrainObjective::kWarp;
  options.optimizer =
      arguments.optimizer == Name(Optimizer::kAdam) ? Optimizer::kAdam : Optimizer::kLbfgs;
  RequireUsage(SetPrefilter(arguments.prefilter, &options),
               fmt::format("--prefilter is '{}'; expected none, spline, iir or fir:N.",
                           arguments.prefilter));
  const std::optional<Footprint> footprint = FootprintWith(arguments.taps);
  RequireUsage(footprint.has_value(),
               fmt::format("--taps is {}; expected {}.", arguments.taps, FootprintNames()));
  options.footprint = *footprint;
  options.checkpoint = out.string() + ".checkpoint";
  std::string why;
  RequireUsage(options.IsValid(&why), why);
  RequireUsage(
      IsIdentifier(name),
      fmt::format(
          "the fit's name is '{}'; expected letters, digits and _, the first not a digit (--name "
          "sets it).",
          name));
  Ranks& ranks = Ranks::World();
  if (ranks.IsRoot()) {
    RequireWritable(out);
    RequireWritable(options.checkpoint);
  }
  int tone_mapped = 0;
  const std::vector<TrainImage> images =
      LoadImages({arguments.data.begin(), arguments.data.end()}, &tone_mapped);
  ThrowIfInterrupted("train", "nothing was written");
  if (ranks.IsRoot() && out.has_parent_path()) CreateFolder(out.parent_path());

  TrainResult result;
  {
    Progress progress("training", 1, "");
    result = Train(options, images, [&](const TrainProgress& state) {
      progress.Update(state.fraction,
                      fmt::format("loss {:.6f}, validation {:.6f}", state.loss, state.validation));
      return !Interrupted();
    });
  }
  if (result.interrupted) {
    throw Error(
        fs::exists(options.checkpoint)
            ? fmt::format("training was interrupted; the same command with --resume goes on "
                          "from {}.",
                          options.checkpoint.string())
            : "training was interrupted before its first evaluation; nothing was written.");
  }
  if (!ranks.IsRoot()) return ExitCode::kDone;
  result.fit.name = name;
  WriteFit(out, result.fit);
  if (arguments.json) {
    PrintJson(ToJson(result, tone_mapped, arguments.out));
  } else {
    Print(ToneMappedText(tone_mapped, images.size()));
    Print(ToText(result, arguments.out));
  }
  return ExitCode::kDone;
}

}  // namespace

void AddTrainCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<TrainArguments>();
  TrainOptions& options = arguments->options;
  Command command =
      app.AddCommand("train", "Train a resampler on images and write it as a fit (JSON)");
  command
      .Add("--data", arguments->data, "Images, folders of images, or sequences (their references)")
      .Required();
  command
      .Add("--out", arguments->out, "Fit to write; FIT.checkpoint stands next to it while training")
      .Required();
  command.Add("--name", arguments->name, "Identifier of the table (default: file name of --out)");
  command.Add("--scale", options.scale, "Upscale factor, output / render, in [1, 4]").ShowDefault();
  command
      .Add("--objective", arguments->objective,
           "Loss to minimise: that of repeated warps, or of the loop of super resolution")
      .OneOf({Name(TrainObjective::kWarp), Name(TrainObjective::kSr)})
      .ShowDefault();
  command
      .Add("--prefilter", arguments->prefilter,
           "Prefilter of the table: none, spline (fixed, of the best spline), iir (trained, "
           "recursive) or fir:N (trained, N taps, odd, 3 to 15)")
      .ShowDefault();
  command
      .Add("--taps", arguments->taps,
           fmt::format("Texels that a warp weighs: {}; more than 16 with --prefilter none",
                       FootprintNames()))
      .ShowDefault();
  command.Add("--blend-a", options.blend_a,
              "Share of a sample on the pixel centre, for --objective sr (default: that of "
              "the pipeline)");
  command.Add("--blend-b", options.blend_b,
              "Decrease of that share with the distance, for --objective sr (default: that of "
              "the pipeline)");
  command
      .Add("--horizons", options.horizons,
           "Numbers of warps to train for, even, ascending (default: by scale)")
      .Separated();
  command.Add("--optimizer", arguments->optimizer, "Optimizer of the training")
      .OneOf({Name(Optimizer::kLbfgs), Name(Optimizer::kAdam)})
      .ShowDefault();
  command.Add("--gain-bound", options.gain_bound,
              "Largest gain of any node (default: by horizons)");
  command.Add("--pan-share", options.pan_share,
              fmt::format("Share of pans in the objective, in [0, 1) (default: "
                          "{:.2f}, {} with --prefilter none, there {} with more taps, {} with "
                          "--objective sr)",
                          kPanShare, kPlainPanShare, kWidePanShare, kSrPanShare));
  command.Add("--aliasing", options.aliasing,
              fmt::format("Noise of samples by aliasing, in output pixels, for --objective "
                          "sr (default: {})",
                          kSrAliasing));
  command.Add("--crops", options.crops, "Number of crops to train on (default: by objective)");
  command.Add("--stages", options.stages, "Number of training stages").ShowDefault();
  command.Add("--iterations", options.iterations,
              "Iterations of the optimizer in each stage (default: by optimizer)");
  command.Add("--max-seconds", options.max_seconds,
              "Time limit of the training in seconds (default: none)");
  command.Add("--seed", options.seed, "Seed of crops, trajectories and start").ShowDefault();
  command.Add("--threads", options.threads, "Number of threads (default: all cores)");
  command.AddFlag("--resume", options.resume,
                  "Continue an interrupted training from its checkpoint");
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, run] { *run = [arguments] { return RunTrain(*arguments); }; });
}

}  // namespace warplut
