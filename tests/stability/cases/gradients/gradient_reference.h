// Rollouts in complex numbers: the derivatives that the adjoints of train/ are compared with.
#pragma once

#include <functional>
#include <vector>

#include "tests/stability/cases/gradients/gradient_differences.h"
#include "train/fit/objective/objective.h"

namespace warplut {

// Weights with a direction to derive them in.
using ComplexWeights = CanonicalWeights<Complex>;
ComplexWeights Seed(const CanonicalWeights<double>& weights,
                    const CanonicalWeights<double>& direction);

// Each element 1 or -1: the root mean square of g . v over such v is the size of g.
CanonicalWeights<double> RandomSigns(std::uint64_t seed);

double Dot(const CanonicalWeights<double>& a, const CanonicalWeights<double>& b);

// 1 - SSIM against the InnerView of `target` at every horizon, in double with direct sums. New
// samples enter by SampleGrid, which is linear and computes in float.
std::vector<Complex> ReferenceLosses(const Rollout& rollout, const BorderedPlane& target,
                                     const ComplexWeights& weights);

// The derivative of L(weights) in the direction. L depends on the mean losses of the protocols,
// whose derivatives are exact, by a power mean, derived by fourth-order differences at the losses
// that the objective computes.
double ReferenceDerivative(const Objective& objective, const CanonicalWeights<double>& weights,
                           const CanonicalWeights<double>& direction);

}  // namespace warplut
