#include "tests/stability/cases/gradients/gradient_objectives.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "datasets/tone_map.h"
#include "luts/fit/head.h"
#include "tests/stability/cases/gradients/gradient_reference.h"
#include "tests/stability/cases/training/training_images.h"
#include "tests/stability/cases/training/training_problem.h"
#include "train/fit/objective/sr_objective.h"
#include "train/fit/rivals/keys_search.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

int Directions(StabilityEffort effort) { return effort == StabilityEffort::kFull ? 8 : 2; }

struct GradientError {
  double size = 0;      // of the gradient
  double relative = 0;  // to the size; absolute where that is 0

  void Add(double analytic, double exact) {
    const double difference = std::abs(analytic - exact) / (size > 0 ? size : 1);
    // An error that is not a number stays the largest.
    if (!(difference <= relative)) relative = difference;
  }
};

// |g . v - exact| / |g| over random directions v of signs.
template <class Exact>
GradientError Compare(const CanonicalWeights<double>& gradient, int directions,
                      const Exact& exact) {
  GradientError error{.size = std::sqrt(Dot(gradient, gradient)), .relative = 0};
  for (int i = 0; i < directions; ++i) {
    const CanonicalWeights<double> direction = RandomSigns(40 + i);
    error.Add(Dot(gradient, direction), exact(direction));
  }
  return error;
}

// Of the loss after the last of the displacements, from an image to itself.
GradientError RolloutError(const Image& image, const std::vector<Displacement>& displacements,
                           const CanonicalWeights<double>& weights, int directions) {
  const BorderedPlane plane = ToPlane(image);
  const Ssim ssim(InnerView(plane));
  Rollout rollout;
  rollout.start = &plane;
  rollout.ssim = &ssim;
  rollout.steps = ToSteps(displacements);
  rollout.horizons = {static_cast<int>(displacements.size())};
  RolloutWorkspace workspace(plane.width(), plane.height());
  std::array<double, 1> loss{};
  workspace.Forward(rollout, weights, loss);
  Resampler gradient;
  const std::array<double, 1> factor = {1.0};
  workspace.Backward(rollout, factor, weights, gradient);
  return Compare(gradient.weights, directions, [&](const CanonicalWeights<double>& direction) {
    return Derivative(ReferenceLosses(rollout, plane, Seed(weights, direction))[0]);
  });
}

std::vector<Displacement> RandomTrajectory(int warps) {
  const std::array<int, 1> horizon = {warps};
  return MakeTrajectory(Offsets::kRandom, horizon, kNodes, 3);
}

CanonicalWeights<double> HeadWeightsOf(double scale) {
  std::vector<double> parameters = RandomParameters(3);
  for (double& p : parameters) p *= scale;
  HeadBatch head;
  return head.Forward(parameters.data());
}

Image Noise() { return NoiseImage(kTinySide, kTinySide, 6); }

class Observed {
 public:
  void Add(const std::string& name, const GradientError& error) {
    if (!(error.relative <= worst_)) worst_ = error.relative;
    text_ += fmt::format("{}{} {:.0e}{}", text_.empty() ? "" : ", ", name, error.relative,
                         error.size > 0 ? "" : " (no gradient)");
  }
  StabilityResult Within(double bound) const { return {worst_ <= bound, text_}; }

 private:
  double worst_ = 0;
  std::string text_;
};

constexpr double kKeys = -0.55;

GradientError ObjectiveError(const Objective& objective, int directions) {
  const CanonicalWeights<double> weights = KeysCanonicalWeights(kKeys);
  Resampler gradient;
  objective.Evaluate(weights, &gradient);
  return Compare(gradient.weights, directions, [&](const CanonicalWeights<double>& direction) {
    return ReferenceDerivative(objective, weights, direction);
  });
}

// Of J in the MLP's parameters: exact derivatives of the weights, then those of the objective and
// the penalty.
GradientError ParameterError(const Objective& objective, double scale, int directions) {
  constexpr double kBound = 1.02;
  std::vector<double> parameters = RandomParameters(3);
  for (double& p : parameters) p *= scale;
  MlpObjective judged(objective, kBound, kGainPenaltyFactor);
  std::vector<double> gradient(kMlpParameters);
  judged.Evaluate(parameters.data(), gradient.data());
  const GainPenalty penalty(kBound);

  GradientError error;
  error.size = LengthOf(gradient);
  Random random(5);
  for (int i = 0; i < directions; ++i) {
    const auto [seeded, analytic] = RandomDirection(parameters, gradient, random);
    CanonicalWeights<double> weights{}, direction{};
    Resampler of_penalty;
    for (int c = 0; c < kCanonicalNodes; ++c) {
      const auto [x, y] = CanonicalPosition(c);
      const auto at = HeadWeights<Complex>(seeded.data(), NodeOffset(x), NodeOffset(y));
      for (int k = 0; k < kWeights; ++k) {
        weights[c][k] = at[k].real();
        direction[c][k] = Derivative(at[k]);
      }
    }
    penalty.AddGradient(weights, kGainPenaltyFactor, of_penalty);
    error.Add(analytic, ReferenceDerivative(objective, weights, direction) +
                            Dot(of_penalty.weights, direction));
  }
  return error;
}

