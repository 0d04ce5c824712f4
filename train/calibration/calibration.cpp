#include "train/calibration/calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "datasets/hash.h"
#include "train/calibration/kept_point.h"
#include "train/fit/random.h"

namespace warplut {
namespace {

// How often a profile may show a better point and is drawn again.
constexpr int kProfileRounds = 3;
// Less gain than this is not worth another round.
constexpr double kProfileGain = 1e-6;
// The part of the way down to an optimum that is gone midway to it, where it lies downhill.
constexpr double kDownhill = 0.25;

// Whether the parameter is what a gate compares with.
bool IsThreshold(const ParameterInfo& info) {
  return info.member == &Parameters::sr_depth_threshold ||
         info.member == &Parameters::generation_depth_threshold ||
         info.member == &Parameters::brightness_threshold;
}

class Calibration {
 public:
  Calibration(const CalibrationOptions& options, ResidualFunction& function)
      : options_(options),
        function_(function),
        space_(options.fitted, options.base),
        log_(function, {.max_seconds = kSearchShare * options.max_seconds,
                        .checkpoint = options.checkpoint,
                        .resume = options.resume,
                        .made_for = options.Identity(),
                        .go_on = [this] { return GoOn(); }}),
        widths_(options.widths) {
    const auto fits_threshold = [](int p) { return IsThreshold(kParameters[p]); };
    if (std::none_of(options.fitted.begin(), options.fitted.end(), fits_threshold)) widths_ = {0};
  }

  CalibrationResult Run() {
    result_.best = {options_.base, std::numeric_limits<double>::infinity()};
    Search();
    result_.search_runs = log_.runs();
    DrawProfiles();
    DropWhatIsNotNeeded();
    JudgeAccuracy();
    result_.stop = log_.stop();
    log_.LimitTo(options_.max_seconds);
    Keep();
    if (result_.stop == RunLog::Stop::kNone) result_.stop = log_.stop();
    result_.runs = log_.runs();
    result_.seconds = log_.Seconds();
    log_.Save();
    return std::move(result_);
  }

 private:
  bool GoOn() {
    if (!options_.progress) return true;
    return options_.progress({done_ / Work(), log_.runs(), result_.best.loss});
  }

  // In units of one descent; all profiles are about half of one, and so is what is kept.
  double Work() const { return 2.0 + options_.random_starts + 1.0; }

  void Search() {
    result_.planned_starts = 2 + options_.random_starts;
    result_.default_loss = Offer(options_.base);
    // Only to compare with: where not all parameters are fitted, it lies outside the space.
    result_.paper_loss = LossOf(kPaperParameters);
    Descend("default", options_.base);
    Descend("paper", space_.ToParameters(space_.ToPoint(kPaperParameters)));
    for (int i = 0; i < options_.random_starts; ++i) {
      Random random(DeriveSeed(options_.seed, static_cast<std::uint64_t>(i)));
      Point point;
      for (int k = 0; k < space_.size(); ++k) point.push_back(random.Uniform());
      Descend(fmt::format("random {}", i + 1), space_.ToParameters(point));
    }
    Replace(PatternSearch(log_, space_, result_.best, kCoarsePatternStep, kLastPatternStep));
  }

  // Infinite once the log has stopped.
  double LossOf(const Parameters& parameters) {
    return log_.Loss(parameters).value_or(std::numeric_limits<double>::infinity());
  }

  // The loss of a candidate for the result.
  double Offer(const Parameters& parameters) {
    const double loss = LossOf(parameters);
    if (loss < result_.best.loss) result_.best = {parameters, loss};
    return loss;
  }

  void Descend(const std::string& name, const Parameters& start) {
    const Candidate from{start, Offer(start)};
    Point point = space_.ToPoint(start);
    double radius = kTrustRadius;
    // Where a narrower gate asks for the same point, a still narrower one does as well.
    for (const float width : widths_) {
      const Point before = point;
      point = FitAtWidth(log_, space_, width, point, &radius);
      if (width != widths_.front() && Distance(point, before) < kDifference) break;
    }
    const Parameters soft = space_.ToParameters(point);
    Candidate to{soft, Offer(soft)};
    if (!(to.loss < from.loss)) to = from;

    int optimum = OptimumBelow(to);
    const bool downhill = optimum >= 0;
    if (!downhill) optimum = OptimumOf(to);
    if (!downhill &&
        (optimum < 0 || std::abs(to.loss - result_.optima[optimum].loss) > kSameLoss)) {
      to = PatternSearch(log_, space_, to, kFirstPatternStep, kCoarsePatternStep);
      optimum = OptimumOf(to);
      Offer(to.parameters);
    }
    if (std::isfinite(from.loss)) {
      if (optimum < 0) {
        optimum = static_cast<int>(result_.optima.size());
        result_.optima.push_back(to);
      } else if (to.loss < result_.optima[optimum].loss) {
        result_.optima[optimum] = to;
      }
      result_.starts.push_back(
          {name, from, to, optimum, log_.stop() == RunLog::Stop::kNone, downhill});
    }
    done_ += 1;
  }

