// The function that a calibration minimises.
#pragma once

#include <cstddef>
#include <span>

#include "runtime/parameters.h"

namespace warplut {

// Residuals r of the parameters: 1/2 sum of r^2 is the loss. The same arguments give the same bits.
class ResidualFunction {
 public:
  virtual ~ResidualFunction() = default;

  virtual std::size_t Size() const = 0;  // number of residuals, at least 1

  // What residual k comes from, a clip for example: residuals of one source are not independent of
  // each other.
  virtual int Source(std::size_t k) const { return static_cast<int>(k); }

  // Parameters are valid, gate_width is in [0, 1] (runtime/gates.h), residuals has Size() elements.
  // An Error if it cannot be evaluated at all.
  virtual void Evaluate(const Parameters& parameters, float gate_width,
                        std::span<double> residuals) = 0;
};

// 1/2 sum of r^2, added in order.
inline double LossOf(std::span<const double> residuals) {
  double sum = 0;
  for (const double r : residuals) sum += r * r;
  return sum / 2;
}

}  // namespace warplut
