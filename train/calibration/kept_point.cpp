#include "train/calibration/kept_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "train/calibration/prior.h"

namespace warplut {
namespace {

// Parts of the straight way that are looked at.
constexpr int kWayParts = 4;

// n / (n - 1) times the sum of (d - mean)^2: the variance of the sum of n independent differences.
// 0 for one.
double VarianceOfSum(const std::vector<double>& differences) {
  const auto n = static_cast<double>(differences.size());
  if (n < 2) return 0;
  double sum = 0, squares = 0;
  for (const double d : differences) sum += d;
  for (const double d : differences) squares += (d - sum / n) * (d - sum / n);
  return n / (n - 1) * squares;
}

int CountSources(std::vector<int> sources) {
  std::sort(sources.begin(), sources.end());
  return static_cast<int>(std::unique(sources.begin(), sources.end()) - sources.begin());
}

class Keeper {
 public:
  Keeper(RunLog& log, const SearchSpace& space, const std::vector<int>& sources,
         const Candidate& base, const Candidate& optimum)
      : log_(log),
        space_(space),
        sources_(sources),
        clips_(CountSources(sources)),
        base_(base),
        base_point_(space.ToPoint(base.parameters)),
        optimum_(optimum) {}

  KeptPoint Run(double most_loss) {
    KeptPoint kept{base_, 0, std::vector<bool>(base_point_.size(), true)};
    if (!BaseIsAsGood() || base_.loss > most_loss) {
      kept = {LeastWithPrior(), 0, std::vector<bool>(base_point_.size(), false)};
      GoToBase(&kept);
    }
    const Point from = space_.ToPoint(kept.at.parameters);
    for (int part = 1; kept.at.loss > most_loss; ++part) {
      kept.at = part < kWayParts ? OnWay(from, optimum_, part).value_or(optimum_) : optimum_;
      kept.at_base.assign(base_point_.size(), false);
    }
    kept.standard_error = Compare(kept.at, optimum_).standard_error;
    return kept;
  }

 private:
  bool BaseIsAsGood() {
    const LossDifference cost = Compare(base_, optimum_);
    return cost.mean <= cost.standard_error;
  }

  double Factor(const Point& point) const {
    double square = 0;
    for (std::size_t i = 0; i < point.size(); ++i) {
      square += (point[i] - base_point_[i]) * (point[i] - base_point_[i]);
    }
    return PriorFactor(square, clips_);
  }

  double WithPrior(const Candidate& candidate) const {
    return candidate.loss * Factor(space_.ToPoint(candidate.parameters));
  }

  std::optional<Candidate> OnWay(const Point& from, const Candidate& to, int part) {
    Point point = space_.ToPoint(to.parameters);
    for (std::size_t i = 0; i < point.size(); ++i) {
      point[i] = from[i] + (point[i] - from[i]) * part / kWayParts;
    }
    const Parameters parameters = space_.ToParameters(point);
    const std::optional<double> loss = log_.Loss(parameters);
    return loss ? std::optional(Candidate{parameters, *loss}) : std::nullopt;
  }

  Candidate LeastWithPrior() {
    Candidate best = WithPrior(optimum_) < WithPrior(base_) ? optimum_ : base_;
    for (int part = 1; part < kWayParts; ++part) {
      const std::optional<Candidate> on_way = OnWay(base_point_, optimum_, part);
      if (on_way && WithPrior(*on_way) < WithPrior(best)) best = *on_way;
    }
    return PatternSearch(log_, space_, best, kFirstPatternStep, kLastPatternStep,
                         [this](const Point& point) { return Factor(point); });
  }

  LossDifference Compare(const Candidate& a, const Candidate& b) {
    const std::vector<double>* of_a = log_.Residuals(a.parameters, 0);
    const std::vector<double>* of_b = log_.Residuals(b.parameters, 0);
    if (of_a == nullptr || of_b == nullptr) return {std::numeric_limits<double>::infinity(), 0};
    return CompareLosses(*of_a, *of_b, sources_);
  }

  void GoToBase(KeptPoint* kept) {
    const Candidate from = kept->at;
    for (;;) {
      std::optional<std::size_t> cheapest;
      Candidate nearer;
      for (std::size_t i = 0; i < base_point_.size(); ++i) {
        if (kept->at_base[i]) continue;
        const auto member = space_.info(static_cast<int>(i)).member;
        Parameters parameters = kept->at.parameters;
        parameters.*member = base_.parameters.*member;
        const std::optional<double> loss = log_.Loss(parameters);
        if (!loss) return;
        if (cheapest && !(*loss < nearer.loss)) continue;
        const LossDifference cost = Compare({parameters, *loss}, from);
        if (cost.mean > cost.standard_error || *loss > base_.loss) continue;
        cheapest = i;
        nearer = {parameters, *loss};
      }
      if (!cheapest) return;
      kept->at = nearer;
      kept->at_base[*cheapest] = true;
    }
  }

  RunLog& log_;
  const SearchSpace& space_;
  const std::vector<int>& sources_;
  const int clips_;
  const Candidate& base_;
  const Point base_point_;
  const Candidate& optimum_;
};

}  // namespace

LossDifference CompareLosses(const std::vector<double>& a, const std::vector<double>& b,
                             const std::vector<int>& sources) {
  LossDifference result;
  std::vector<double> differences;
  std::map<int, double> of_source;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double difference = (a[k] * a[k] - b[k] * b[k]) / 2;
    result.mean += difference;
    differences.push_back(difference);
    of_source[sources[k]] += difference;
  }
  std::vector<double> sums;
  for (const auto& [source, sum] : of_source) sums.push_back(sum);
  result.standard_error = std::sqrt(std::max(VarianceOfSum(differences), VarianceOfSum(sums)));
  return result;
}

KeptPoint KeepNearBase(RunLog& log, const SearchSpace& space, const std::vector<int>& sources,
                       const Candidate& base, const Candidate& optimum, double most_loss) {
  return Keeper(log, space, sources, base, optimum).Run(most_loss);
}

}  // namespace warplut
