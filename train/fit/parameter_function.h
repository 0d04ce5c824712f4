// A function of parameters that optimizers descend.
#pragma once

namespace warplut {

class ParameterFunction {
 public:
  virtual ~ParameterFunction() = default;

  // The value, and the gradient where `gradient` is not null; as many values each.
  virtual double Evaluate(const double* parameters, double* gradient) = 0;
};

}  // namespace warplut
