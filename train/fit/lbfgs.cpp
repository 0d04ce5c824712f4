#include <ceres/ceres.h>

#include <cmath>

#include "train/fit/minimize.h"

namespace warplut {
namespace {

class CostFunction final : public ceres::FirstOrderFunction {
 public:
  CostFunction(ParameterFunction& objective, std::size_t parameters)
      : objective_(objective), parameters_(static_cast<int>(parameters)) {}

  bool Evaluate(const double* parameters, double* cost, double* gradient) const override {
    *cost = objective_.Evaluate(parameters, gradient);
    return std::isfinite(*cost);
  }
  int NumParameters() const override { return parameters_; }

 private:
  ParameterFunction& objective_;
  int parameters_;
};

class IterationCallback final : public ceres::IterationCallback {
 public:
  IterationCallback(const MinimizeCallback& callback, const std::vector<double>& parameters)
      : callback_(callback), parameters_(parameters) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (summary.iteration == 0 || callback_(parameters_.data(), summary.cost)) {
      return ceres::SOLVER_CONTINUE;
    }
    return ceres::SOLVER_TERMINATE_SUCCESSFULLY;
  }

 private:
  const MinimizeCallback& callback_;
  const std::vector<double>& parameters_;
};

}  // namespace

void MinimizeLbfgs(ParameterFunction& objective, int iterations, const MinimizeCallback& callback,
                   std::vector<double>& parameters) {
  ceres::GradientProblem problem(new CostFunction(objective, parameters.size()));
  IterationCallback iteration_callback(callback, parameters);
  ceres::GradientProblemSolver::Options options;
  options.line_search_direction_type = ceres::LBFGS;
  options.line_search_type = ceres::WOLFE;
  options.max_lbfgs_rank = 40;
  options.max_num_iterations = iterations;
  options.function_tolerance = 0;
  options.gradient_tolerance = 0;
  options.parameter_tolerance = 0;
  options.logging_type = ceres::SILENT;
  options.update_state_every_iteration = true;
  options.callbacks.push_back(&iteration_callback);
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(options, problem, parameters.data(), &summary);
}

}  // namespace warplut
