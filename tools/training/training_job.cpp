#include "tools/training/training_job.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "datasets/error.h"
#include "datasets/file.h"
#include "luts/fit/fit.h"
#include "luts/footprint_names.h"
#include "tools/judge/images/image_set.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/usage_error.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

// The options with the choices that the request names.
TrainOptions OptionsOf(const TrainingRequest& request) {
  TrainOptions options = request.options;
  options.objective =
      request.objective == Name(TrainObjective::kSr) ? TrainObjective::kSr : TrainObjective::kWarp;
  options.optimizer =
      request.optimizer == Name(Optimizer::kAdam) ? Optimizer::kAdam : Optimizer::kLbfgs;
  RequireUsage(
      SetPrefilter(request.prefilter, &options),
      fmt::format("--prefilter is '{}'; expected none, spline, iir or fir:N.", request.prefilter));
  const std::optional<Footprint> footprint = FootprintWith(request.taps);
  RequireUsage(footprint.has_value(),
               fmt::format("--taps is {}; expected {}.", request.taps, FootprintNames()));
  options.footprint = *footprint;
  options.checkpoint = request.out + ".checkpoint";
  std::string why;
  RequireUsage(options.IsValid(&why), why);
  return options;
}

TrainResult TrainWithProgress(const TrainOptions& options, const std::vector<TrainImage>& images) {
  TrainResult result;
  {
    Progress progress("training", 1, "");
    result = Train(options, images, [&](const TrainProgress& state) {
      progress.Update(state.fraction,
                      fmt::format("loss {:.6f}, validation {:.6f}", state.loss, state.validation));
      return !Interrupted();
    });
  }
  if (!result.interrupted) return result;
  throw Error(fs::exists(options.checkpoint)
                  ? fmt::format("training was interrupted; the same command with --resume goes on "
                                "from {}.",
                                options.checkpoint.string())
                  : "training was interrupted before its first evaluation; nothing was written.");
}

}  // namespace

std::optional<TrainingOutcome> RunTraining(const TrainingRequest& request) {
  const TrainOptions options = OptionsOf(request);
  const fs::path out = request.out;
  const std::string name = request.name.empty() ? out.stem().string() : request.name;
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
  TrainingOutcome outcome;
  const std::vector<TrainImage> images = LoadImages({request.data.begin(), request.data.end()},
                                                    &outcome.tone_mapped, request.streams_below);
  outcome.images = images.size();
  ThrowIfInterrupted("train", "nothing was written");
  if (ranks.IsRoot() && out.has_parent_path()) CreateFolder(out.parent_path());
  outcome.result = TrainWithProgress(options, images);
  if (!ranks.IsRoot()) return std::nullopt;
  outcome.result.fit.name = name;
  WriteFit(out, outcome.result.fit);
  return outcome;
}

}  // namespace warplut
