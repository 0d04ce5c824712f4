#include "train/fit/evaluation_log.h"

#include <algorithm>

#include "datasets/error.h"

namespace warplut {

double LoggedFunction::Evaluate(const double* parameters, double* gradient) {
  if (asked_ < log_.size()) {
    const Evaluation& known = log_[asked_++];
    if (gradient == nullptr) return known.value;
    if (known.gradient.size() != parameters_) {
      throw Error("the evaluations of the checkpoint are not those of this training.");
    }
    std::copy(known.gradient.begin(), known.gradient.end(), gradient);
    return known.value;
  }
  ++asked_;
  Evaluation& added = log_.emplace_back();
  added.value = function_.Evaluate(parameters, gradient);
  if (gradient != nullptr) added.gradient.assign(gradient, gradient + parameters_);
  if (on_new_) on_new_();
  return added.value;
}

}  // namespace warplut
