// The bound on gain: a penalty on |H| above the bound, for every node and frequency.
//
//   P(w) = sum over canonical nodes and frequencies of max(0, R^2 |H(w)|^2 - bound^2)^2,
//   H(w) = sum over k of w_k exp(-i (wx tx_k + wy ty_k)),  frequencies on a grid of pi / 16 over
//   the half plane.
//
// R is the response of the prefilter along both axes (luts/prefilter.h), 1 without one.
// A gain of g repeated N times grows g^N: the bound follows from the horizon.
#pragma once

#include <Eigen/Core>

#include "train/fit/resampler.h"

namespace warplut {

class GainPenalty {
 public:
  explicit GainPenalty(double bound, Footprint footprint = Footprint::k16);

  // P(resampler), of the same footprint, and adds factor * dP/d(resampler) to `gradient`.
  double AddGradient(const Resampler& resampler, double factor, Resampler& gradient) const;

 private:
  double bound_;
  Footprint footprint_;
  Eigen::MatrixXd cosine_, sine_;  // one row per frequency, one column per tap
};

}  // namespace warplut
