#include "train/fit/objective/objective.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "train/ranks/ranks.h"

namespace warplut {
namespace {

using Workspaces = tbb::enumerable_thread_specific<RolloutWorkspace>;

// Calls run(r) for each rollout of this rank, in parallel.
template <class Run>
void ForOwn(const std::vector<int>& owners, const Run& run) {
  const int rank = Ranks::World().rank();
  tbb::parallel_for(std::size_t{0}, owners.size(), [&](std::size_t r) {
    if (owners[r] == rank) run(r);
  });
}

// Completes the gradients of the other ranks' rollouts.
void ExchangeGradients(const std::vector<int>& owners, std::vector<Resampler>& gradients) {
  Ranks& ranks = Ranks::World();
  if (ranks.count() == 1) return;
  std::vector<std::vector<double>> numbers(gradients.size());
  for (std::size_t r = 0; r < gradients.size(); ++r) {
    if (owners[r] == ranks.rank()) numbers[r] = gradients[r].Numbers();
  }
  ranks.Exchange(owners, numbers);
  for (std::size_t r = 0; r < gradients.size(); ++r) gradients[r].SetNumbers(numbers[r]);
}

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
                                                    std::uint64_t seed, int steps) const {
  std::vector<int> horizons;
  for (std::size_t i = first; i < first + count; ++i) horizons.push_back(protocols_[i].warps);
  return MakeTrajectory(protocols_[first].offsets, horizons, steps, seed);
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

void Objective::SetBaselines(std::vector<double> baselines, const Resampler& yardstick) {
  yardstick_ = yardstick;
  baselines_ = std::move(baselines);
  for (double& baseline : baselines_) baseline = std::max(baseline, kLeastBaseline);
}

void Objective::ScaleBaselines(const Objective& like) {
  const std::vector<double> here = Losses(like.yardstick_);
  const std::vector<double> there = like.Losses(like.yardstick_);
  std::vector<double> baselines(like.baselines_.begin(),
                                like.baselines_.begin() + protocols_.size());
  for (std::size_t i = 0; i < baselines.size(); ++i) {
    baselines[i] *= here[i] / std::max(there[i], kLeastBaseline);
  }
  SetBaselines(std::move(baselines), like.yardstick_);
}

std::vector<int> Objective::Owners() const {
  std::vector<double> work;
  work.reserve(rollouts_.size());
  for (const JudgedRollout& judged : rollouts_) {
    work.push_back(static_cast<double>(judged.rollout.steps.size()));
  }
  return BalancedOwners(work, Ranks::World().count());
}

std::vector<double> Objective::Losses(const Resampler& resampler) const {
  std::vector<std::vector<double>> losses(rollouts_.size());
  const std::vector<int> owners = Owners();
  Workspaces workspaces(crops_[0].width(), crops_[0].height());
  ForOwn(owners, [&](std::size_t r) {
    const Rollout& rollout = rollouts_[r].rollout;
    losses[r].resize(rollout.horizons.size());
    workspaces.local().Losses(rollout, resampler, losses[r]);
  });
  Ranks::World().Exchange(owners, losses);
  return MeanLosses(losses);
}

std::vector<double> Objective::MeanLosses(const std::vector<std::vector<double>>& losses) const {
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

double Objective::Evaluate(const Resampler& resampler, Resampler* gradient) const {
  if (gradient == nullptr) return Value(Losses(resampler));
  std::vector<std::vector<double>> losses(rollouts_.size());
  std::vector<Resampler> gradients(rollouts_.size());
  Workspaces workspaces(crops_[0].width(), crops_[0].height());
  // A rollout with one horizon needs no factor to be derived: it is run once.
  const std::array<double, 1> one = {1.0};
  const std::vector<int> owners = Owners();
  ForOwn(owners, [&](std::size_t r) {
    const Rollout& rollout = rollouts_[r].rollout;
    RolloutWorkspace& workspace = workspaces.local();
    losses[r].resize(rollout.horizons.size());
    if (losses[r].size() > 1) {
      workspace.Losses(rollout, resampler, losses[r]);
      return;
    }
    workspace.Forward(rollout, resampler, losses[r]);
    workspace.Backward(rollout, one, resampler, gradients[r]);
  });
  Ranks::World().Exchange(owners, losses);
  std::vector<double> factors(protocols_.size());
  const double value = Combine(MeanLosses(losses), factors);
  for (std::size_t i = 0; i < factors.size(); ++i) factors[i] /= rollouts_per_protocol_[i];
  ForOwn(owners, [&](std::size_t r) {
    const auto& [rollout, crop, first] = rollouts_[r];
    if (losses[r].size() == 1) return;
    RolloutWorkspace& workspace = workspaces.local();
    workspace.Forward(rollout, resampler, losses[r]);
    workspace.Backward(rollout, std::span(factors).subspan(first, losses[r].size()), resampler,
                       gradients[r]);
  });
  ExchangeGradients(owners, gradients);
  *gradient = {};
  for (std::size_t r = 0; r < rollouts_.size(); ++r) {
    gradient->Add(losses[r].size() == 1 ? factors[rollouts_[r].first] : 1, gradients[r]);
  }
  return value;
}

}  // namespace warplut
