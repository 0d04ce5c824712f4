#include "train/objective.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "luts/filters.h"
#include "train/keys_search.h"

namespace warplut {
namespace {

using Workspaces = tbb::enumerable_thread_specific<RolloutWorkspace>;

}  // namespace

Objective::Objective(std::vector<BorderedPlane> crops, std::vector<Protocol> protocols,
                     std::vector<Kind> kinds, double power)
    : crops_(std::move(crops)),
      protocols_(std::move(protocols)),
      kinds_(std::move(kinds)),
      power_(power),
      rollouts_per_protocol_(protocols_.size(), 0.0) {
  for (const BorderedPlane& crop : crops_) ssim_.emplace_back(InnerView(crop));
}

std::vector<Displacement> Objective::DrawTrajectory(std::size_t first, std::size_t count,
                                                    std::uint64_t seed) const {
  std::vector<int> horizons;
  for (std::size_t i = first; i < first + count; ++i) horizons.push_back(protocols_[i].warps);
  return MakeTrajectory(protocols_[first].offsets, horizons, kNodes, seed);
}

Rollout& Objective::AddRollout(std::size_t crop, std::size_t first, std::size_t count,
                               std::span<const Displacement> trajectory) {
  JudgedRollout& judged = rollouts_.emplace_back();
  judged.crop = crop;
  judged.first = first;
  Rollout& rollout = judged.rollout;
  rollout.start = &crops_[crop];
  rollout.ssim = &ssim_[crop];
  rollout.steps = ToSteps(trajectory);
  for (std::size_t i = first; i < first + count; ++i) {
    rollout.horizons.push_back(protocols_[i].warps);
    ++rollouts_per_protocol_[i];
  }
  return rollout;
}

void Objective::SetBaselines(std::vector<double> baselines, double keys_a) {
  keys_a_ = keys_a;
  baselines_ = std::move(baselines);
  for (double& baseline : baselines_) baseline = std::max(baseline, kLeastBaseline);
}

void Objective::ScaleBaselines(const Objective& like) {
  const CanonicalWeights<double> keys = KeysCanonicalWeights(like.keys_a_);
  const std::vector<double> here = Losses(keys);
  const std::vector<double> there = like.Losses(keys);
  std::vector<double> baselines(like.baselines_.begin(),
                                like.baselines_.begin() + protocols_.size());
  for (std::size_t i = 0; i < baselines.size(); ++i) {
    baselines[i] *= here[i] / std::max(there[i], kLeastBaseline);
  }
  SetBaselines(std::move(baselines), like.keys_a_);
}

std::vector<double> Objective::Losses(const CanonicalWeights<double>& weights) const {
  std::vector<std::vector<double>> losses(rollouts_.size());
  Workspaces workspaces(crops_[0].width(), crops_[0].height());
  tbb::parallel_for(std::size_t{0}, rollouts_.size(), [&](std::size_t r) {
    const Rollout& rollout = rollouts_[r].rollout;
    losses[r].resize(rollout.horizons.size());
    workspaces.local().Forward(rollout, weights, losses[r]);
  });
  std::vector<double> means(protocols_.size(), 0.0);
  for (std::size_t r = 0; r < rollouts_.size(); ++r) {
    for (std::size_t h = 0; h < losses[r].size(); ++h)
      means[rollouts_[r].first + h] += losses[r][h];
  }
  for (std::size_t i = 0; i < means.size(); ++i) means[i] /= rollouts_per_protocol_[i];
  return means;
}

double Objective::Combine(std::span<const double> losses, std::span<double> factors) const {
  double total = 0;
  for (const auto& [first, count, share] : kinds_) {
    if (count == 0) continue;
    double largest = 0, sum = 0;
    for (std::size_t i = first; i < first + count; ++i) {
      largest = std::max(largest, losses[i] / baselines_[i]);
      sum += losses[i] / baselines_[i];
    }
    if (largest == 0) {  // nothing is lost, or the losses are not numbers
      std::fill_n(factors.begin() + static_cast<std::ptrdiff_t>(first), count, 0.0);
      total += share * sum;
      continue;
    }
    // Relative to the largest, whose power may be no number.
    double mean = 0;
    for (std::size_t i = first; i < first + count; ++i) {
      mean += std::pow(losses[i] / baselines_[i] / largest, power_) / static_cast<double>(count);
    }
    const double power_mean = largest * std::pow(mean, 1 / power_);
    total += share * power_mean;
    for (std::size_t i = first; i < first + count; ++i) {
      factors[i] = share * std::pow(losses[i] / baselines_[i] / power_mean, power_ - 1) /
                   (static_cast<double>(count) * baselines_[i]);
    }
  }
  return total;
}

double Objective::Value(std::span<const double> losses) const {
  std::vector<double> factors(protocols_.size());
  return Combine(losses, factors);
}

double Objective::Evaluate(const CanonicalWeights<double>& weights,
                           CanonicalWeights<double>* gradient) const {
  if (gradient == nullptr) return Value(Losses(weights));
  std::vector<double> factors(protocols_.size());
  const double value = Combine(Losses(weights), factors);
  for (std::size_t i = 0; i < factors.size(); ++i) factors[i] /= rollouts_per_protocol_[i];

  std::vector<CanonicalWeights<double>> gradients(rollouts_.size());
  Workspaces workspaces(crops_[0].width(), crops_[0].height());
  tbb::parallel_for(std::size_t{0}, rollouts_.size(), [&](std::size_t r) {
    const Rollout& rollout = rollouts_[r].rollout;
    const std::size_t first = rollouts_[r].first;
    const std::size_t count = rollout.horizons.size();
    RolloutWorkspace& workspace = workspaces.local();
    std::vector<double> losses(count);
    workspace.Forward(rollout, weights, losses);
    workspace.Backward(rollout, std::span(factors).subspan(first, count), weights, gradients[r]);
  });
  *gradient = {};
  for (const CanonicalWeights<double>& part : gradients) {
    for (int c = 0; c < kCanonicalNodes; ++c) {
      for (int k = 0; k < kWeights; ++k) (*gradient)[c][k] += part[c][k];
    }
  }
  return value;
}

}  // namespace warplut
