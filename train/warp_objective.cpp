#include "train/warp_objective.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "luts/filters.h"
#include "train/random.h"

namespace warplut {
namespace {

int KeysCount() { return static_cast<int>(std::lround((kKeysFirst - kKeysLast) / kKeysStep)) + 1; }
double KeysAt(int i) { return kKeysFirst - i * kKeysStep; }

using Workspaces = tbb::enumerable_thread_specific<RolloutWorkspace>;

}  // namespace

CanonicalWeights<double> KeysCanonicalWeights(double a) {
  CanonicalWeights<double> weights{};
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [i, j] = CanonicalPosition(c);
    weights[c] = KeysWeights(a, NodeOffset(i), NodeOffset(j));
  }
  return weights;
}

std::vector<Protocol> MakeProtocols(std::span<const int> horizons, bool with_pan) {
  std::vector<Protocol> protocols;
  for (const Offsets offsets : {Offsets::kHalf, Offsets::kRandom}) {
    for (const int warps : horizons) protocols.push_back({warps, offsets});
  }
  int& longest_half = protocols[horizons.size() - 1].warps;
  longest_half = 2 * static_cast<int>(std::lround(kHalfReserve * longest_half / 2));
  if (!with_pan) return protocols;
  const double cycles = static_cast<double>(horizons.back()) / kNodes;
  protocols.push_back({kNodes * std::max(1, static_cast<int>(std::lround(cycles))), Offsets::kPan});
  return protocols;
}

WarpObjective::WarpObjective(std::vector<BorderedPlane> crops, const std::vector<int>& horizons,
                             std::uint64_t seed, const WarpObjectiveOptions& options)
    : crops_(std::move(crops)),
      horizons_(horizons.size()),
      options_(options),
      protocols_(MakeProtocols(horizons, options.pans_per_crop > 0)) {
  AddRollouts(seed);
  baselines_ = FindBaselines();
}

WarpObjective::WarpObjective(std::vector<BorderedPlane> crops, const WarpObjective& like,
                             std::uint64_t seed, const WarpObjectiveOptions& options)
    : crops_(std::move(crops)),
      horizons_(like.horizons_),
      options_(options),
      protocols_(like.protocols_),
      baselines_(like.baselines_) {
  if (options_.pans_per_crop == 0) protocols_.resize(2 * horizons_);
  baselines_.resize(protocols_.size());
  AddRollouts(seed);
  const CanonicalWeights<double> catmull_rom = KeysCanonicalWeights(kCatmullRomA);
  const std::vector<double> here = Losses(catmull_rom);
  const std::vector<double> there = like.Losses(catmull_rom);
  for (std::size_t i = 0; i < baselines_.size(); ++i) baselines_[i] *= here[i] / there[i];
}

WarpObjective::Trajectory WarpObjective::MakeRolloutTrajectory(int first, int count,
                                                               std::uint64_t seed) const {
  Trajectory trajectory;
  trajectory.first = first;
  for (int i = first; i < first + count; ++i) trajectory.horizons.push_back(protocols_[i].warps);
  trajectory.steps =
      ToSteps(MakeTrajectory(protocols_[first].offsets, trajectory.horizons, kNodes, seed));
  return trajectory;
}

void WarpObjective::AddRollouts(std::uint64_t seed) {
  const int count = static_cast<int>(horizons_);
  const int pan = 2 * count;
  const int longest = protocols_[2 * count - 1].warps;
  std::uint64_t drawn = 0;
  for (int c = 0; c < static_cast<int>(crops_.size()); ++c) {
    ssim_.emplace_back(InnerView(crops_[c]));
    rollouts_.push_back({c, MakeRolloutTrajectory(0, count, 0)});
    for (int p = count; p < pan; ++p) {
      for (int warps = 0; warps < longest; warps += protocols_[p].warps) {
        rollouts_.push_back({c, MakeRolloutTrajectory(p, 1, DeriveSeed(seed, drawn++))});
      }
    }
    for (int i = 0; i < options_.pans_per_crop; ++i) {
      rollouts_.push_back({c, MakeRolloutTrajectory(pan, 1, DeriveSeed(seed, drawn++))});
    }
  }
  rollouts_per_protocol_.assign(protocols_.size(), 0);
  for (const Rollout& rollout : rollouts_) {
    for (std::size_t h = 0; h < rollout.trajectory.horizons.size(); ++h) {
      ++rollouts_per_protocol_[rollout.trajectory.first + h];
    }
  }
}

RolloutWorkspace WarpObjective::MakeWorkspace() const {
  int longest = 0;
  for (const Protocol& protocol : protocols_) longest = std::max(longest, protocol.warps);
  return {crops_[0].width(), crops_[0].height(), longest};
}

