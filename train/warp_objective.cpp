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

std::vector<Protocol> MakeProtocols(std::span<const int> horizons) {
  std::vector<Protocol> protocols;
  for (const Offsets offsets : {Offsets::kHalf, Offsets::kRandom}) {
    for (const int warps : horizons) protocols.push_back({warps, offsets});
  }
  int& longest_half = protocols[horizons.size() - 1].warps;
  longest_half = 2 * static_cast<int>(std::lround(kHalfReserve * longest_half / 2));
  return protocols;
}

WarpObjective::WarpObjective(std::vector<BorderedPlane> crops, std::vector<int> horizons,
                             std::uint64_t seed, double power)
    : crops_(std::move(crops)),
      random_horizons_(std::move(horizons)),
      power_(power),
      protocols_(MakeProtocols(random_horizons_)) {
  AddRollouts(seed);
  baselines_ = FindBaselines();
}

WarpObjective::WarpObjective(std::vector<BorderedPlane> crops, const WarpObjective& like,
                             std::uint64_t seed, double power)
    : crops_(std::move(crops)),
      random_horizons_(like.random_horizons_),
      power_(power),
      protocols_(like.protocols_),
      baselines_(like.baselines_) {
  AddRollouts(seed);
  const CanonicalWeights<double> catmull_rom = KeysCanonicalWeights(kCatmullRomA);
  const std::vector<double> here = Losses(catmull_rom);
  const std::vector<double> there = like.Losses(catmull_rom);
  for (std::size_t i = 0; i < baselines_.size(); ++i) baselines_[i] *= here[i] / there[i];
}

void WarpObjective::AddRollouts(std::uint64_t seed) {
  for (const BorderedPlane& crop : crops_) ssim_.emplace_back(InnerView(crop));
  const int longest = random_horizons_.back();
  const int half_protocols = static_cast<int>(random_horizons_.size());
  for (int h = 0; h < half_protocols; ++h) half_horizons_.push_back(protocols_[h].warps);
  const auto half = ToSteps(MakeTrajectory(Offsets::kHalf, half_horizons_, kNodes, 0));
  rollouts_per_protocol_.assign(protocols_.size(), 0);
  std::uint64_t trajectory = 0;
  for (int c = 0; c < static_cast<int>(crops_.size()); ++c) {
    rollouts_.push_back({c, half, half_horizons_, 0});
    for (int h = 0; h < half_protocols; ++h) {
      ++rollouts_per_protocol_[h];
      const std::span<const int> horizon(&random_horizons_[h], 1);
      for (int warps = 0; warps < longest; warps += horizon[0]) {
        const std::uint64_t trajectory_seed = DeriveSeed(seed, trajectory++);
        rollouts_.push_back(
            {c, ToSteps(MakeTrajectory(Offsets::kRandom, horizon, kNodes, trajectory_seed)),
             horizon, half_protocols + h});
        ++rollouts_per_protocol_[half_protocols + h];
      }
    }
  }
}

std::vector<double> WarpObjective::Losses(const CanonicalWeights<double>& weights) const {
  const std::size_t n = random_horizons_.size();
  std::vector<double> losses(rollouts_.size() * n);
  Workspaces workspaces(
      RolloutWorkspace(crops_[0].width(), crops_[0].height(), half_horizons_.back()));
  tbb::parallel_for(std::size_t{0}, rollouts_.size(), [&](std::size_t r) {
    const Rollout& rollout = rollouts_[r];
    workspaces.local().Forward(crops_[rollout.crop], ssim_[rollout.crop], rollout.steps,
                               rollout.horizons, weights,
                               std::span(losses).subspan(r * n, rollout.horizons.size()));
  });
  std::vector<double> means(protocols_.size(), 0.0);
  for (std::size_t r = 0; r < rollouts_.size(); ++r) {
    const Rollout& rollout = rollouts_[r];
    for (std::size_t h = 0; h < rollout.horizons.size(); ++h) {
      means[rollout.first_protocol + h] += losses[r * n + h];
    }
  }
  for (std::size_t i = 0; i < means.size(); ++i) means[i] /= rollouts_per_protocol_[i];
  return means;
}

std::vector<double> WarpObjective::FindBaselines() const {
  const std::size_t n = random_horizons_.size();
  std::vector<double> least(protocols_.size(), std::numeric_limits<double>::infinity());
  std::vector<double> durable;
  for (int i = 0; i < KeysCount(); ++i) {
    const std::vector<double> losses = Losses(KeysCanonicalWeights(KeysAt(i)));
    if (losses[n - 1] < least[n - 1]) durable = losses;
    for (std::size_t p = 0; p < losses.size(); ++p) least[p] = std::min(least[p], losses[p]);
  }
  std::vector<double> baselines = durable;
  std::copy_n(least.begin() + n, n - 1, baselines.begin() + n);
  return baselines;
}

double WarpObjective::Combine(std::span<const double> losses, std::span<double> factors) const {
  const std::size_t n = random_horizons_.size();
  double total = 0;
  for (const std::size_t first : {std::size_t{0}, n}) {
    double mean = 0;
    for (std::size_t i = first; i < first + n; ++i) {
      mean += std::pow(losses[i] / baselines_[i], power_) / static_cast<double>(n);
    }
    const double power_mean = std::pow(mean, 1 / power_);
    total += power_mean / 2;
    for (std::size_t i = first; i < first + n; ++i) {
      factors[i] = std::pow(losses[i] / baselines_[i] / power_mean, power_ - 1) /
                   (2 * static_cast<double>(n) * baselines_[i]);
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
  Workspaces workspaces(
      RolloutWorkspace(crops_[0].width(), crops_[0].height(), half_horizons_.back()));
  tbb::parallel_for(std::size_t{0}, rollouts_.size(), [&](std::size_t r) {
    const Rollout& rollout = rollouts_[r];
    const BorderedPlane& image = crops_[rollout.crop];
    const std::size_t count = rollout.horizons.size();
    RolloutWorkspace& workspace = workspaces.local();
    const Ssim& ssim = ssim_[rollout.crop];
    std::vector<double> losses(count);
    workspace.Forward(image, ssim, rollout.steps, rollout.horizons, weights, losses);
    workspace.Backward(image, ssim, rollout.steps, rollout.horizons,
                       std::span(factors).subspan(rollout.first_protocol, count), weights,
                       gradients[r]);
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
