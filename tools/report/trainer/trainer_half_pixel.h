// The best symmetric half-pixel kernel, by exhaustive search: what any trainer can reach at most.
#pragma once

#include <functional>

#include "train/fit/objective/canonical_nodes.h"

namespace warplut {

// A 4 x 4 kernel with the 8 symmetries of the square whose weights sum to 1: 4 corners, 8 edges,
// and 4 inner weights that are what is left for them. Its first moment is right for any of them.
struct HalfPixelKernel {
  double corner = 0, edge = 0;
  double inner() const { return (1 - 4 * corner - 8 * edge) / 4; }
};

// Catmull-Rom at all nodes but (1/2, 1/2), which has the kernel.
CanonicalWeights<double> WithHalfPixelKernel(const HalfPixelKernel& kernel);

struct HalfPixelOptimum {
  HalfPixelKernel kernel;
  double loss = 0;
  int evaluations = 0;
};

// The least loss over a grid of `grid` x `grid` kernels (grid odd, at least 5) on corner in [-0.06,
// 0.06] and edge in [-0.16, 0.02], the bounds of what keeps an image for more than a few warps, and
// then over grids of 5 x 5 around the best one, each of half the spacing of the one before, until
// it is below kHalfPixelStep. It finds the least of all if the loss has no second valley narrower
// than the first spacing.
HalfPixelOptimum FindHalfPixelOptimum(const std::function<double(const HalfPixelKernel&)>& loss,
                                      int grid);

inline constexpr double kHalfPixelStep = 1e-5;

}  // namespace warplut
