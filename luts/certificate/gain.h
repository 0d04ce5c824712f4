// Gain of a node: the largest factor by which one warp by its offset amplifies a frequency.
//
// A warp by a fixed offset is a convolution with the node's weights w_k at the taps t_k. Its
// transfer function is
//   H(f) = sum over k of w_k exp(-i f . t_k),   f = (fx, fy) in radians per pixel,
// and the gain is the largest |H| over all frequencies: the norm of the warp in the mean square. It
// is at least 1 where the weights sum to 1 (f = 0).
//
// With a prefilter a warp is H(f) P(fx) P(fy), P its response (luts/prefilter.h), and the gain is
// the largest of that product: from samples to samples.
#pragma once

#include <vector>

#include "luts/contract.h"

namespace warplut {

struct Gain {
  double gain = 0;
  double fx = 0;  // in [0, pi]: H(-f) is the conjugate of H(f)
  double fy = 0;  // in (-pi, pi]
};

// |H(f)|, with a prefilter |H(f) P(fx) P(fy)|.
double GainAt(const Weights<double>& w, double fx, double fy, const Prefilter& prefilter = {});

// The largest |H|: a grid of 33 x 64 frequencies, then a compass search from every local maximum of
// the grid that could lead to the largest (those whose |H|^2 is within kGridLoss of the best).
// Accuracy: 1e-9 relative.
Gain MaxGain(const Weights<double>& w, const Prefilter& prefilter = {});

// A maximum of |H|^2 loses at most this fraction at the nearest grid frequency: |H|^2 is a
// trigonometric polynomial of degree 3 in each axis of 16 taps, so that by Bernstein its second
// derivative along a step (s, s) is at most (6 s)^2 times its maximum, and the nearest grid
// frequency is at most s = pi / 64 away in each axis: (6 pi / 64)^2 / 2 = 0.0434.
inline constexpr double kGridLoss = 0.0434;
// The same of 24 and 36 taps, a polynomial of degree 5: (10 pi / 64)^2 / 2.
inline constexpr double kWideGridLoss = 0.1205;
// The same with a prefilter, whose product with H is no polynomial of low degree: every local
// maximum of the grid that reaches 1 - this of the best is climbed. 1 / A^2 alone loses at most 2
// s / (1 - 4 s) (pi / 64)^2 per axis, 1.4 % at kLargestSide.
inline constexpr double kPrefilteredGridLoss = 0.3;

struct GainMap {
  std::vector<Gain> nodes;  // kRows
  int worst = 0;            // row of the largest gain, the first one among equals
};

// MaxGain of every row of a checked table. Bilinear lookup between nodes has at most the gain of
// the worst of the four: its weights are a convex combination of theirs, hence so is H, and |H| is
// convex.
GainMap MapGains(const TableView& table);

}  // namespace warplut
