// The evaluations of a function, kept so that a descent that was interrupted can be taken up inside
// it.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "train/fit/parameter_function.h"

namespace warplut {

struct Evaluation {
  double value = 0;
  std::vector<double> gradient;  // empty where none was asked for
};

// A function that answers from `log` as long as it lasts, then from `function`, whose answers it
// appends. An optimizer that starts from the same point asks for the same evaluations in the same
// order: with the log of an interrupted descent it comes to the same bits as without the
// interruption, and the evaluations of the log take no time.
class LoggedFunction final : public ParameterFunction {
 public:
  // `function` and `log` outlive this. `on_new` is called after each evaluation that was appended.
  LoggedFunction(ParameterFunction& function, std::size_t parameters, std::vector<Evaluation>* log,
                 std::function<void()> on_new)
      : function_(function), parameters_(parameters), log_(*log), on_new_(std::move(on_new)) {}

  double Evaluate(const double* parameters, double* gradient) override;

  // So many evaluations were asked for, from the log or anew.
  std::size_t evaluations() const { return asked_; }

 private:
  ParameterFunction& function_;
  const std::size_t parameters_;
  std::vector<Evaluation>& log_;
  const std::function<void()> on_new_;
  std::size_t asked_ = 0;
};

}  // namespace warplut
