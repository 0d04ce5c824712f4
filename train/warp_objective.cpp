#include "train/warp_objective.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "train/keys_search.h"
#include "train/random.h"

namespace warplut {
namespace {

// The baselines, and the kernel that most of them are of.
KeysLoss FindBaselines(const Objective& objective, std::size_t horizons) {
  const std::size_t n = horizons;
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> least(objective.protocols().size(), infinity);
  KeysLoss baselines;
  for (const KeysLoss& keys : KeysLosses(objective)) {
    if (keys.losses[n - 1] < least[n - 1]) baselines = keys;
    for (std::size_t p = 0; p < least.size(); ++p) least[p] = std::min(least[p], keys.losses[p]);
  }
  std::copy_n(least.begin() + n, n - 1, baselines.losses.begin() + n);
  return baselines;
}

}  // namespace

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
                             std::uint64_t seed, const WarpObjectiveOptions& options,
                             const Objective* like)
    : Objective(std::move(crops), MakeProtocols(horizons, options.pans_per_crop > 0),
                {{0, horizons.size(), (1 - options.pan_share) * kHalfShare},
                 {horizons.size(), horizons.size(), (1 - options.pan_share) * (1 - kHalfShare)},
                 {2 * horizons.size(), options.pans_per_crop > 0 ? 1u : 0u, options.pan_share}},
                options.power) {
  const std::size_t count = horizons.size();
  const std::size_t pan = 2 * count;
  std::uint64_t drawn = 0;
  const auto add = [&](std::size_t crop, std::size_t protocol) {
    AddRollout(crop, protocol, 1, DrawTrajectory(protocol, 1, DeriveSeed(seed, drawn++)));
  };
  const std::vector<Displacement> half = DrawTrajectory(0, count, seed);
  for (std::size_t c = 0; c < this->crops().size(); ++c) {
    AddRollout(c, 0, count, half);
    for (std::size_t p = count; p < pan; ++p) {
      for (int warps = 0; warps < horizons.back(); warps += protocols()[p].warps) add(c, p);
    }
    for (int i = 0; i < options.pans_per_crop; ++i) add(c, pan);
  }
  if (like != nullptr) {
    ScaleBaselines(*like);
  } else {
    const KeysLoss found = FindBaselines(*this, count);
    SetBaselines(found.losses, found.a);
  }
}

}  // namespace warplut
