#include "tools/report/sections/calibration_study.h"

#include <algorithm>
#include <limits>

#include "train/calibration/calibration.h"
#include "train/calibration/search_space.h"
#include "train/fit/random.h"

namespace warplut {
namespace {

// Notes the least loss on hard gates after each run; gates of finite width cost a run and show
// nothing.
class TracedFunction final : public ResidualFunction {
 public:
  explicit TracedFunction(ResidualFunction& function) : function_(function) {}

  std::size_t Size() const override { return function_.Size(); }
  void Evaluate(const Parameters& parameters, float gate_width,
                std::span<double> residuals) override {
    function_.Evaluate(parameters, gate_width, residuals);
    const double loss = gate_width == 0 ? LossOf(residuals) : least_;
    if (loss < least_) {
      least_ = loss;
      trace_.best = parameters;
    }
    trace_.loss.push_back(least_);
  }

  void Run(const Parameters& parameters) {
    residuals_.resize(Size());
    Evaluate(parameters, 0, residuals_);
  }
  SearchTrace& trace() { return trace_; }

 private:
  ResidualFunction& function_;
  double least_ = std::numeric_limits<double>::infinity();
  SearchTrace trace_;
  std::vector<double> residuals_;
};

// The base, the paper and the centres of the cells.
SearchTrace SearchGrid(ResidualFunction& function, const SearchSpace& space, const Parameters& base,
                       int per_axis) {
  TracedFunction traced(function);
  traced.Run(base);
  traced.Run(kPaperParameters);
  std::vector<int> cell(static_cast<std::size_t>(space.size()), 0);
  Point point(cell.size());
  for (bool more = true; more;) {
    for (std::size_t i = 0; i < cell.size(); ++i) point[i] = (cell[i] + 0.5) / per_axis;
    traced.Run(space.ToParameters(point));
    more = false;
    for (std::size_t i = 0; i < cell.size() && !more; ++i) {
      cell[i] = (cell[i] + 1) % per_axis;
      more = cell[i] != 0;
    }
  }
  return std::move(traced.trace());
}

SearchTrace SearchAtRandom(ResidualFunction& function, const SearchSpace& space,
                           const Parameters& base, int runs, std::uint64_t seed) {
  TracedFunction traced(function);
  traced.Run(base);
  traced.Run(kPaperParameters);
  Random random(seed);
  Point point(static_cast<std::size_t>(space.size()));
  while (traced.trace().runs() < runs) {
    for (double& coordinate : point) coordinate = random.Uniform();
    traced.Run(space.ToParameters(point));
  }
  return std::move(traced.trace());
}

}  // namespace

double SearchTrace::After(int runs) const {
  return loss[std::min(loss.size(), static_cast<std::size_t>(runs)) - 1];
}

const SearchTrace& CalibrationStudy::Best() const {
  const SearchTrace* best = nullptr;
  const auto compare = [&](const SearchTrace& trace) {
    if (best == nullptr || trace.loss.back() < best->loss.back()) best = &trace;
  };
  for (const SearchTrace& trace : calibrations) compare(trace);
  for (const SearchTrace& trace : random) compare(trace);
  for (const GridTrace& grid : grids) compare(grid.trace);
  return *best;
}

CalibrationStudy StudyCalibration(ResidualFunction& function,
                                  const CalibrationStudyOptions& options) {
  const SearchSpace space(options.fitted, options.base);
  CalibrationStudy study;
  const double searches = options.seeds + options.random_seeds + options.grids.size();
  const auto next = [&] {
    const std::size_t done = study.calibrations.size() + study.random.size() + study.grids.size();
    options.progress(static_cast<double>(done) / searches);
    return options.go_on();
  };
  int runs = 1;
  for (int seed = 1; seed <= options.seeds; ++seed) {
    if (!next()) return study;
    TracedFunction traced(function);
    CalibrationOptions calibration;
    calibration.fitted = options.fitted;
    calibration.base = options.base;
    calibration.seed = static_cast<std::uint64_t>(seed);
    calibration.near_base = false;
    const CalibrationResult result = Calibrate(calibration, traced);
    SearchTrace trace = std::move(traced.trace());
    trace.loss.resize(static_cast<std::size_t>(result.search_runs));
    trace.best = result.best.parameters;
    study.base_loss = result.default_loss;
    study.paper_loss = result.paper_loss;
    runs = std::max(runs, trace.runs());
    study.calibrations.push_back(std::move(trace));
  }
  for (const int per_axis : options.grids) {
    if (!next()) return study;
    study.grids.push_back({per_axis, SearchGrid(function, space, options.base, per_axis)});
  }
  for (int seed = 1; seed <= options.random_seeds; ++seed) {
    if (!next()) return study;
    study.random.push_back(SearchAtRandom(
        function, space, options.base, runs,
        DeriveSeed(static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(runs))));
  }
  study.complete = true;
  return study;
}

}  // namespace warplut
