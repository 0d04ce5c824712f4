// Objective `warp`: how much of an image repeated warps lose, compared with the best that a Keys kernel does.
//
// A protocol i is a kind of offsets (half, random, pan) and a number of warps N; l_i(w) is the mean of 1 - SSIM after N
// warps with the weights w, over crops and trajectories. With a baseline b_i for each protocol,
//
//   L(w) = q M(pan) + (1 - q) ( h M(half) + (1 - h) M(random) )
//   M    = ( mean over the protocols of one kind of (l_i / b_i)^p )^(1/p)
//
// The larger p, the more the protocol counts in which w does worst against the baseline, so that no horizon is bought
// with another; L < 1 means better than the baselines. They are, on the same crops and trajectories: for random offsets
// the best Keys kernel for that very protocol; for the others, and for the longest random horizon, the Keys kernel
// that is best for the longest half-pixel horizon, since one half-pixel node must serve all of them.
// Source of the loss: Mob-FGSR supplement, section 5; protocols, baselines and the power mean are ours.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "train/rollout.h"

namespace warplut {

// The power p by which weights are finally judged.
inline constexpr double kProtocolPower = 64;

// The longest half-pixel horizon over the longest horizon. All half-pixel warps use one node, and its best weights for
// a long horizon stand close to the limit beyond which an image rings; where the limit is depends on the content, so
// the training keeps some distance.
inline constexpr double kHalfReserve = 1.6;

// The half-pixel protocols of these horizons, the longest of which is kHalfReserve times longer; then the random ones;
// then, where asked for, one pan, of the multiple of kNodes warps that is nearest to the longest horizon.
std::vector<Protocol> MakeProtocols(std::span<const int> horizons, bool with_pan);

// h: most of the weight, since a single node serves all half-pixel warps and the MLP is slow to set it apart.
inline constexpr double kHalfShare = 0.75;

struct WarpObjectiveOptions {
  double power = kProtocolPower;  // p
  double pan_share = 0;           // q, in [0, 1]
  int pans_per_crop = 0;          // 0: no pan among the protocols, then pan_share is 0
};

class WarpObjective {
 public:
  // Each crop is rolled out along the half-pixel trajectory, along pans, and for each random protocol along
  // so many trajectories of its own that every one warps about equally often. Horizons even, ascending. Baselines as
  // above.
  WarpObjective(std::vector<BorderedPlane> crops, const std::vector<int>& horizons,
                std::uint64_t seed, const WarpObjectiveOptions& options = {});

  // With the baselines of `like`, which has the same horizons and a pan if this has, scaled protocol by protocol by
  // what Catmull-Rom loses on these crops over what it loses on those: no Keys kernels are searched.
  WarpObjective(std::vector<BorderedPlane> crops, const WarpObjective& like, std::uint64_t seed,
                const WarpObjectiveOptions& options);

  // L(weights); with `gradient`, also writes dL/d(weights). Rollouts run in parallel and are added
  // in a fixed order: the same bits for any number of threads.
  double Evaluate(const CanonicalWeights<double>& weights,
                  CanonicalWeights<double>* gradient = nullptr) const;

  // l_i(weights), in the order of protocols().
  std::vector<double> Losses(const CanonicalWeights<double>& weights) const;

  const std::vector<Protocol>& protocols() const { return protocols_; }
  const std::vector<double>& baselines() const { return baselines_; }

 private:
  // A trajectory and the horizons at which it is judged: those of the protocols from `first` on.
  struct Trajectory {
    std::vector<RolloutStep> steps;
    std::vector<int> horizons;
    int first = 0;
  };
  struct Rollout {
    int crop = 0;
    Trajectory trajectory;
  };

  Trajectory MakeRolloutTrajectory(int first, int count, std::uint64_t seed) const;
  void AddRollouts(std::uint64_t seed);
  RolloutWorkspace MakeWorkspace() const;
  std::vector<double> FindBaselines() const;

  // L; factors[i] = dL/dl_i.
  double Combine(std::span<const double> losses, std::span<double> factors) const;

  std::vector<BorderedPlane> crops_;
  std::vector<Ssim> ssim_;  // of the crops
  std::size_t horizons_;    // of the half-pixel and of the random protocols, each
  WarpObjectiveOptions options_;
  std::vector<Protocol> protocols_;
  std::vector<Rollout> rollouts_;
  std::vector<double> rollouts_per_protocol_;
  std::vector<double> baselines_;
};

// The weights of the Keys kernel at the canonical nodes.
CanonicalWeights<double> KeysCanonicalWeights(double a);

// The Keys parameters that are looked at when a best one is wanted.
inline constexpr double kKeysFirst = -0.50;
inline constexpr double kKeysLast = -0.86;
inline constexpr double kKeysStep = 0.02;

// The parameter a of the Keys kernel with the least L: the baseline that a fit must beat.
double FitKeys(const WarpObjective& objective);

}  // namespace warplut
