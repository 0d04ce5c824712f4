// MLP and head at all nodes at once, with the gradient: the fast form of HeadWeights.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "luts/fit/head.h"
#include "train/fit/objective/canonical_nodes.h"

namespace warplut {

// One object serves one thread.
class HeadBatch {
 public:
  // Of 16 taps without prefilter; or of another footprint, with its wide kernel of parameter b.
  explicit HeadBatch(Footprint footprint = Footprint::k16, double kaiser_b = 0);

  Footprint footprint() const { return footprint_; }

  // Of 16 taps: with a prefilter of this side from now on.
  void SetSide(double side);

  // The weights of every canonical node for these parameters (MlpParameters(footprint()) values).
  // Equal to HeadWeights to rounding: 1e-12 for weights of order 1.
  const CanonicalWeights<double>& Forward(const double* parameters);

  // After Forward with the same parameters: writes d(loss)/d(parameters), given d(loss)/d(weights).
  void Backward(const double* parameters, const CanonicalWeights<double>& weight_gradient,
                double* parameter_gradient);

  // With a prefilter: d(loss)/d(side) through the weights, given d(loss)/d(weights).
  double SideGradient(const CanonicalWeights<double>& weight_gradient) const;

 private:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor>;

  Footprint footprint_;
  std::array<int, kWeights> place_{};          // of a weight among the footprint's taps
  Matrix input_;                               // 2 x points; the points are the 33 x 33 nodes
  std::array<Matrix, kMlpLayers> activation_;  // output of each layer, one column per point
  std::array<Matrix, kMlpLayers> delta_;
  double side_ = 0;                    // 0: no prefilter
  std::vector<HeadAt<double>> heads_;  // at the canonical nodes
  CanonicalWeights<double> weights_{};
};

}  // namespace warplut
