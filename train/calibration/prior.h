// The prior of the parameters: the base suits content at large.
#pragma once

#include <cmath>

namespace warplut {

// How far the best points of single clips lie from the base, of the unit cube's side, and the
// number of independent observations that a clip is worth: few, since its frames and tiles show the
// same content again.
inline constexpr double kPriorWidth = 0.1;
inline constexpr double kClipObservations = 10;

// What a loss is multiplied by at that distance from the base (square, of the unit cube's side),
// for data of `clips` clips: exp(square / (w^2 n)), w = kPriorWidth, n = kClipObservations clips.
// The least product is the maximum a posteriori of n normal residuals of unknown variance, -2 log
// likelihood = n log loss, with a normal prior of width w. It fades as clips are added; a loss that
// falls towards 0 outweighs it.
inline double PriorFactor(double square_distance, int clips) {
  return std::exp(square_distance / (kPriorWidth * kPriorWidth * kClipObservations * clips));
}

}  // namespace warplut
