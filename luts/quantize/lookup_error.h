// Errors of looked-up weights: the price of storing and interpolating a table.
#pragma once

#include <vector>

#include "luts/fit/fit.h"
#include "luts/table.h"

namespace warplut {

struct LookupError {
  TableFormat format = TableFormat::kI16;
  Lookup lookup = Lookup::kNearest;
  double worst = 0;       // largest sum over the taps of |weight - exact weight|
  double mean = 0;        // mean of that sum
  double brightness = 0;  // largest |sum of weights - 1|
};

// Offsets per axis at which errors are measured: i / kErrorOffsets, so that every node is one of
// them and so is the middle between two.
inline constexpr int kErrorOffsets = 256;

// The errors of every format and lookup, in that order, for the table of a valid fit: exact weights
// are the head's in double, looked-up ones those of Table::At in float. An Error if the fit cannot
// be quantised.
std::vector<LookupError> MeasureLookupErrors(const Fit& fit);

}  // namespace warplut
