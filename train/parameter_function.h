// A function of the MLP's parameters that optimizers descend.
#pragma once

namespace warplut {

class ParameterFunction {
 public:
  virtual ~ParameterFunction() = default;

  // The value, and the gradient where `gradient` is not null; kMlpParameters values each.
  virtual double Evaluate(const double* parameters, double* gradient) = 0;
};

}  // namespace warplut
