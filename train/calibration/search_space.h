// The parameters that a calibration moves, as points of the unit cube.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "runtime/parameters.h"

namespace warplut {

// One coordinate for each fitted parameter: 0 at its min, 1 at its max, linear in the parameter or,
// where kParameters says so, in its logarithm.
using Point = std::vector<double>;

class SearchSpace {
 public:
  // `fitted`: indices of kParameters, each once. All other parameters are those of `base`.
  SearchSpace(std::vector<int> fitted, const Parameters& base);

  int size() const { return static_cast<int>(fitted_.size()); }
  const ParameterInfo& info(int i) const { return kParameters[fitted_[i]]; }

  // Values outside their range are limited to it, in both directions.
  Point ToPoint(const Parameters& parameters) const;
  Parameters ToParameters(std::span<const double> point) const;
  double Coordinate(int i, double value) const;
  double Value(int i, double coordinate) const;

  // d value / d coordinate at a coordinate.
  double Slope(int i, double coordinate) const;

 private:
  std::vector<int> fitted_;
  Parameters base_;
};

// The largest difference of two points in a coordinate.
double Distance(const Point& a, const Point& b);

}  // namespace warplut
