#include "train/fit/rollout.h"

#include <cmath>
#include <utility>

namespace warplut {
namespace {

constexpr int kInner = kRolloutMargin;

// The whole part and node of -v.
std::pair<int, int> Split(double v) {
  const int position = static_cast<int>(std::lround(-v * kNodes));
  const int cell = position >= 0 ? position / kNodes : -((kNodes - 1 - position) / kNodes);
  return {cell, position - cell * kNodes};
}

}  // namespace

std::vector<RolloutStep> ToSteps(std::span<const Displacement> trajectory) {
  std::vector<RolloutStep> steps;
  steps.reserve(trajectory.size());
  for (const Displacement& v : trajectory) {
    const auto [cell_x, ix] = Split(v.x);
    const auto [cell_y, jy] = Split(v.y);
    steps.push_back({ToCanonical(ix, jy), cell_x, cell_y});
  }
  return steps;
}

Stencil ToStencil(const RolloutStep& step, const CanonicalWeights<double>& weights) {
  Stencil stencil{step.cell_x, step.cell_y, {}};
  const Weights<double>& canonical = weights[step.node.index];
  for (int k = 0; k < kWeights; ++k) {
    stencil.weights[k] = static_cast<float>(canonical[MapWeight(step.node.symmetry, k)]);
  }
  return stencil;
}

PlaneView InnerView(const BorderedPlane& plane) {
  return {plane.row(kInner) + kInner, plane.width() - 2 * kInner, plane.height() - 2 * kInner,
          plane.stride()};
}

void RolloutWorkspace::Reserve(std::size_t steps, bool with_samples, bool with_prefilter) {
  const BorderedPlane empty(gradient_.width(), gradient_.height());
  const auto reserve = [&](std::vector<BorderedPlane>& planes) {
    if (planes.size() < steps) planes.resize(steps, empty);
  };
  reserve(planes_);
  if (with_samples) reserve(warped_);
  if (with_prefilter) reserve(coefficients_);
}

void RolloutWorkspace::Losses(const Rollout& rollout, const Resampler& resampler,
                              std::span<double> losses) {
  Run(rollout, resampler, 2, losses);
}

void RolloutWorkspace::Forward(const Rollout& rollout, const Resampler& resampler,
                               std::span<double> losses) {
  Run(rollout, resampler, rollout.steps.size(), losses);
}

void RolloutWorkspace::Run(const Rollout& rollout, const Resampler& resampler, std::size_t kept,
                           std::span<double> losses) {
  const bool with_samples = !rollout.frames.empty();
  const bool with_prefilter = HasPrefilter(resampler.prefilter);
  Reserve(kept, with_samples, with_prefilter);
  if (with_prefilter) prefilter_.Set(resampler.prefilter);
  std::size_t h = 0;
  for (std::size_t i = 0; i < rollout.steps.size(); ++i) {
    const std::size_t at = i % kept;
    const BorderedPlane& image = i == 0 ? *rollout.start : planes_[(i - 1) % kept];
    if (with_prefilter) prefilter_.Apply(image, coefficients_[at]);
    const BorderedPlane& in = with_prefilter ? coefficients_[at] : image;
    const Stencil stencil = ToStencil(rollout.steps[i], resampler.weights);
    if (with_samples) {
      ApplyStencil(stencil, in, warped_[at]);
      const FrameSamples& frame = rollout.frames[i];
      frame.grid->Refresh(frame.values, warped_[at], planes_[at]);
      FillBorder(planes_[at]);
    } else {
      ApplyStencil(stencil, in, planes_[at]);
    }
    if (h < rollout.horizons.size() && static_cast<int>(i) + 1 == rollout.horizons[h]) {
      losses[h++] = 1.0 - rollout.ssim->Mean(InnerView(planes_[at]));
    }
  }
}

void RolloutWorkspace::Backward(const Rollout& rollout, std::span<const double> factors,
                                const Resampler& resampler, Resampler& gradient) {
  const bool with_samples = !rollout.frames.empty();
  const bool with_prefilter = HasPrefilter(resampler.prefilter);
  gradient_.Clear();
  std::size_t h = rollout.horizons.size();
  for (std::size_t i = rollout.steps.size(); i-- > 0;) {
    if (h > 0 && rollout.horizons[h - 1] == static_cast<int>(i) + 1) {
      --h;
      rollout.ssim->MeanAndGradient(InnerView(planes_[i]), static_cast<float>(-factors[h]),
                                    gradient_.row(kInner) + kInner, gradient_.stride());
    }
    if (with_samples) rollout.frames[i].grid->AdjointRefresh(gradient_);
    const RolloutStep& step = rollout.steps[i];
    const BorderedPlane& image = i == 0 ? *rollout.start : planes_[i - 1];
    Weights<double> step_gradient{};
    AdjointStencil(ToStencil(step, resampler.weights), with_prefilter ? coefficients_[i] : image,
                   with_samples ? warped_[i] : planes_[i], gradient_, next_gradient_, step_gradient,
                   with_prefilter ? Border::kMirrored : Border::kRepeated);
    if (with_prefilter) {
      prefilter_.Adjoint(image, coefficients_[i], next_gradient_, gradient.prefilter);
    }
    std::swap(gradient_, next_gradient_);
    Weights<double>& canonical = gradient.weights[step.node.index];
    for (int k = 0; k < kWeights; ++k) {
      canonical[MapWeight(step.node.symmetry, k)] += step_gradient[k];
    }
  }
}

}  // namespace warplut
