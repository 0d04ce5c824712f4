// Objective `warp`: how much of an image repeated warps lose, compared with the best that a Keys
// kernel does.
//
// The form of train/objective.h with the kinds half, random and pan, whose shares are (1 - q) h,
// (1 - q) (1 - h) and q. Exponents p are large, so that no horizon is bought with another.
// Baselines are, on the same crops and trajectories: for random offsets the best Keys kernel for
// that very protocol; for the others, and for the longest random horizon, the Keys kernel that is
// best for the longest half-pixel horizon, since one half-pixel node must serve all of them. With
// `like` the kernels are those that it found, and that of the half-pixel horizons is measured on
// the crops at hand: how much better one Keys kernel is than another depends on the content.
// Source of the loss: Mob-FGSR supplement, section 5; protocols, baselines and the power mean are
// ours.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "train/objective.h"

namespace warplut {

// The power p by which weights are finally judged.
inline constexpr double kProtocolPower = 64;

// The longest half-pixel horizon over the longest horizon. All half-pixel warps use one node, and
// its best weights for a long horizon stand close to the limit beyond which an image rings; where
// the limit is depends on the content, so the training keeps some distance.
inline constexpr double kHalfReserve = 1.6;

// The half-pixel protocols of these horizons, the longest of which is kHalfReserve times longer;
// then the random ones; then, where asked for, one pan, of the multiple of kNodes warps that is
// nearest to the longest horizon.
std::vector<Protocol> MakeProtocols(std::span<const int> horizons, bool with_pan);

// h: as much as all random offsets, though a single node serves all half-pixel warps.
inline constexpr double kHalfShare = 0.5;

struct WarpObjectiveOptions {
  double power = kProtocolPower;  // p
  double pan_share = 0;           // q, in [0, 1]
  int pans_per_crop = 0;          // 0: no pan among the protocols, then pan_share is 0
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
