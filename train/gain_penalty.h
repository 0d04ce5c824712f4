// The bound on gain: a penalty on |H| above the bound, for every node and frequency.
//
//   P(w) = sum over canonical nodes and frequencies of max(0, |H(w)|^2 - bound^2)^2,
//   H(w) = sum over k of w_k exp(-i (wx tx_k + wy ty_k)),  frequencies on a grid of pi / 16 over
//   the half plane.
//
// A gain of g repeated N times grows g^N: the bound follows from the horizon.
#pragma once

#include <Eigen/Core>

#include "train/canonical_nodes.h"

namespace warplut {

class GainPenalty {
 public:
  explicit GainPenalty(double bound);

  // P(weights), and adds factor * dP/d(weights) to `gradient`.
  double AddGradient(const CanonicalWeights<double>& weights, double factor,
                     CanonicalWeights<double>& gradient) const;

 private:
  double bound_;
  Eigen::Matrix<double, Eigen::Dynamic, kWeights> cosine_, sine_;  // one row per frequency
};

}  // namespace warplut