std::vector<BorderedPlane> Crops() {
  std::vector<BorderedPlane> crops;
  crops.push_back(ToPlane(Noise()));
  return crops;
}

}  // namespace

StabilityResult RolloutGradient(StabilityEffort effort) {
  const bool full = effort == StabilityEffort::kFull;
  Observed observed;
  for (const int warps : full ? std::vector<int>{2, 6, 24, 64} : std::vector<int>{2, 64}) {
    observed.Add(fmt::format("{} warps", warps),
                 RolloutError(Noise(), RandomTrajectory(warps), KeysCanonicalWeights(kKeys),
                              Directions(effort)));
  }
  return observed.Within(1e-4);
}

StabilityResult RolloutGradientOfContent(StabilityEffort effort) {
  Image hdr = HdrImage(kTinySide, 3);
  for (float& value : hdr.data) value *= ToneMapFactor(value);
  struct {
    const char* name;
    Image image;
  } const contents[] = {{"impulse", ImpulseImage(kTinySide)},
                        {"checkerboard", CheckerboardImage(kTinySide)},
                        {"white noise", WhiteNoiseImage(kTinySide, 3)},
                        {"tone-mapped HDR", hdr}};
  Observed observed;
  for (const auto& [name, image] : contents) {
    observed.Add(name, RolloutError(image, RandomTrajectory(6), KeysCanonicalWeights(kKeys),
                                    Directions(effort)));
  }
  return observed.Within(1e-4);
}

StabilityResult RolloutGradientOfWeights(StabilityEffort effort) {
  Observed observed;
  for (const double scale : {1e-6, 1.0, 10.0, 1e3}) {
    observed.Add(
        fmt::format("parameters times {:g}", scale),
        RolloutError(Noise(), RandomTrajectory(6), HeadWeightsOf(scale), Directions(effort)));
  }
  return observed.Within(1e-4);
}

// The training's offsets are nodes: 0, 1/2 and 31/32 are its extremes. The last loses so little
// that roundings of the images, 2^-24, are a part of 1e-4 of it.
StabilityResult RolloutGradientAtOffsets(StabilityEffort effort) {
  Observed observed;
  for (const double offset : {0.0, 0.5, 1.0 / kNodes}) {
    std::vector<Displacement> there_and_back;
    for (int i = 0; i < 3; ++i) {
      there_and_back.push_back({offset, offset});
      there_and_back.push_back({-offset, -offset});
    }
    CanonicalWeights<double> weights = KeysCanonicalWeights(kKeys);
    // At offset 0 a rollout of the identity has neither loss nor gradient.
    for (double& w : weights[0]) w += 0.01;
    observed.Add(fmt::format("{:g}", offset),
                 RolloutError(Noise(), there_and_back, weights, Directions(effort)));
  }
  return observed.Within(1e-3);
}

StabilityResult WarpObjectiveGradient(StabilityEffort effort) {
  const bool full = effort == StabilityEffort::kFull;
  Observed observed;
  for (const double power : {1.0, 8.0, kProtocolPower}) {
    const WarpObjective objective(
        Crops(), full ? std::vector<int>{2, 6, 24} : std::vector<int>{2, 6}, 5, {power, 0.2, 1});
    observed.Add(fmt::format("p = {:g}", power), ObjectiveError(objective, Directions(effort)));
  }
  return observed.Within(1e-4);
}

StabilityResult SrObjectiveGradient(StabilityEffort effort) {
  const bool full = effort == StabilityEffort::kFull;
  Observed observed;
  for (const double scale : {1.0, 2.0, 4.0}) {
    const SrObjective objective(Crops(), full ? std::vector<int>{4, 24} : std::vector<int>{4}, 5,
                                {.scale = scale, .blend_a = 0.5, .blend_b = 0.8, .aliasing = 1.5});
    observed.Add(fmt::format("scale {:g}", scale), ObjectiveError(objective, Directions(effort)));
  }
  return observed.Within(1e-4);
}

StabilityResult TrainingGradient(StabilityEffort effort) {
  const WarpObjective objective(Crops(), {2, 6}, 5, {8, 0, 0});
  Observed observed;
  for (const double scale : {1e-6, 1.0, 10.0, 1e3}) {
    observed.Add(fmt::format("parameters times {:g}", scale),
                 ParameterError(objective, scale, Directions(effort) / 2));
  }
  return observed.Within(1e-4);
}

}  // namespace warplut
