#include "train/calibration/pattern_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

namespace warplut {
namespace {

// In steps: how far trials are that a quadratic function is fitted to, and how far its least point
// may be.
constexpr double kQuadraticReach = 2.5;

class Search {
 public:
  Search(RunLog& log, const SearchSpace& space, const Candidate& start,
         const std::function<double(const Point&)>& factor)
      : log_(log),
        space_(space),
        factor_(factor),
        best_(start),
        point_(space.ToPoint(start.parameters)),
        least_(start.loss * FactorAt(point_)),
        flat_(point_.size(), false) {}

  Candidate Run(double step, double last_step) {
    while (step >= last_step && log_.stop() == RunLog::Stop::kNone) {
      const Point before = point_;
      const double least_before = least_;
      for (std::size_t i = 0; i < point_.size(); ++i) {
        if (!flat_[i]) TryCoordinate(i, step);
      }
      TryLeastOfQuadratic(step);
      if (!(least_ < least_before - kPatternGain)) {
        step *= kPatternShrink;
      } else if (point_.size() > 1) {
        Point further = point_;
        for (std::size_t i = 0; i < further.size(); ++i) further[i] += point_[i] - before[i];
        Try(further);
      }
    }
    return best_;
  }

 private:
  struct Trial {
    double loss = 0;    // times the factor, as all that is compared
    bool made = false;  // not at a border, and the log goes on
    bool better = false;
  };

  double FactorAt(const Point& point) const { return factor_ ? factor_(point) : 1.0; }

  Trial Try(Point point) {
    for (double& coordinate : point) coordinate = std::clamp(coordinate, 0.0, 1.0);
    if (point == point_) return {};
    const Parameters parameters = space_.ToParameters(point);
    const std::optional<double> loss = log_.Loss(parameters);
    if (!loss) return {};
    const double value = *loss * FactorAt(point);
    tried_.emplace_back(point, value);
    const bool better = value < least_;
    if (better) {
      best_ = {parameters, *loss};
      point_ = std::move(point);
      least_ = value;
    }
    return {value, true, better};
  }

  void TryCoordinate(std::size_t i, double step) {
    const auto moved = [&](double by) {
      Point point = point_;
      point[i] += by;
      return point;
    };
    const double here = least_;
    const Trial up = Try(moved(step));
    if (up.better) return;
    const Trial down = Try(moved(-step));
    if (down.better || !up.made || !down.made) return;
    if (up.loss == here && down.loss == here) {
      flat_[i] = true;
      return;
    }
    // Both sides are no better, so that the parabola opens upwards and its least point lies between
    // them. At a border a side is nearer than a step; the least point is then a guess like any
    // other.
    const double least = step / 2 * (down.loss - up.loss) / (down.loss + up.loss - 2 * here);
    if (std::abs(least) > kLastPatternStep / 4) Try(moved(least));
  }

  // The least point, no farther than two steps, of the quadratic function that fits the trials
  // around here best.
  void TryLeastOfQuadratic(double step) {
    const auto p = static_cast<Eigen::Index>(point_.size());
    const Eigen::Index terms = (p + 1) * (p + 2) / 2;
    std::vector<const std::pair<Point, double>*> near;
    for (const auto& trial : tried_) {
      if (Distance(trial.first, point_) <= kQuadraticReach * step) near.push_back(&trial);
    }
    if (p < 2 || static_cast<Eigen::Index>(near.size()) < terms) return;
    Eigen::MatrixXd design(static_cast<Eigen::Index>(near.size()), terms);
    Eigen::VectorXd losses(design.rows());
    for (Eigen::Index row = 0; row < design.rows(); ++row) {
      const auto& [point, loss] = *near[static_cast<std::size_t>(row)];
      losses[row] = loss - least_;
      Eigen::Index column = 0;
      design(row, column++) = 1;
      for (std::size_t i = 0; i < point.size(); ++i) {
        const double x = (point[i] - point_[i]) / step;
        design(row, column++) = x;
        for (std::size_t j = 0; j <= i; ++j) {
          design(row, column++) = x * (point[j] - point_[j]) / step * (i == j ? 0.5 : 1.0);
        }
      }
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(design);
    if (solver.rank() < terms) return;
    const Eigen::VectorXd fit = solver.solve(losses);
    Eigen::VectorXd gradient(p);
    Eigen::MatrixXd hessian(p, p);
    Eigen::Index at = 1;
    for (Eigen::Index i = 0; i < p; ++i) {
      gradient[i] = fit[at++];
      for (Eigen::Index j = 0; j <= i; ++j) hessian(i, j) = hessian(j, i) = fit[at++];
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(hessian);
    if (factor.info() != Eigen::Success) return;
    Eigen::VectorXd move = factor.solve(-gradient);
    const double length = move.cwiseAbs().maxCoeff();
    if (length < 0.1) return;
    if (length > kQuadraticReach) move *= kQuadraticReach / length;
    Point point = point_;
    for (std::size_t i = 0; i < point.size(); ++i) {
      point[i] += step * move[static_cast<Eigen::Index>(i)];
    }
    Try(std::move(point));
  }

  RunLog& log_;
  const SearchSpace& space_;
  const std::function<double(const Point&)>& factor_;
  Candidate best_;
  Point point_;
  double least_;
  std::vector<std::pair<Point, double>> tried_;
  std::vector<bool> flat_;
};

}  // namespace

Candidate PatternSearch(RunLog& log, const SearchSpace& space, const Candidate& start,
                        double first_step, double last_step,
                        const std::function<double(const Point&)>& factor) {
  return Search(log, space, start, factor).Run(first_step, last_step);
}

}  // namespace warplut
