// Levenberg-Marquardt for the one part of the training that is a least-squares problem: the MLP
// against the weights of a kernel.
#pragma once

#include <functional>
#include <vector>

#include "train/fit/objective/canonical_nodes.h"

namespace warplut {

// Told after every step what it cost, in products with the Jacobian and its transpose (one pair is
// about one evaluation with gradient), and the loss then; returns false to stop.
using KernelFitCallback = std::function<bool(int evaluations, double loss)>;

// Minimises KernelProblem's loss 1/2 |r|^2 from `parameters`, which receives the best point. Steps
// solve (J^T J + lambda I) s = -J^T r by conjugate gradients without the 2448 x 3744 matrix J: J v
// by central differences of the MLP, J^T u by its gradient. The damping lambda follows the ratio of
// gained to predicted loss (Nielsen 1999). Ends at `callback`, or when steps gain nothing more.
void FitKernelByLevenbergMarquardt(const CanonicalWeights<double>& kernel,
                                   const KernelFitCallback& callback,
                                   std::vector<double>& parameters);

}  // namespace warplut
