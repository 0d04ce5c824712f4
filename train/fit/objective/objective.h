// The loss of a training: the losses of many rollouts, relative to those of simple kernels.
//
// A protocol i is a kind of offsets (half, random, pan) and a number of warps N; l_i(w) is the mean
// of 1 - SSIM after N steps with the resampler w, over crops and trajectories. With a baseline b_i
// for each protocol and a share q_k for each kind k of them, the shares adding up to 1,
//
//   L(w) = sum over k of q_k M(k)
//   M(k) = ( mean over the protocols of kind k of (l_i / b_i)^p )^(1/p)
//
// With a larger p the protocol counts more in which w does worst against its baseline. L < 1 means
// better than the baselines. Baselines are at least kLeastBaseline: content that no filter
// disturbs (constant images) has L = 0 and no gradient.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "train/fit/resampler.h"
#include "train/fit/rollout/rollout.h"

namespace warplut {

// What is lost by rounding alone has no say in an objective.
inline constexpr double kLeastBaseline = kSsimAccuracy;

// A rollout, the crop that it should end as, and the first of the consecutive protocols that judge
// it, one for each horizon.
struct JudgedRollout {
  Rollout rollout;
  std::size_t crop = 0;
  std::size_t first = 0;
};

class Objective {
 public:
  Objective(const Objective&) = delete;
  Objective& operator=(const Objective&) = delete;
  virtual ~Objective() = default;

  // L(resampler); with `gradient`, also writes dL/d(resampler). Rollouts run in parallel, shared
  // among the ranks, and are added in a fixed order: the same bits for any number of threads and
  // ranks. This, Losses and the construction are collective calls of Ranks::World().
  double Evaluate(const Resampler& resampler, Resampler* gradient = nullptr) const;

  // l_i(resampler), in the order of protocols().
  std::vector<double> Losses(const Resampler& resampler) const;

  // L of the losses of some resampler.
  double Value(std::span<const double> losses) const;

  const std::vector<Protocol>& protocols() const { return protocols_; }
  const std::vector<double>& baselines() const { return baselines_; }
  const std::vector<BorderedPlane>& crops() const { return crops_; }
  const std::vector<JudgedRollout>& rollouts() const { return rollouts_; }

 protected:
  // Consecutive protocols, and the share q_k. A kind may be empty; its share is then 0.
  struct Kind {
    std::size_t first = 0;
    std::size_t count = 0;
    double share = 0;
  };

  // All crops are of one size. A construction goes on with rollouts, then baselines.
  Objective(std::vector<BorderedPlane> crops, std::vector<Protocol> protocols,
            std::vector<Kind> kinds, double power);

  // A trajectory for `count` consecutive protocols from `first` on; `steps` as MakeTrajectory has
  // it.
  std::vector<Displacement> DrawTrajectory(std::size_t first, std::size_t count, std::uint64_t seed,
                                           int steps = kNodes) const;

  // A rollout of pure warps from a crop to itself, along a trajectory drawn for these protocols,
  // which judge it. The reference serves to add samples; it is valid until the next call.
  Rollout& AddRollout(std::size_t crop, std::size_t first, std::size_t count,
                      std::span<const Displacement> trajectory);

  // `yardstick` stands for the baselines where they are scaled.
  void SetBaselines(std::vector<double> baselines, const Resampler& yardstick = {});
  // The baselines of `like`, which begins with the same protocols, scaled protocol by protocol by
  // what its yardstick loses here over what it loses there: none is searched.
  void ScaleBaselines(const Objective& like);

 private:
  // The rank that runs each rollout.
  std::vector<int> Owners() const;

  // l_i of the losses of every rollout.
  std::vector<double> MeanLosses(const std::vector<std::vector<double>>& losses) const;

  // L; factors[i] = dL/dl_i.
  double Combine(std::span<const double> losses, std::span<double> factors) const;

  std::vector<BorderedPlane> crops_;
  std::vector<Ssim> ssim_;  // of the crops
  std::vector<Protocol> protocols_;
  std::vector<Kind> kinds_;
  double power_;
  std::vector<JudgedRollout> rollouts_;
  std::vector<double> rollouts_per_protocol_;
  std::vector<double> baselines_;
  Resampler yardstick_;
};

}  // namespace warplut
