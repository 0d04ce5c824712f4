// A rollout: one image warped repeatedly along a trajectory, judged by SSIM at each horizon, with
// the adjoint.
#pragma once

#include <span>
#include <vector>

#include "train/canonical_nodes.h"
#include "train/ssim.h"
#include "train/stencil.h"
#include "train/trajectory.h"

namespace warplut {

// One warp of a trajectory, as a node and a cell.
struct RolloutStep {
  CanonicalNode node;
  int cell_x = 0;
  int cell_y = 0;
};

// Displacements on the node grid (MakeTrajectory with steps = kNodes) as steps: the position p - v
// lies in cell floor(-v), at the offset that is left.
std::vector<RolloutStep> ToSteps(std::span<const Displacement> trajectory);

// The stencil of a step.
Stencil ToStencil(const RolloutStep& step, const CanonicalWeights<double>& weights);

// SSIM looks at the image without this margin, where the clamped border disturbs the content.
inline constexpr int kRolloutMargin = 12;

// The image without its margin.
PlaneView InnerView(const BorderedPlane& plane);

// Buffers for rollouts of one image size; one object serves one thread at a time.
class RolloutWorkspace {
 public:
  RolloutWorkspace(int width, int height, int max_warps);

  // Warps `image` (border filled) along `steps`. losses[h] receives 1 - SSIM after horizons[h]
  // warps, against what `ssim` was made with (InnerView of the image).
  void Forward(const BorderedPlane& image, const Ssim& ssim, std::span<const RolloutStep> steps,
               std::span<const int> horizons, const CanonicalWeights<double>& weights,
               std::span<double> losses);

  // After Forward with the same arguments: adds to `gradient` the derivative of the sum of
  // factors[h] * losses[h] with respect to the weights.
  void Backward(const BorderedPlane& image, const Ssim& ssim, std::span<const RolloutStep> steps,
                std::span<const int> horizons, std::span<const double> factors,
                const CanonicalWeights<double>& weights, CanonicalWeights<double>& gradient);

 private:
  std::vector<BorderedPlane> planes_;  // planes_[i] is the image after i + 1 warps
  BorderedPlane gradient_;
  BorderedPlane next_gradient_;
};

}  // namespace warplut
