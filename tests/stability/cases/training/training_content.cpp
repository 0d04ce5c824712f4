#include "tests/stability/cases/training/training_content.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "datasets/error.h"
#include "datasets/tone_map.h"
#include "tests/stability/cases/training/training_images.h"
#include "tests/stability/cases/training/training_problem.h"
#include "train/fit/rollout/crops.h"
#include "train/fit/rollout/noise_image.h"
#include "train/fit/trainer.h"

namespace warplut {
namespace {

int Iterations(StabilityEffort effort) { return effort == StabilityEffort::kFull ? 30 : 8; }

TinyProblem ProblemOf(std::vector<Image> images, StabilityEffort effort) {
  TinyProblem problem;
  problem.images = std::move(images);
  problem.iterations = Iterations(effort);
  return problem;
}

StabilityResult TrainOn(Image image, StabilityEffort effort) {
  const TinyProblem problem = ProblemOf({std::move(image)}, effort);
  const TinyResult result = RunTiny(problem, MakeObjective(problem), RandomParameters(1));
  return {result.KeepsContract() && result.SafeFor(problem.horizons.back()), result.Text()};
}

// A warp changes a constant c by at most e = 16 c 2^-24, its weights summing to 1 in double. After
// n warps 1 - SSIM is at most (n e)^2 / (2 c^2): 7e-11 for the 12 warps of the problem, in units of
// kLeastBaseline 4e-5.
constexpr double kRoundingObjective = 4e-5;
constexpr double kRoundingGradient = 1e-9;

std::string SentenceOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

StabilityResult TrainOnOneValue(float value, StabilityEffort effort) {
  const TinyProblem problem = ProblemOf({ConstantImage(kTinySide, value)}, effort);
  const TinyResult result = RunTiny(problem, MakeObjective(problem), RandomParameters(1));
  const std::string refusal = SentenceOf([&] {
    CheckedLuma(
        {{.record = {.name = "flat", .sha1 = {}}, .image = ConstantImage(kCropSize, value)}});
  });
  const bool passed =
      result.KeepsContract() && result.end >= 0 && result.start <= kRoundingObjective &&
      result.start_gradient <= kRoundingGradient && refusal.find("expected") != std::string::npos;
  return {passed, fmt::format("loss {:.1e}, gradient {:.1e}; refused by \"{}\"", result.start,
                              result.start_gradient, refusal)};
}

// x / (1 + x), as the runtime maps the largest channel.
Image ToneMapped(Image image) {
  for (float& value : image.data) value *= ToneMapFactor(value);
  return image;
}

}  // namespace

StabilityResult TrainOnConstant(StabilityEffort effort) { return TrainOnOneValue(0.3f, effort); }
StabilityResult TrainOnBlack(StabilityEffort effort) { return TrainOnOneValue(0, effort); }
StabilityResult TrainOnWhite(StabilityEffort effort) { return TrainOnOneValue(1, effort); }

StabilityResult TrainOnImpulse(StabilityEffort effort) {
  return TrainOn(ImpulseImage(kTinySide), effort);
}

StabilityResult TrainOnWhiteNoise(StabilityEffort effort) {
  return TrainOn(WhiteNoiseImage(kTinySide, 3), effort);
}

StabilityResult TrainOnToneMappedHdr(StabilityEffort effort) {
  return TrainOn(ToneMapped(HdrImage(kTinySide, 3)), effort);
}

// By symmetry any weights at (1/2, 1/2) have H = 0 at Nyquist: the checkerboard becomes grey, whose
// SSIM is C2 / (1/4 + C2), the variance of the checkerboard being 1/4.
StabilityResult TrainOnCheckerboard(StabilityEffort effort) {
  const TinyProblem problem = ProblemOf({CheckerboardImage(kTinySide)}, effort);
  const WarpObjective objective = MakeObjective(problem);
  const TinyResult result = RunTiny(problem, objective, RandomParameters(1));
  HeadBatch head;
  const double loss = objective.Losses(head.Forward(result.parameters.data()))[0];
  const double expected = 1 - kSsimC2 / (0.25 + kSsimC2);
  return {result.KeepsContract() && result.SafeFor(problem.horizons.back()) &&
              std::abs(loss - expected) <= 1e-5,
          fmt::format("half-pixel loss {:.6f} for {:.6f}; {}", loss, expected, result.Text())};
}

StabilityResult TrainOnFlatAndNoise(StabilityEffort effort) {
  const Image noise = NoiseImage(kTinySide, kTinySide, 1);
  const TinyProblem mixed = ProblemOf({ConstantImage(kTinySide, 0.3f), noise}, effort);
  const TinyResult result = RunTiny(mixed, MakeObjective(mixed), RandomParameters(1));
  return {result.KeepsContract() && result.SafeFor(mixed.horizons.back()), result.Text()};
}

StabilityResult RefuseWhatCannotBeTrained(StabilityEffort) {
  const auto train = [](const TrainOptions& options, std::vector<Image> images) {
    return SentenceOf([&] {
      std::vector<TrainImage> data;
      for (Image& image : images) {
        data.push_back({.record = {.name = "image", .sha1 = {}}, .image = std::move(image)});
      }
      Train(options, data);
    });
  };
  const Image noise = NoiseImage(kCropSize, kCropSize, 1);
  const auto with = [&](float value) {
    Image image = noise;
    image.at(7, 9) = value;
    return image;
  };
  const auto options = [](std::vector<int> horizons, double gain_bound, double scale) {
    TrainOptions made;
    made.horizons = std::move(horizons);
    made.gain_bound = gain_bound;
    made.scale = scale;
    return made;
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::vector<std::string> sentences = {
      train({}, {}),
      train({}, {NoiseImage(kCropSize - 1, kCropSize, 1)}),
      train({}, {with(std::numeric_limits<float>::quiet_NaN())}),
      train({}, {with(kInfinity)}),
      train({}, {with(-1e-4f)}),
      train({}, {HdrImage(kCropSize, 3)}),
      train(options({1}, 0, 2), {noise}),
      train(options({0}, 0, 2), {noise}),
      train(options({6, 2}, 0, 2), {noise}),
      train(options({2 * kMaxHorizon}, 0, 2), {noise}),
      train(options({2}, kNan, 2), {noise}),
      train(options({2}, 0, kNan), {noise}),
  };
  const auto told = std::count_if(sentences.begin(), sentences.end(), [](const std::string& s) {
    return s.find("expected") != std::string::npos;
  });
  return {told == static_cast<std::ptrdiff_t>(sentences.size()),
          fmt::format("{} of {} refused; \"{}\"", told, sentences.size(), sentences[2])};
}

}  // namespace warplut
