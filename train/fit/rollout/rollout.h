// A rollout: one image warped repeatedly along a trajectory, with or without new samples after each
// warp, judged by SSIM at each horizon, with the adjoint.
//
// With a prefilter each warp reads coefficients: image in [0, 1] -> prefilter, border mirrored ->
// stencil -> clamp to [0, 1]. Without, it reads the image, whose edge pixels repeat.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "train/fit/objective/canonical_nodes.h"
#include "train/fit/resampler.h"
#include "train/fit/rollout/plane_prefilter.h"
#include "train/fit/rollout/sample_grid.h"
#include "train/fit/rollout/stencil.h"
#include "train/fit/rollout/trajectory.h"
#include "train/metrics/ssim.h"

namespace warplut {

// One warp of a trajectory, as a cell and an offset in it: a node, and how far beyond it.
struct RolloutStep {
  CanonicalNode node;
  int cell_x = 0;
  int cell_y = 0;
  // In intervals between nodes, [0, 1): the weights are the bilinear mean of those of the node and
  // of the nodes to its right, below it and both, as the runtime looks them up.
  double beyond_x = 0;
  double beyond_y = 0;
  std::array<CanonicalNode, 3> others = {};
};

// The nodes of a step and their shares of its weights, (1 - f_x) (1 - f_y) and so on; some may be
// 0.
struct NodeShare {
  CanonicalNode node;
  double share = 0;
};
std::array<NodeShare, 4> SharesOf(const RolloutStep& step);

// Displacements as steps: the position p - v lies in cell floor(-v), at the offset that is left. On
// the node grid (MakeTrajectory with steps = kNodes) every offset is a node.
std::vector<RolloutStep> ToSteps(std::span<const Displacement> trajectory);

// The stencil of a step.
Stencil ToStencil(const RolloutStep& step, const Resampler& resampler);

// SSIM looks at the image without this margin, where the clamped border disturbs the content.
inline constexpr int kRolloutMargin = 12;

// The image without its margin.
PlaneView InnerView(const BorderedPlane& plane);

// The new samples of one step; `grid` is shared by the steps of one jitter phase.
struct FrameSamples {
  const SampleGrid* grid = nullptr;
  std::vector<float> values;
};

struct Rollout {
  const BorderedPlane* start = nullptr;  // border filled
  const Ssim* ssim = nullptr;            // against the InnerView of what is expected
  std::vector<RolloutStep> steps;
  std::vector<int> horizons;         // numbers of steps, ascending, at most steps.size()
  std::vector<FrameSamples> frames;  // one for each step, or none
};

// Buffers for rollouts of one image size; one object serves one thread at a time.
class RolloutWorkspace {
 public:
  RolloutWorkspace(int width, int height)
      : gradient_(width, height), next_gradient_(width, height), prefilter_(width, height) {}

  // 1 - SSIM after horizons[h] steps, where Backward does not follow: as Forward has it.
  void Losses(const Rollout& rollout, const Resampler& resampler, std::span<double> losses);

  // Each step warps the image and refreshes it with the step's samples, if it has any. losses[h]
  // receives 1 - SSIM after horizons[h] steps.
  void Forward(const Rollout& rollout, const Resampler& resampler, std::span<double> losses);

  // After Forward with the same arguments: adds to `gradient` the derivative of the sum of
  // factors[h] * losses[h] with respect to the weights and the values of the prefilter.
  void Backward(const Rollout& rollout, std::span<const double> factors, const Resampler& resampler,
                Resampler& gradient);

 private:
  void Reserve(std::size_t steps, bool with_samples, bool with_prefilter);
  // Keeps the images of the last `kept` steps, at step modulo kept.
  void Run(const Rollout& rollout, const Resampler& resampler, std::size_t kept,
           std::span<double> losses);

  std::vector<BorderedPlane> planes_;        // planes_[i] is the image after i + 1 steps
  std::vector<BorderedPlane> warped_;        // with samples: the same before they enter
  std::vector<BorderedPlane> coefficients_;  // with a prefilter: what step i reads
  BorderedPlane gradient_;
  BorderedPlane next_gradient_;
  PlanePrefilter prefilter_;
};

}  // namespace warplut
