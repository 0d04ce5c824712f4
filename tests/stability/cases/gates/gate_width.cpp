#include "tests/stability/cases/gates/gate_width.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/gates.h"
#include "tests/stability/cases/gradients/gradient_differences.h"
#include "train/calibration/calibration.h"
#include "train/calibration/gate_model.h"

namespace warplut {
namespace {

constexpr int kDepthParameter = 0, kBlendAParameter = 3;  // of kParameters
constexpr float kStart = 0.05f;

std::vector<float> Widths() { return {1, 1e-1f, 1e-2f, 1e-3f, 1e-4f, 1e-5f, 1e-6f}; }

// One pixel whose difference is the threshold that a search starts at: the middle of the ramp, at
// any width. Letting it pass costs 0.5, and every e-fold of the threshold 0.02.
class StiffGate final : public ResidualFunction {
 public:
  std::size_t Size() const override { return 2; }
  void Evaluate(const Parameters& parameters, float width, std::span<double> residuals) override {
    const double threshold = parameters.sr_depth_threshold;
    residuals[0] = Gate(double{kStart}, threshold, double{width});
    residuals[1] = 0.2 * std::log(threshold / kStart);
  }
};

// d loss / d coordinate at the start, with r_0 = 1/2 and d r_0 / d T = 1 / (2 T w).
double StiffGradient(const SearchSpace& space, double width) {
  const double slope = space.Slope(0, space.Coordinate(0, kStart));
  return 0.5 * slope / (2 * double{kStart} * width);
}

double LossAt(ResidualFunction& function, const Parameters& parameters, float width) {
  std::vector<double> residuals(function.Size());
  function.Evaluate(parameters, width, residuals);
  return LossOf(residuals);
}

// The least loss on hard gates over the threshold's range, by a dense grid.
double LeastLoss(ResidualFunction& function, int steps) {
  const SearchSpace space({kDepthParameter}, {});
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const Point point = {static_cast<double>(i) / steps};
    least = std::min(least, LossAt(function, space.ToParameters(point), 0));
  }
  return least;
}

CalibrationOptions ThresholdOptions(std::vector<float> widths) {
  CalibrationOptions options;
  options.fitted = {kDepthParameter};
  options.widths = std::move(widths);
  options.random_starts = 0;
  options.base.sr_depth_threshold = 1;  // twenty times too large
  return options;
}

}  // namespace

// d/dT of (T + T w - x) / (2 T w) at x = T is 1 / (2 T w).
StabilityResult GateSlope(StabilityEffort) {
  constexpr double kT = 0.05;
  double worst = 0, steepest = 0;
  for (const double width : Widths()) {
    const auto gate = [&](double threshold) { return Gate(kT, threshold, width); };
    const double slope = FourthOrderDifference(gate, kT, kT * width / 200);
    const double expected = 1 / (2 * kT * width);
    worst = std::max(worst, std::abs(slope / expected - 1));
    steepest = std::max(steepest, slope);
  }
  return {worst <= 1e-8,
          fmt::format("up to {:.2e} at width 1e-6, relative error {:.0e}", steepest, worst)};
}

StabilityResult GateAtThresholdZero(StabilityEffort) {
  int wrong = 0;
  std::vector<float> widths = Widths();
  widths.push_back(0);
  for (const float width : widths) {
    wrong += Gate(0.0f, 0.0f, width) != 1;
    wrong += Gate(-1.0f, 0.0f, width) != 1;
    wrong += Gate(std::numeric_limits<float>::denorm_min(), 0.0f, width) != 0;
    wrong += Gate(std::numeric_limits<float>::infinity(), 0.0f, width) != 0;
    wrong += Gate(std::numeric_limits<float>::quiet_NaN(), 0.0f, width) != 0;
  }
  return {wrong == 0, fmt::format("{} of {} values wrong", wrong, 5 * widths.size())};
}

