#include "train/calibration/soft_fit.h"

#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>

namespace warplut {
namespace {

// Iterations at one width: the next width, and the polish after the last, take up what is left.
constexpr int kIterations = 4;
// An iteration that gains less of the loss ends the fit.
constexpr double kLeastGain = 1e-3;

// Residuals of one parameter block for each coordinate.
class RunResiduals final : public ceres::CostFunction {
 public:
  RunResiduals(RunLog& log, const SearchSpace& space, float gate_width, std::size_t residuals)
      : log_(log), space_(space), gate_width_(gate_width) {
    set_num_residuals(static_cast<int>(residuals));
    mutable_parameter_block_sizes()->assign(static_cast<std::size_t>(space.size()), 1);
  }

  // Once the log has stopped everything is 0, which ends the fit in silence; a failure would be
  // logged by Ceres.
  bool Evaluate(const double* const* coordinates, double* residuals,
                double** jacobians) const override {
    if (EvaluateRuns(coordinates, residuals, jacobians)) return true;
    std::fill_n(residuals, num_residuals(), 0.0);
    for (int i = 0; jacobians != nullptr && i < space_.size(); ++i) {
      if (jacobians[i] != nullptr) std::fill_n(jacobians[i], num_residuals(), 0.0);
    }
    return true;
  }

 private:
  bool EvaluateRuns(const double* const* coordinates, double* residuals, double** jacobians) const {
    Point point;
    for (int i = 0; i < space_.size(); ++i) {
      point.push_back(std::clamp(coordinates[i][0], 0.0, 1.0));
    }
    const std::vector<double>* here = At(point);
    if (here == nullptr) return false;
    std::copy(here->begin(), here->end(), residuals);
    if (jacobians == nullptr) return true;
    if (!UpdateJacobian(point, *here)) return false;
    for (int i = 0; i < space_.size(); ++i) {
      if (jacobians[i] == nullptr) continue;
      const auto column = jacobian_.col(i);
      std::copy(column.begin(), column.end(), jacobians[i]);
    }
    return true;
  }

  const std::vector<double>* At(const Point& point) const {
    return log_.Residuals(space_.ToParameters(point), gate_width_);
  }

  // By differences where there is no Jacobian yet; then with what the step from the last point
  // showed.
  bool UpdateJacobian(const Point& point, const std::vector<double>& here) const {
    const Eigen::VectorXd x = Eigen::VectorXd::Map(point.data(), space_.size());
    const Eigen::VectorXd r = Eigen::VectorXd::Map(here.data(), num_residuals());
    if (jacobian_.size() == 0) {
      Eigen::MatrixXd jacobian(num_residuals(), space_.size());
      for (int i = 0; i < space_.size(); ++i) {
        if (!Column(point, i, here, jacobian.col(i).data())) return false;
      }
      jacobian_ = std::move(jacobian);
    } else {
      const Eigen::VectorXd step = x - point_;
      const double square = step.squaredNorm();
      if (square > 0) {
        const Eigen::VectorXd missed = r - residuals_ - jacobian_ * step;
        jacobian_ += missed * (step / square).transpose();
      }
    }
    point_ = x;
    residuals_ = r;
    return true;
  }

  bool Column(const Point& point, int i, const std::vector<double>& here, double* column) const {
    const auto axis = static_cast<std::size_t>(i);
    const double step = point[axis] + kDifference <= 1 ? kDifference : -kDifference;
    Point moved = point;
    moved[axis] += step;
    const std::vector<double>* there = At(moved);
    if (there == nullptr) return false;
    for (std::size_t k = 0; k < here.size(); ++k) column[k] = ((*there)[k] - here[k]) / step;
    return true;
  }

  RunLog& log_;
  const SearchSpace& space_;
  const float gate_width_;
  // Of the last point at which Ceres asked for a Jacobian.
  mutable Eigen::MatrixXd jacobian_;
  mutable Eigen::VectorXd point_, residuals_;
};

}  // namespace

Point FitAtWidth(RunLog& log, const SearchSpace& space, float gate_width, const Point& start,
                 double* trust_radius) {
  const std::vector<double>* at_start = log.Residuals(space.ToParameters(start), gate_width);
  if (at_start == nullptr) return start;
  Point point = start;
  ceres::Problem problem;
  std::vector<double*> blocks;
  for (double& coordinate : point) blocks.push_back(&coordinate);
  problem.AddResidualBlock(
      std::make_unique<RunResiduals>(log, space, gate_width, at_start->size()).release(), nullptr,
      blocks);
  ceres::Solver::Options options;
  options.minimizer_type = ceres::TRUST_REGION;
  options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
  options.linear_solver_type = ceres::DENSE_QR;
  options.initial_trust_region_radius = *trust_radius;
  options.max_num_iterations = kIterations;
  options.function_tolerance = kLeastGain;
  options.parameter_tolerance = kDifference / 10;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.iterations.empty()) *trust_radius = summary.iterations.back().trust_region_radius;
  for (double& coordinate : point) coordinate = std::clamp(coordinate, 0.0, 1.0);
  return point;
}

}  // namespace warplut
