#include "train/calibration/covariance.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace warplut {
namespace {

// A loss that moves less over a step does not depend on the coordinate.
constexpr double kNoDependence = 1e-12;

// The residuals around a point; null where the log has stopped.
class Surroundings {
 public:
  Surroundings(RunLog& log, const SearchSpace& space, float gate_width, const Point& centre)
      : log_(log), space_(space), gate_width_(gate_width), centre_(centre) {}

  const std::vector<double>* Centre() { return At(centre_); }
  const std::vector<double>* Beside(std::size_t i, double by) {
    Point point = centre_;
    point[i] += by;
    return At(point);
  }
  const std::vector<double>* Diagonal(std::size_t i, std::size_t j) {
    Point point = centre_;
    point[i] += kCovarianceStep;
    point[j] += kCovarianceStep;
    return At(point);
  }

 private:
  const std::vector<double>* At(const Point& point) {
    return log_.Residuals(space_.ToParameters(point), gate_width_);
  }

  RunLog& log_;
  const SearchSpace& space_;
  const float gate_width_;
  const Point& centre_;
};

bool Inside(double coordinate) {
  return coordinate >= kCovarianceStep && coordinate <= 1 - kCovarianceStep;
}

}  // namespace

std::optional<Covariance> CovarianceAt(RunLog& log, const SearchSpace& space, float gate_width,
                                       const Point& point) {
  const double h = kCovarianceStep;
  Surroundings around(log, space, gate_width, point);
  const std::vector<double>* centre = around.Centre();
  if (centre == nullptr) return std::nullopt;
  const double loss = LossOf(*centre);
  const auto n = static_cast<Eigen::Index>(centre->size());

  // Columns: the coordinates that matter. Rows of `gradients`: residuals.
  std::vector<std::size_t> coordinates;
  std::vector<double> above, curvature;
  Eigen::MatrixXd gradients(n, 0);
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (!Inside(point[i])) continue;
    const std::vector<double>* high = around.Beside(i, h);
    const std::vector<double>* low = around.Beside(i, -h);
    if (high == nullptr || low == nullptr) return std::nullopt;
    Eigen::VectorXd column(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const auto at = static_cast<std::size_t>(k);
      column[k] = ((*high)[at] * (*high)[at] - (*low)[at] * (*low)[at]) / (4 * h);
    }
    if (column.cwiseAbs().maxCoeff() * h < kNoDependence) continue;
    coordinates.push_back(i);
    above.push_back(LossOf(*high));
    curvature.push_back((LossOf(*high) + LossOf(*low) - 2 * loss) / (h * h));
    gradients.conservativeResize(Eigen::NoChange, gradients.cols() + 1);
    gradients.rightCols(1) = column;
  }
  const Eigen::Index p = gradients.cols();
  Covariance result;
  result.standard_errors.resize(point.size());
  result.correlations.assign(point.size() * point.size(), 0.0);
  if (p == 0) return result;
  if (n <= p) return std::nullopt;

  Eigen::MatrixXd hessian(p, p);
  for (Eigen::Index a = 0; a < p; ++a) {
    hessian(a, a) = curvature[static_cast<std::size_t>(a)];
    for (Eigen::Index b = 0; b < a; ++b) {
      const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
      const std::vector<double>* diagonal = around.Diagonal(coordinates[i], coordinates[j]);
      if (diagonal == nullptr) return std::nullopt;
      hessian(a, b) = hessian(b, a) = (LossOf(*diagonal) - above[i] - above[j] + loss) / (h * h);
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(hessian);
  if (factor.info() != Eigen::Success) return std::nullopt;

  gradients.rowwise() -= gradients.colwise().mean().eval();
  const Eigen::MatrixXd spread =
      gradients.transpose() * gradients * (static_cast<double>(n) / static_cast<double>(n - p));
  const Eigen::MatrixXd half = factor.solve(spread);
  const Eigen::MatrixXd covariance = factor.solve(half.transpose());
  for (Eigen::Index a = 0; a < p; ++a) {
    const std::size_t i = coordinates[static_cast<std::size_t>(a)];
    result.standard_errors[i] = std::sqrt(std::max(0.0, covariance(a, a)));
    result.correlations[i * point.size() + i] = 1.0;
    for (Eigen::Index b = 0; b < a; ++b) {
      const std::size_t j = coordinates[static_cast<std::size_t>(b)];
      const double scale = std::sqrt(covariance(a, a) * covariance(b, b));
      const double correlation = scale > 0 ? covariance(a, b) / scale : 0.0;
      result.correlations[i * point.size() + j] = correlation;
      result.correlations[j * point.size() + i] = correlation;
    }
  }
  return result;
}

}  // namespace warplut
