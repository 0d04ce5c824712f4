// warplut train: images to a fit.
#include <fmt/format.h>

#include <memory>

#include "luts/footprint_names.h"
#include "tools/commands/command.h"
#include "tools/commands/pipeline_options.h"
#include "tools/judge/images/image_set.h"
#include "tools/training/training_job.h"
#include "tools/training/training_report.h"

namespace warplut {
namespace {

struct TrainArguments {
  TrainingRequest request;
  bool json = false;
};

ExitCode RunTrain(const TrainArguments& arguments) {
  const std::optional<TrainingOutcome> outcome = RunTraining(arguments.request);
  if (!outcome) return ExitCode::kDone;
  const std::string& out = arguments.request.out;
  if (arguments.json) {
    PrintJson(ToJson(outcome->result, outcome->tone_mapped, out));
  } else {
    Print(ToneMappedText(outcome->tone_mapped, outcome->images));
    Print(ToText(outcome->result, out));
  }
  return ExitCode::kDone;
}

}  // namespace

void AddTrainCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<TrainArguments>();
  TrainingRequest& request = arguments->request;
  TrainOptions& options = request.options;
  Command command =
      app.AddCommand("train", "Train a resampler on images and write it as a fit (JSON)");
  command.Add("--data", request.data, "Images, folders of images, or sequences (their references)")
      .Required();
  AddStreamsBelowOption(command, &request.streams_below);
  command.Add("--out", request.out, "Fit to write; FIT.checkpoint stands next to it while training")
      .Required();
  command.Add("--name", request.name, "Identifier of the table (default: file name of --out)");
  command.Add("--scale", options.scale, "Upscale factor, output / render, in [1, 4]").ShowDefault();
  command
      .Add("--objective", request.objective,
           "Loss to minimise: that of repeated warps, or of the loop of super resolution")
      .OneOf({Name(TrainObjective::kWarp), Name(TrainObjective::kSr)})
      .ShowDefault();
  command
      .Add("--prefilter", request.prefilter,
           "Prefilter of the table: none, spline (fixed, of the best spline), iir (trained, "
           "recursive) or fir:N (trained, N taps, odd, 3 to 15)")
      .ShowDefault();
  command
      .Add("--taps", request.taps,
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
  command.Add("--optimizer", request.optimizer, "Optimizer of the training")
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
