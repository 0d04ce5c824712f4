#include "train/fit/objective/warp_objective.h"

#include <algorithm>
#include <cmath>

#include "train/fit/random.h"
#include "train/fit/rivals/rivals.h"

namespace warplut {
namespace {

std::size_t PanCount(std::span<const int> horizons, bool with_pan) {
  return MakeProtocols(horizons, with_pan).size() - 2 * horizons.size();
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
  int last = 0;
  for (const int horizon : horizons) {
    const int cycles = static_cast<int>(std::lround(static_cast<double>(horizon) / kNodes));
    const int warps = kNodes * std::max(1, cycles);
    if (warps > last) protocols.push_back({warps, Offsets::kPan});
    last = warps;
  }
  return protocols;
}

WarpObjective::WarpObjective(std::vector<BorderedPlane> crops, const std::vector<int>& horizons,
                             std::uint64_t seed, const WarpObjectiveOptions& options,
                             const Objective* like)
    : Objective(
          std::move(crops), MakeProtocols(horizons, options.pans_per_crop > 0),
          {{0, horizons.size(), (1 - options.pan_share) * kHalfShare},
           {horizons.size(), horizons.size(), (1 - options.pan_share) * (1 - kHalfShare)},
           {2 * horizons.size(), PanCount(horizons, options.pans_per_crop > 0), options.pan_share}},
          options.power) {
  const std::size_t count = horizons.size();
  const std::size_t pan = 2 * count;
  std::uint64_t drawn = 0;
  const auto add = [&](std::size_t crop, std::size_t protocol) {
    AddRollout(crop, protocol, 1,
               DrawTrajectory(protocol, 1, DeriveSeed(seed, drawn++),
                              RandomSteps(options.rivals.footprint)));
  };
  const std::vector<Displacement> half = DrawTrajectory(0, count, seed);
  for (std::size_t c = 0; c < this->crops().size(); ++c) {
    AddRollout(c, 0, count, half);
    for (std::size_t p = count; p < pan; ++p) {
      for (int warps = 0; warps < horizons.back(); warps += protocols()[p].warps) add(c, p);
    }
    for (std::size_t p = pan; p < protocols().size(); ++p) {
      for (int i = 0; i < options.pans_per_crop; ++i) add(c, p);
    }
  }
  if (like != nullptr) {
    ScaleBaselines(*like);
    return;
  }
  const std::vector<Rival> rivals = JudgeRivals(*this, options.rivals);
  const Rival& yardstick = BestRival(rivals, count - 1);
  std::vector<double> baselines = LeastLosses(rivals);
  if (options.rivals.HasKeys()) {
    std::copy_n(yardstick.losses.begin(), count, baselines.begin());
    std::copy(yardstick.losses.begin() + static_cast<std::ptrdiff_t>(pan) - 1,
              yardstick.losses.end(), baselines.begin() + static_cast<std::ptrdiff_t>(pan) - 1);
  }
  SetBaselines(std::move(baselines), yardstick.resampler);
}

}  // namespace warplut
