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

RolloutWorkspace::RolloutWorkspace(int width, int height, int max_warps)
    : planes_(max_warps, BorderedPlane(width, height)),
      gradient_(width, height),
      next_gradient_(width, height) {}

void RolloutWorkspace::Forward(const BorderedPlane& image, const Ssim& ssim,
                               std::span<const RolloutStep> steps, std::span<const int> horizons,
                               const CanonicalWeights<double>& weights, std::span<double> losses) {
  std::size_t h = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    ApplyStencil(ToStencil(steps[i], weights), i == 0 ? image : planes_[i - 1], planes_[i]);
    if (h < horizons.size() && static_cast<int>(i) + 1 == horizons[h]) {
      losses[h++] = 1.0 - ssim.Mean(InnerView(planes_[i]));
    }
  }
}

void RolloutWorkspace::Backward(const BorderedPlane& image, const Ssim& ssim,
                                std::span<const RolloutStep> steps, std::span<const int> horizons,
                                std::span<const double> factors,
                                const CanonicalWeights<double>& weights,
                                CanonicalWeights<double>& gradient) {
  gradient_.Clear();
  std::size_t h = horizons.size();
  for (std::size_t i = steps.size(); i-- > 0;) {
    if (h > 0 && horizons[h - 1] == static_cast<int>(i) + 1) {
      --h;
      ssim.MeanAndGradient(InnerView(planes_[i]), static_cast<float>(-factors[h]),
                           gradient_.row(kInner) + kInner, gradient_.stride());
    }
    const RolloutStep& step = steps[i];
    Weights<double> step_gradient{};
    AdjointStencil(ToStencil(step, weights), i == 0 ? image : planes_[i - 1], planes_[i], gradient_,
                   next_gradient_, step_gradient);
    std::swap(gradient_, next_gradient_);
    Weights<double>& canonical = gradient[step.node.index];
    for (int k = 0; k < kWeights; ++k) {
      canonical[MapWeight(step.node.symmetry, k)] += step_gradient[k];
    }
  }
}

}  // namespace warplut