  // The optimum that lies downhill from the candidate, or -1: midway to it a good part of the
  // difference is gone. From a plateau it is not.
  int OptimumBelow(const Candidate& candidate) {
    for (std::size_t i = 0; i < result_.optima.size(); ++i) {
      const Candidate& other = result_.optima[i];
      const std::optional<double> loss = LossMidway(candidate, other);
      if (loss && candidate.loss > other.loss &&
          *loss <= candidate.loss - kDownhill * (candidate.loss - other.loss)) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  std::optional<double> LossMidway(const Candidate& a, const Candidate& b) {
    Point midway = space_.ToPoint(a.parameters);
    const Point at = space_.ToPoint(b.parameters);
    for (std::size_t k = 0; k < midway.size(); ++k) midway[k] = (midway[k] + at[k]) / 2;
    return log_.Loss(space_.ToParameters(midway));
  }

  // The optimum that the candidate belongs to, or -1.
  int OptimumOf(const Candidate& candidate) {
    for (std::size_t i = 0; i < result_.optima.size(); ++i) {
      const Candidate& other = result_.optima[i];
      const std::optional<double> loss = LossMidway(candidate, other);
      if (loss && *loss <= std::max(candidate.loss, other.loss) + kRidge) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  void DrawProfiles() {
    for (int round = 0; round < kProfileRounds; ++round) {
      result_.parameters.clear();
      Candidate better = result_.best;
      for (int i = 0; i < space_.size(); ++i) {
        CalibratedParameter parameter;
        parameter.parameter = options_.fitted[static_cast<std::size_t>(i)];
        parameter.profile = ProfileOf(log_, space_, i, result_.best, &better);
        parameter.profiled = log_.stop() == RunLog::Stop::kNone;
        result_.parameters.push_back(std::move(parameter));
        if (round == 0) done_ += 0.5 / space_.size();
      }
      if (!(better.loss < result_.best.loss - kProfileGain) || round + 1 == kProfileRounds) break;
      Replace(PatternSearch(log_, space_, better, kFirstPatternStep, kLastPatternStep));
    }
  }

  // Moves the best optimum to a better place.
  void Replace(const Candidate& better) {
    const auto best =
        std::min_element(result_.optima.begin(), result_.optima.end(),
                         [](const Candidate& a, const Candidate& b) { return a.loss < b.loss; });
    if (best != result_.optima.end()) *best = better;
    result_.best = better;
  }

  double LeastStart() const {
    double least = std::numeric_limits<double>::infinity();
    for (const CalibrationStart& start : result_.starts) least = std::min(least, start.from.loss);
    return least;
  }

  // What the loss does not depend on gets the value of the base, unless that is worse than a start.
  void DropWhatIsNotNeeded() {
    const double least_start = LeastStart();
    for (const CalibratedParameter& parameter : result_.parameters) {
      if (!parameter.NotNeeded()) continue;
      Parameters plain = result_.best.parameters;
      const auto member = kParameters[parameter.parameter].member;
      plain.*member = options_.base.*member;
      const std::optional<double> loss = log_.Loss(plain);
      const double limit = std::min(result_.best.loss + kFlatProfile, least_start);
      if (loss && *loss <= limit) Replace({plain, *loss});
    }
  }

  void JudgeAccuracy() {
    const Point point = space_.ToPoint(result_.best.parameters);
    result_.covariance_width = widths_.back();
    const auto covariance = CovarianceAt(log_, space_, widths_.back(), point);
    if (covariance) result_.correlations = covariance->correlations;
    for (int i = 0; i < space_.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      CalibratedParameter& parameter = result_.parameters[k];
      const ParameterInfo& info = space_.info(i);
      const float value = result_.best.parameters.*info.member;
      parameter.optimum = value;
      parameter.at_min = value <= info.min;
      parameter.at_max = value >= info.max;
      if (covariance && covariance->standard_errors[k]) {
        parameter.standard_error = *covariance->standard_errors[k] * space_.Slope(i, point[k]);
      }
    }
    SortOptima();
  }

  void Keep() {
    result_.kept = result_.best;
    if (options_.near_base) {
      std::vector<int> sources;
      for (std::size_t k = 0; k < function_.Size(); ++k) sources.push_back(function_.Source(k));
      const KeptPoint kept =
          KeepNearBase(log_, space_, sources, {options_.base, result_.default_loss}, result_.best,
                       std::max(result_.best.loss, LeastStart()));
      if (log_.stop() == RunLog::Stop::kNone) {
        // The way there may pass by a better point than the one that the search stopped at.
        if (kept.at.loss < result_.best.loss) {
          Replace(kept.at);
          for (CalibratedParameter& parameter : result_.parameters) {
            parameter.optimum = kept.at.parameters.*kParameters[parameter.parameter].member;
          }
        }
        result_.kept = kept.at;
        result_.kept_error = kept.standard_error;
        for (std::size_t i = 0; i < kept.at_base.size(); ++i) {
          result_.parameters[i].at_base = kept.at_base[i];
        }
      } else {
        // How far the data leads from the base is not known.
        result_.kept = {options_.base, result_.default_loss};
        result_.kept_error.reset();
      }
    }
    for (CalibratedParameter& parameter : result_.parameters) {
      parameter.value = result_.kept.parameters.*kParameters[parameter.parameter].member;
    }
  }

  void SortOptima() {
    std::vector<std::size_t> order(result_.optima.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return result_.optima[a].loss < result_.optima[b].loss;
    });
    std::vector<Candidate> sorted;
    sorted.reserve(order.size());
    for (const std::size_t i : order) sorted.push_back(result_.optima[i]);
    result_.optima = std::move(sorted);
    for (CalibrationStart& start : result_.starts) {
      const auto at =
          std::find(order.begin(), order.end(), static_cast<std::size_t>(start.optimum));
      start.optimum = static_cast<int>(at - order.begin());
      const double reached = result_.optima[static_cast<std::size_t>(start.optimum)].loss;
      if (!start.downhill && start.to.loss > reached + kSameLoss) start.optimum = -1;
    }
  }

  const CalibrationOptions& options_;
  const ResidualFunction& function_;
  SearchSpace space_;
  RunLog log_;
  std::vector<float> widths_;
  double done_ = 0;  // descents
  CalibrationResult result_;
};

}  // namespace

bool CalibrationOptions::IsValid(std::string* why) const {
  const auto refuse = [&](std::string sentence) {
    if (why != nullptr) *why = std::move(sentence);
    return false;
  };
  if (fitted.empty()) return refuse("no parameter is fitted; expected at least one.");
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const int last = static_cast<int>(kParameters.size()) - 1;
    if (fitted[i] < 0 || fitted[i] > last || (i > 0 && fitted[i] <= fitted[i - 1])) {
      return refuse(fmt::format(
          "the fitted parameters have index {}; expected 0 to {}, ascending, each once.", fitted[i],
          last));
    }
  }
  if (!base.IsValid(why)) return false;
  if (widths.empty()) return refuse("there are no gate widths; expected at least one.");
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (!(widths[i] > 0 && widths[i] <= (i > 0 ? widths[i - 1] : 1.0f))) {
      return refuse(
          fmt::format("the gate widths have {:g}; expected falling numbers in (0, 1].", widths[i]));
    }
  }
  if (random_starts < 0 || random_starts > 1000) {
    return refuse(
        fmt::format("the number of random starts is {}; expected 0 to 1000.", random_starts));
  }
  if (!(max_seconds >= 0)) {
    return refuse(fmt::format("max_seconds is {:g}; expected 0 or more.", max_seconds));
  }
  if (resume && checkpoint.empty()) return refuse("there is no checkpoint to resume from.");
  return true;
}

std::string CalibrationOptions::Identity() const {
  std::string text = fmt::format("{} {} {}", data, random_starts, seed);
  for (const int p : fitted) text += fmt::format(" {}", kParameters[p].name);
  for (const ParameterInfo& info : kParameters) text += fmt::format(" {}", base.*info.member);
  for (const float width : widths) text += fmt::format(" {}", width);
  return Sha1(text);
}

CalibrationResult Calibrate(const CalibrationOptions& options, ResidualFunction& function) {
  return Calibration(options, function).Run();
}

}  // namespace warplut
