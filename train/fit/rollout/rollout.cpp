#include "train/fit/rollout/rollout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace warplut {
namespace {

constexpr int kInner = kRolloutMargin;

// The whole part of -v, the node at or before it, and how far beyond that, in intervals.
struct AxisStep {
  int cell = 0;
  int node = 0;
  double beyond = 0;
};

AxisStep Split(double v) {
  const double position = -v * kNodes;
  const int node = static_cast<int>(std::floor(position));
  const int cell = node >= 0 ? node / kNodes : -((kNodes - 1 - node) / kNodes);
  return {cell, node - cell * kNodes, position - node};
}

}  // namespace

std::vector<RolloutStep> ToSteps(std::span<const Displacement> trajectory) {
  std::vector<RolloutStep> steps;
  steps.reserve(trajectory.size());
  for (const Displacement& v : trajectory) {
    const AxisStep x = Split(v.x), y = Split(v.y);
    steps.push_back({ToCanonical(x.node, y.node),
                     x.cell,
                     y.cell,
                     x.beyond,
                     y.beyond,
                     {ToCanonical(x.node + 1, y.node), ToCanonical(x.node, y.node + 1),
                      ToCanonical(x.node + 1, y.node + 1)}});
  }
  return steps;
}

std::array<NodeShare, 4> SharesOf(const RolloutStep& step) {
  const double x = step.beyond_x, y = step.beyond_y;
  return {{{step.node, (1 - x) * (1 - y)},
           {step.others[0], x * (1 - y)},
           {step.others[1], (1 - x) * y},
           {step.others[2], x * y}}};
}

Stencil ToStencil(const RolloutStep& step, const Resampler& resampler) {
  Weights<double> weights{};
  for (const auto& [node, share] : SharesOf(step)) {
    if (share == 0) continue;
    const Weights<double>& canonical = resampler.weights[node.index];
    for (const int k : TapsOf(resampler.footprint)) {
      weights[k] += share * canonical[MapWeight(node.symmetry, k)];
    }
  }
  Stencil stencil{step.cell_x, step.cell_y, {}, resampler.footprint};
  std::transform(weights.begin(), weights.end(), stencil.weights.begin(),
                 [](double w) { return static_cast<float>(w); });
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
    const Stencil stencil = ToStencil(rollout.steps[i], resampler);
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
    AdjointStencil(ToStencil(step, resampler), with_prefilter ? coefficients_[i] : image,
                   with_samples ? warped_[i] : planes_[i], gradient_, next_gradient_, step_gradient,
                   with_prefilter ? Border::kMirrored : Border::kRepeated);
    if (with_prefilter) {
      prefilter_.Adjoint(image, coefficients_[i], next_gradient_, gradient.prefilter);
    }
    std::swap(gradient_, next_gradient_);
    for (const auto& [node, share] : SharesOf(step)) {
      if (share == 0) continue;
      Weights<double>& canonical = gradient.weights[node.index];
      for (const int k : TapsOf(resampler.footprint)) {
        canonical[MapWeight(node.symmetry, k)] += share * step_gradient[k];
      }
    }
  }
}

}  // namespace warplut
