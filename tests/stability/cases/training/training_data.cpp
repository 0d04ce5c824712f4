#include "tests/stability/cases/training/training_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/stability/cases/training/training_problem.h"
#include "train/fit/rollout/crops.h"
#include "train/fit/rollout/noise_image.h"
#include "train/fit/trainer.h"

namespace warplut {
namespace {

TrainImage Noise(int side, std::uint64_t seed) {
  return {.record = {.name = "noise", .sha1 = std::string(40, '0'), .width = side, .height = side},
          .image = NoiseImage(side, side, seed)};
}

TrainOptions SmallOptions(StabilityEffort effort) {
  TrainOptions options;
  options.horizons = {2, 6};
  options.crops = 2;
  options.stages = effort == StabilityEffort::kFull ? 3 : 1;
  options.iterations = effort == StabilityEffort::kFull ? 8 : 2;
  return options;
}

int DifferentBits(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return kMlpParameters;
  int different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) different += a[i] != b[i];
  return different;
}

std::string Losses(const Fit& fit) {
  return fmt::format("loss {:.4g}, validation {:.4g}", fit.loss.back().loss,
                     fit.loss.back().validation);
}

}  // namespace

// Crops go round the images, at places that depend on the seed alone: the same crops of either
// copy.
StabilityResult TrainOnDuplicates(StabilityEffort effort) {
  const TrainImage image = Noise(kCropSize + 16, 1);
  const Fit single = Train(SmallOptions(effort), {image}).fit;
  const Fit twice = Train(SmallOptions(effort), {image, image}).fit;
  const int different = DifferentBits(single.parameters, twice.parameters);
  return {different == 0 && !single.parameters.empty(),
          fmt::format("{} of {} parameters differ; {}", different, kMlpParameters, Losses(twice))};
}

// An image of the least size: every crop is the same, of the training and of the validation.
StabilityResult TrainOnOneImage(StabilityEffort effort) {
  const Fit fit = Train(SmallOptions(effort), {Noise(kCropSize, 2)}).fit;
  Fit named = fit;
  named.name = "one";
  std::string why;
  const bool valid = named.IsValid(&why);
  const bool descends = std::isfinite(fit.loss.back().loss) &&
                        fit.loss.back().validation <= fit.loss.front().validation;
  return {valid && descends, fmt::format("fit {}, {}", valid ? "valid" : why, Losses(fit))};
}

StabilityResult TrainOnThreads(StabilityEffort effort) {
  TrainOptions options = SmallOptions(effort);
  std::vector<Fit> fits;
  for (const int threads : {1, 2}) {
    options.threads = threads;
    fits.push_back(Train(options, {Noise(kCropSize, 3), Noise(kCropSize, 4)}).fit);
  }
  const int different = DifferentBits(fits[0].parameters, fits[1].parameters);
  return {different == 0 && !fits[0].parameters.empty(),
          fmt::format("{} of {} parameters differ", different, kMlpParameters)};
}

StabilityResult TrainOverHorizons(StabilityEffort effort) {
  const bool full = effort == StabilityEffort::kFull;
  bool passed = true;
  std::string observed;
  for (const int horizon : full ? std::vector<int>{2, 4, 8, 16, 32, 64} : std::vector<int>{2, 64}) {
    TinyProblem problem;
    problem.images = {NoiseImage(kTinySide, kTinySide, 1)};
    problem.horizons = {horizon};
    problem.iterations = full ? 30 : 4;
    const TinyResult result = RunTiny(problem, MakeObjective(problem), RandomParameters(1));
    passed = passed && result.KeepsContract() && result.SafeFor(horizon);
    observed += fmt::format("{}{}: {:.3f} to {:.3f}, {} safe", observed.empty() ? "" : "; ",
                            horizon, result.start, result.end, result.safe_warps);
  }
  return {passed, observed};
}

}  // namespace warplut
