#include "tests/stability/cases/training/training_problem.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "luts/certificate/certificate.h"
#include "train/fit/minimize.h"
#include "train/fit/objective/gain_limit.h"
#include "train/fit/rollout/noise_image.h"
#include "train/fit/train_options.h"

namespace warplut {
namespace {

constexpr double kSumTolerance = 1e-12;

double GradientNorm(MlpObjective& objective, const std::vector<double>& parameters, double* value) {
  Eigen::VectorXd gradient(kMlpParameters);
  *value = objective.Evaluate(parameters.data(), gradient.data());
  return gradient.norm();
}

void JudgeWeights(const CanonicalWeights<double>& weights, TinyResult* result) {
  for (const Weights<double>& node : weights) {
    double sum = 0;
    for (const double w : node) sum += w;
    // A sum that is not a number stays the largest.
    if (!(std::abs(sum - 1) <= result->sum_error)) result->sum_error = std::abs(sum - 1);
    result->gain = std::max(result->gain, MaxGain(node).gain);
  }
  result->safe_warps = std::min<std::int64_t>(SafeWarps(result->gain).value_or(kMaxRecordedWarps),
                                              kMaxRecordedWarps);
  result->identity = true;
  for (int k = 0; k < kWeights; ++k) {
    const float expected = k == kIdentityWeight ? 1.0f : 0.0f;
    result->identity = result->identity && static_cast<float>(weights[0][k]) == expected;
  }
}

}  // namespace

bool TinyResult::KeepsContract() const {
  return std::isfinite(end) && std::isfinite(start_gradient) && std::isfinite(end_gradient) &&
         end <= start && identity && sum_error <= kSumTolerance;
}

std::string TinyResult::Text() const {
  return fmt::format(
      "objective {:.4g} to {:.4g}, gain {:.5f}{}: {} safe warps, sums within {:.0e}{}", start, end,
      gain, share < 1 ? fmt::format(" after the residual was scaled by {:.2g}", share) : "",
      safe_warps, sum_error, identity ? "" : ", identity lost");
}

WarpObjective MakeObjective(const TinyProblem& problem) {
  std::vector<BorderedPlane> crops;
  for (const Image& image : problem.images) crops.push_back(ToPlane(image));
  return {std::move(crops), problem.horizons, problem.seed};
}

TinyResult RunTiny(const TinyProblem& problem, const Objective& objective,
                   std::vector<double> parameters) {
  TinyResult result;
  result.gain_bound = DefaultGainBound(problem.horizons.back());
  MlpObjective judged(objective, result.gain_bound, kGainPenaltyFactor);
  result.start_gradient = GradientNorm(judged, parameters, &result.start);
  MinimizeLbfgs(
      judged, problem.iterations, [](const double*, double) { return true; }, parameters);
  ResamplerModel model;
  result.share = LimitGain(LargestGain(result.gain_bound), model, parameters);
  result.end_gradient = GradientNorm(judged, parameters, &result.end);
  JudgeWeights(model.Forward(parameters.data()).weights, &result);
  result.parameters = std::move(parameters);
  return result;
}

}  // namespace warplut
