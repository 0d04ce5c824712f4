// Objective `sr`: the loss of a table that warps the history of super resolution.
//
// A crop is the reference, standing for a scene that shows the crop's detail and no more
// (train/fit/rollout/band_limited.h), and moves as a whole along a trajectory. Frame 0 is its
// samples at jitter phase f of the upscale factor's cycle, interpolated: x_0 = I S_0. Each step t
// warps the history by the trajectory's displacement and refreshes it with the scene's samples at
// phase f + t (train/fit/rollout/sample_grid.h):
//
//   h = W(d_t) P x_(t-1)    x_t = h + share (I (S_t - B h))
//
// P is the prefilter, where there is one. At a horizon the displacements add up to zero, so that
// x_t should be the crop: an exact reference. The shortest horizons judge the settling of the loop,
// the longest the settled loop. The jitter is that of datasets/jitter.h, f is drawn for each
// rollout. A sample beyond the crop sees its repeated edge, which the judged part does not reach.
//
// Aliasing: a renderer's sample is a point of the scene; a pixel of the crop C is a mean over a
// filter. The excess of a sample over the crop's value at its position p is modelled as noise of
// the size of the detail there, drawn for each sample of each frame, zero in the mean:
//
//   S = C(p) + (C(p + e) - C(p - e)) / 2      e ~ N(0, aliasing^2) in each axis, output pixels
//
// (bilinear in the second term). Without it the history has nothing to average, and filters that
// are too sharp for rendered frames win.
//
// The form of train/fit/objective/objective.h with the kinds random and pan (of kNodes steps, after
// which every pan is back at the start), whose shares are 1 - q and q, and p = 1; the baseline of
// each protocol is the rival (train/fit/rivals/rivals.h) that is best for it, on the same crops,
// trajectories and samples.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "train/fit/objective/objective.h"
#include "train/fit/rivals/rivals.h"

namespace warplut {

struct SrObjectiveOptions {
  double scale = 2;    // output / render, [1, 4]
  double blend_a = 0;  // a and b of runtime/parameters.h
  double blend_b = 0;
  double pan_share = 0;     // q, in [0, 1]
  int pans_per_crop = 0;    // 0: no pan among the protocols, then pan_share is 0
  double aliasing = 0;      // output pixels, >= 0
  RivalFamily rivals = {};  // the baselines
};

class SrObjective final : public Objective {
 public:
  // Each crop is rolled out once along a random trajectory, judged at every horizon, and along
  // pans. Horizons ascending. Baselines as above; with `like`, an SrObjective of the same horizons
  // and options that has a pan if this has, ScaleBaselines(*like).
  SrObjective(std::vector<BorderedPlane> crops, const std::vector<int>& horizons,
              std::uint64_t seed, const SrObjectiveOptions& options,
              const Objective* like = nullptr);

 private:
  void AddSamples(const BorderedPlane& crop, std::size_t first_phase,
                  const std::vector<Displacement>& trajectory, double aliasing, std::uint64_t seed,
                  Rollout& rollout);

  std::vector<SampleGrid> grids_;     // one for each phase
  std::deque<BorderedPlane> starts_;  // x_0 of each rollout
};

}  // namespace warplut
