#include "train/rollout.h"

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

void RolloutWorkspace::Reserve(std::size_t steps, bool with_samples) {
  const BorderedPlane empty(gradient_.width(), gradient_.height());
  if (planes_.size() < steps) planes_.resize(steps, empty);
  if (with_samples && warped_.size() < steps) warped_.resize(steps, empty);
}

void RolloutWorkspace::Forward(const Rollout& rollout, const CanonicalWeights<double>& weights,
                               std::span<double> losses) {
  const bool with_samples = !rollout.frames.empty();
  Reserve(rollout.steps.size(), with_samples);
  std::size_t h = 0;
  for (std::size_t i = 0; i < rollout.steps.size(); ++i) {
    const BorderedPlane& in = i == 0 ? *rollout.start : planes_[i - 1];
    const Stencil stencil = ToStencil(rollout.steps[i], weights);
    if (with_samples) {
      ApplyStencil(stencil, in, warped_[i]);
      const FrameSamples& frame = rollout.frames[i];
      frame.grid->Refresh(frame.values, warped_[i], planes_[i]);
      FillBorder(planes_[i]);
    } else {
      ApplyStencil(stencil, in, planes_[i]);
    }
    if (h < rollout.horizons.size() && static_cast<int>(i) + 1 == rollout.horizons[h]) {
      losses[h++] = 1.0 - rollout.ssim->Mean(InnerView(planes_[i]));
    }
  }
}

void RolloutWorkspace::Backward(const Rollout& rollout, std::span<const double> factors,
                                const CanonicalWeights<double>& weights,
                                CanonicalWeights<double>& gradient) {
  const bool with_samples = !rollout.frames.empty();
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
    Weights<double> step_gradient{};
    AdjointStencil(ToStencil(step, weights), i == 0 ? *rollout.start : planes_[i - 1],
                   with_samples ? warped_[i] : planes_[i], gradient_, next_gradient_,
                   step_gradient);
    std::swap(gradient_, next_gradient_);
    Weights<double>& canonical = gradient[step.node.index];
    for (int k = 0; k < kWeights; ++k) {
      canonical[MapWeight(step.node.symmetry, k)] += step_gradient[k];
    }
  }
}

}  // namespace warplut