std::vector<double> WarpObjective::Losses(const CanonicalWeights<double>& weights) const {
  std::vector<double> losses(rollouts_.size() * horizons_);
  Workspaces workspaces([this] { return MakeWorkspace(); });
  tbb::parallel_for(std::size_t{0}, rollouts_.size(), [&](std::size_t r) {
    const auto& [crop, trajectory] = rollouts_[r];
    workspaces.local().Forward(
        crops_[crop], ssim_[crop], trajectory.steps, trajectory.horizons, weights,
        std::span(losses).subspan(r * horizons_, trajectory.horizons.size()));
  });
  std::vector<double> means(protocols_.size(), 0.0);
  for (std::size_t r = 0; r < rollouts_.size(); ++r) {
    const Trajectory& trajectory = rollouts_[r].trajectory;
    for (std::size_t h = 0; h < trajectory.horizons.size(); ++h) {
      means[trajectory.first + h] += losses[r * horizons_ + h];
    }
  }
  for (std::size_t i = 0; i < means.size(); ++i) means[i] /= rollouts_per_protocol_[i];
  return means;
}

std::vector<double> WarpObjective::FindBaselines() const {
  const std::size_t n = horizons_;
  std::vector<double> least(protocols_.size(), std::numeric_limits<double>::infinity());
  std::vector<double> baselines;
  for (int i = 0; i < KeysCount(); ++i) {
    const std::vector<double> losses = Losses(KeysCanonicalWeights(KeysAt(i)));
    if (losses[n - 1] < least[n - 1]) baselines = losses;
    for (std::size_t p = 0; p < losses.size(); ++p) least[p] = std::min(least[p], losses[p]);
  }
  std::copy_n(least.begin() + n, n - 1, baselines.begin() + n);
  return baselines;
}

double WarpObjective::Combine(std::span<const double> losses, std::span<double> factors) const {
  struct Kind {
    std::size_t first, count;
    double share;
  };
  const double rest = 1 - options_.pan_share;
  const Kind kinds[] = {{0, horizons_, rest * kHalfShare},
                        {horizons_, horizons_, rest * (1 - kHalfShare)},
                        {2 * horizons_, protocols_.size() - 2 * horizons_, options_.pan_share}};
  double total = 0;
  for (const auto& [first, count, share] : kinds) {
    if (count == 0) continue;
    double mean = 0;
    for (std::size_t i = first; i < first + count; ++i) {
      mean += std::pow(losses[i] / baselines_[i], options_.power) / static_cast<double>(count);
    }
    const double power_mean = std::pow(mean, 1 / options_.power);
    total += share * power_mean;
    for (std::size_t i = first; i < first + count; ++i) {
      factors[i] = share * std::pow(losses[i] / baselines_[i] / power_mean, options_.power - 1) /
                   (static_cast<double>(count) * baselines_[i]);
    }
  }
  return total;
}

double WarpObjective::Evaluate(const CanonicalWeights<double>& weights,
                               CanonicalWeights<double>* gradient) const {
  std::vector<double> factors(protocols_.size());
  const double value = Combine(Losses(weights), factors);
  if (gradient == nullptr) return value;
  for (std::size_t i = 0; i < factors.size(); ++i) factors[i] /= rollouts_per_protocol_[i];

  std::vector<CanonicalWeights<double>> gradients(rollouts_.size());
  Workspaces workspaces([this] { return MakeWorkspace(); });
  tbb::parallel_for(std::size_t{0}, rollouts_.size(), [&](std::size_t r) {
    const auto& [crop, trajectory] = rollouts_[r];
    const std::size_t count = trajectory.horizons.size();
    RolloutWorkspace& workspace = workspaces.local();
    std::vector<double> losses(count);
    workspace.Forward(crops_[crop], ssim_[crop], trajectory.steps, trajectory.horizons, weights,
                      losses);
    workspace.Backward(crops_[crop], ssim_[crop], trajectory.steps, trajectory.horizons,
                       std::span(factors).subspan(trajectory.first, count), weights, gradients[r]);
  });
  *gradient = {};
  for (const CanonicalWeights<double>& part : gradients) {
    for (int c = 0; c < kCanonicalNodes; ++c) {
      for (int k = 0; k < kWeights; ++k) (*gradient)[c][k] += part[c][k];
    }
  }
  return value;
}

double FitKeys(const WarpObjective& objective) {
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < KeysCount(); ++i) {
    const double value = objective.Evaluate(KeysCanonicalWeights(KeysAt(i)));
    if (value < least) {
      least = value;
      best = KeysAt(i);
    }
  }
  return best;
}

}  // namespace warplut
