// The step of quantised motion vectors, found in the vectors themselves.
#pragma once

#include "runtime/image_view.h"

namespace warplut {

// Motion in steps of at least so many pixels counts as quantised: half a step is then as large as
// the offsets that a table of 32 nodes tells apart.
inline constexpr double kQuantisedStep = 1.0 / 16;

// The distance in pixels that at most one in twenty of the gaps between neighbouring distinct
// values of a component falls below, of the component where it is less. Quantised motion gives its
// step, measured or computed motion of a camera about its range over the number of pixels. 0 where
// a component has fewer than kFewestValues distinct values, which tell nothing: a pan, objects that
// move as a whole. Values nearer to each other than 2^-12 pixels are one; those that are not finite
// do not count.
double MotionStep(const MotionView& motion);

inline constexpr int kFewestValues = 8;

}  // namespace warplut
