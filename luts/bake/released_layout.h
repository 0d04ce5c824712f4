// The layout of the table that the authors of Mob-FGSR released: a single-channel image of 128 x
// 128 pixels.
//
// 4 x 4 tiles of 32 x 32 pixels: the tile column is the x tap, the tile row the y tap; inside a
// tile x is the dx index and y the dy index of the node at offset (dx index, dy index) / 31. Nodes
// 0 and 31 are both ends of the cell; one half is not a node.
#pragma once

#include <string>

#include "datasets/image.h"
#include "luts/quantize/real_table.h"

namespace warplut {

inline constexpr int kReleasedIntervals = kNodes - 1;
inline constexpr int kReleasedSide = kTaps * kNodes;

// How far from 1 a row sum, from 0 a weight that the contract wants to be 0, and from each other
// the two ends of a cell may be: 16 weights of at most 1 rounded to half float are off by less than
// this together.
inline constexpr double kReleasedTolerance = 2e-3;

// Whether the layout can hold the fit: 16 taps without a prefilter.
inline bool HasReleasedLayout(const Fit& fit) {
  return fit.footprint == Footprint::k16 && !HasPrefilter(fit.prefilter);
}

// The fit's weights in this layout. They are multiples of 2^-22 (format f32 of the contract), so
// that each row sums to exactly 1 in float, in any order. An Error unless HasReleasedLayout, and
// if the fit cannot be quantised.
Image ToReleasedLayout(const Fit& fit);

// Reads the layout: a table with kReleasedIntervals intervals. Within kReleasedTolerance, weights
// that the contract wants to be 0 are set to 0 and sums are closed (CloseSum). Beyond it, and for
// another size or number of channels, an Error names `name`, what was found and what was expected.
// The pixels are finite.
RealTable FromReleasedLayout(const Image& image, const std::string& name);

}  // namespace warplut
