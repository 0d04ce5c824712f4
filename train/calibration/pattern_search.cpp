#include "train/calibration/pattern_search.h"

#include <algorithm>
#include <cmath>

namespace warplut {
namespace {

class Search {
 public:
  Search(RunLog& log, const SearchSpace& space, const Candidate& start)
      : log_(log),
        space_(space),
        best_(start),
        point_(space.ToPoint(start.parameters)),
        flat_(point_.size(), false) {}

  Candidate Run(double step, double last_step) {
    while (step >= last_step && log_.stop() == RunLog::Stop::kNone) {
      const Point before = point_;
      const double loss_before = best_.loss;
      for (std::size_t i = 0; i < point_.size(); ++i) {
        if (!flat_[i]) TryCoordinate(i, step);
      }
      if (!(best_.loss < loss_before - kPatternGain)) {
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
    double loss = 0;
    bool made = false;  // not at a border, and the log goes on
    bool better = false;
  };

  Trial Try(Point point) {
    for (double& coordinate : point) coordinate = std::clamp(coordinate, 0.0, 1.0);
    if (point == point_) return {};
    const Parameters parameters = space_.ToParameters(point);
    const std::optional<double> loss = log_.Loss(parameters);
    if (!loss) return {};
    const bool better = *loss < best_.loss;
    if (better) {
      best_ = {parameters, *loss};
      point_ = std::move(point);
    }
    return {*loss, true, better};
  }

  void TryCoordinate(std::size_t i, double step) {
    const auto moved = [&](double by) {
      Point point = point_;
      point[i] += by;
      return point;
    };
    const double here = best_.loss;
    const Trial up = Try(moved(step));
    if (up.better) return;
    const Trial down = Try(moved(-step));
    if (down.better || !up.made || !down.made) return;
    if (up.loss == here && down.loss == here) {
      flat_[i] = true;
      return;
    }
    // Both sides are no better, so that the parabola opens upwards and its least point lies between them. At a border a side
    // is nearer than a step; the least point is then a guess like any other.
    const double least = step / 2 * (down.loss - up.loss) / (down.loss + up.loss - 2 * here);
    if (std::abs(least) > kLastPatternStep / 4) Try(moved(least));
  }

  RunLog& log_;
  const SearchSpace& space_;
  Candidate best_;
  Point point_;
  std::vector<bool> flat_;
};

}  // namespace

Candidate PatternSearch(RunLog& log, const SearchSpace& space, const Candidate& start,
                        double first_step, double last_step) {
  return Search(log, space, start).Run(first_step, last_step);
}

}  // namespace warplut
