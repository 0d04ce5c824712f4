// Objective `warp`: the loss of repeated warps relative to that of the best closed-form filter
// (train/fit/rivals/rivals.h): a Keys kernel, a spline with a prefilter, or a windowed sinc of 36
// taps.
//
// The form of train/fit/objective/objective.h with the kinds half, random and pan, whose shares are
// (1 - q) h, (1 - q) (1 - h) and q. Exponents p are large, so that no horizon is bought with
// another. Baselines are, on the same crops and trajectories: of splines and windowed sincs, the
// best for that very protocol; of Keys kernels, the best for random offsets, and for the others,
// and for the longest random horizon, the kernel that is best for the longest half-pixel horizon,
// since one half-pixel node must serve all of them. With `like` the filters are those that it
// found, and that of the longest half-pixel horizon is measured on the crops at hand: how much
// better one is than another depends on the content. Source of the loss: Mob-FGSR supplement,
// section 5; protocols, baselines and the power mean are ours.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "train/fit/objective/objective.h"
#include "train/fit/rivals/rivals.h"

namespace warplut {

// The power p by which weights are finally judged.
inline constexpr double kProtocolPower = 64;

// The longest half-pixel horizon over the longest horizon. All half-pixel warps use one node, and
// its best weights for a long horizon stand close to the limit beyond which an image rings; where
// the limit is depends on the content, so the training keeps some distance.
inline constexpr double kHalfReserve = 1.6;

// The half-pixel protocols of these horizons, the longest of which is kHalfReserve times longer;
// then the random ones; then, where asked for, pans of the multiples of kNodes warps that are
// nearest to the horizons, each once: 32 and 64 for 6, 12, 24 and 64.
std::vector<Protocol> MakeProtocols(std::span<const int> horizons, bool with_pan);

// h: as much as all random offsets, though a single node serves all half-pixel warps.
inline constexpr double kHalfShare = 0.5;

// Random offsets per pixel and axis. The weights of 24 and 36 taps lose least where it is between
// nodes that they are looked up, so these are trained at offsets there too.
constexpr int RandomSteps(Footprint footprint) {
  return footprint == Footprint::k16 ? kNodes : 4 * kNodes;
}

struct WarpObjectiveOptions {
  double power = kProtocolPower;  // p
  double pan_share = 0;           // q, in [0, 1]
  int pans_per_crop = 0;          // of each length; 0: no pan, then pan_share is 0
  RivalFamily rivals = {};        // the baselines
};

class WarpObjective final : public Objective {
 public:
  // Each crop is rolled out along the half-pixel trajectory, along pans, and for each random
  // protocol along so many trajectories of its own that every one warps about equally often.
  // Horizons even, ascending. Baselines as above; with `like`, a WarpObjective of the same horizons
  // that has a pan if this has, ScaleBaselines(*like).
  WarpObjective(std::vector<BorderedPlane> crops, const std::vector<int>& horizons,
                std::uint64_t seed, const WarpObjectiveOptions& options = {},
                const Objective* like = nullptr);
};

}  // namespace warplut