StabilityResult GateBeyondRange(StabilityEffort) {
  int refused = 0, limited = 0, tried = 0;
  std::string sentence;
  for (const int p : {0, 1, 2}) {
    const ParameterInfo& info = kParameters[p];
    const SearchSpace space({p}, {});
    for (const float value :
         {0.0f, -1.0f, std::nextafter(info.min, 0.0f), 2 * info.max,
          std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
      CalibrationOptions options;
      options.fitted = {p};
      options.base.*info.member = value;
      std::string why;
      ++tried;
      refused += !options.IsValid(&why) && why.find(info.name) != std::string::npos;
      if (sentence.empty()) sentence = why;
      if (std::isnan(value)) continue;
      const float in_range = space.ToParameters(space.ToPoint(options.base)).*info.member;
      limited += in_range == std::clamp(value, info.min, info.max);
    }
  }
  const int numbers = tried * 5 / 6;
  return {refused == tried && limited == numbers,
          fmt::format("{} of {} refused, {} of {} limited by a search; \"{}\"", refused, tried,
                      limited, numbers, sentence)};
}

// A plain step of the size that suits width 1 (1 / curvature, the gradient's square in the
// Gauss-Newton sense) against Levenberg-Marquardt on differences of a fixed size, whose slope is at
// most 1 / kDifference.
StabilityResult StiffGateSteps(StabilityEffort) {
  const SearchSpace space({kDepthParameter}, {});
  const double start = space.Coordinate(0, kStart);
  const double at_one = StiffGradient(space, 1);
  const double rate = 1 / (4 * at_one * at_one);
  bool passed = true;
  double plain = 0, largest_move = 0;
  for (const float width : Widths()) {
    plain = rate * StiffGradient(space, width);
    StiffGate gate;
    RunLog log(gate, {});
    double radius = kTrustRadius;
    const Point end = FitAtWidth(log, space, width, {start}, &radius);
    const double before = LossAt(gate, space.ToParameters(Point{start}), width);
    const double after = LossAt(gate, space.ToParameters(end), width);
    passed = passed && end[0] >= 0 && end[0] <= 1 && after <= before;
    largest_move = std::max(largest_move, std::abs(end[0] - start));
  }
  return {passed && plain > 1e3, fmt::format("at width 1e-6 a plain step goes {:.1e} ranges far, "
                                             "the calibration's fits at most {:.2f}",
                                             plain, largest_move)};
}

// Each width alone, narrowing as shipped, and narrowing to the end.
StabilityResult GateNarrowing(StabilityEffort effort) {
  const bool full = effort == StabilityEffort::kFull;
  std::vector<std::vector<float>> schedules = {CalibrationOptions().widths, Widths()};
  for (const float width : Widths()) schedules.push_back({width});
  GateModel model({}, 64, full ? 400 : 100);
  const double least = LeastLoss(model, full ? 4000 : 400);
  double worst = -1;
  bool passed = true;
  int runs = 0;
  for (const std::vector<float>& widths : schedules) {
    const CalibrationResult result = Calibrate(ThresholdOptions(widths), model);
    passed = passed && result.best.loss <= result.default_loss && std::isfinite(result.best.loss);
    worst = std::max(worst, result.best.loss - least);
    runs = std::max(runs, result.search_runs);
  }
  return {passed && worst <= 5e-4,
          fmt::format("{} schedules: at most {:.1e} above the least loss {:.4f}, {} runs",
                      schedules.size(), worst, least, runs)};
}

StabilityResult GateNotIdentified(StabilityEffort) {
  bool passed = true;
  std::string observed;
  for (const bool acts : {false, true}) {
    // Either the threshold alone does nothing, or all that parameters act on is far below what
    // counts.
    GateModel model({.threshold_acts = acts, .scale = acts ? 1e-9 : 1.0});
    CalibrationOptions options;
    options.fitted = {kDepthParameter, kBlendAParameter};
    options.random_starts = 1;
    const CalibrationResult result = Calibrate(options, model);
    const CalibratedParameter& threshold = result.parameters[0];
    passed = passed && threshold.NotNeeded() && !threshold.standard_error &&
             result.best.parameters.sr_depth_threshold == options.base.sr_depth_threshold;
    observed += fmt::format(
        "{}{}: {}, {} for {}, standard error {}", observed.empty() ? "" : "; ",
        acts ? "effect of 1e-9" : "no effect", threshold.NotNeeded() ? "not needed" : "needed",
        result.best.parameters.sr_depth_threshold, options.base.sr_depth_threshold,
        threshold.standard_error ? fmt::format("{:.1e}", *threshold.standard_error) : "none");
  }
  return {passed, observed};
}

// The best threshold lies so far below the range that all passes, below it, or above it.
StabilityResult GateWithoutOptimum(StabilityEffort) {
  bool passed = true;
  std::string observed;
  for (const double best : {1e-6, 3e-5, 20.0}) {
    GateModel model({.threshold = best});
    const CalibrationResult result =
        Calibrate(ThresholdOptions(CalibrationOptions().widths), model);
    const CalibratedParameter& threshold = result.parameters[0];
    const bool where = best < 1e-5 ? threshold.NotNeeded()
                       : best < 1  ? threshold.at_min
                                   : threshold.at_max;
    const double above = result.best.loss - LeastLoss(model, 400);
    passed = passed && where && !threshold.standard_error && above <= kFlatProfile;
    observed +=
        fmt::format("{}{:g}: {:.3g}{}, {:.0e} above the least loss", observed.empty() ? "" : "; ",
                    best, threshold.value, threshold.NotNeeded() ? " not needed" : "", above);
  }
  return {passed, observed};
}

}  // namespace warplut
