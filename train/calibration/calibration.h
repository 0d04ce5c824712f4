// Calibration: finds the parameters with the least loss of the runtime's own code, and their
// accuracy.
//
// 1. Levenberg-Marquardt runs from each start, on gates of finite width that are narrowed step by
//    step until the point stays. (A hard gate is flat almost everywhere.) Without thresholds to fit
//    it runs on the hard gates at once. A result that is no better than its start gives way to the
//    start.
// 2. A search without derivatives runs on the hard gates and never accepts more loss. It is coarse
//    from each start, fine from the best end.
// 3. Each parameter gets a loss profile; a better point in it is polished as well. The best point
//    of all, by the loss on hard gates, is the optimum. It is never worse than any start; the
//    paper's constants are one. A parameter that is not needed keeps the value of the base.
// 4. The kept point lies between the optimum and the base (train/calibration/kept_point.h). It is
//    no worse than any start either.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "train/calibration/covariance.h"
#include "train/calibration/profile.h"
#include "train/calibration/residual_function.h"
#include "train/calibration/soft_fit.h"

namespace warplut {

struct CalibrationProgress {
  double fraction = 0;  // share of the work done, roughly
  int runs = 0;         // runs of the pipeline so far
  double loss = 0;      // the best so far
};

struct CalibrationOptions {
  std::vector<int> fitted;  // indices of kParameters, ascending, each once, at least one
  Parameters base;          // the values of the others, and the first start
  std::vector<float> widths = {0.8f, 0.4f, 0.2f, 0.1f};  // of the gates, falling, each in (0, 1]
  int random_starts = 2;  // beside the base and the paper's constants
  std::uint64_t seed = 1;
  // 0: no limit; with one that cuts the result depends on the machine's speed. The search may take
  // kSearchShare of it, so that there is some left to judge what to keep.
  double max_seconds = 0;
  bool near_base = true;             // false: the optimum is kept as it is
  std::filesystem::path checkpoint;  // empty: none
  bool resume = false;               // from `checkpoint`
  std::string data;                  // identifies the input of the residuals, for the checkpoint
  std::function<bool(const CalibrationProgress&)> progress;  // before every run; false interrupts

  bool IsValid(std::string* why = nullptr) const;

  // All options that decide the result, as one line of text.
  std::string Identity() const;
};

// The end that the search reached from a start.
struct CalibrationStart {
  std::string name;  // "default", "paper", "random 1", ...
  Candidate from, to;
  // Index in CalibrationResult::optima; -1 where the search got stuck (on a plateau, for example):
  // no ridge lies between its end and an optimum, but its loss is larger by more than kSameLoss.
  int optimum = -1;
  bool complete = false;  // the search from it came to its end
  bool downhill =
      false;  // the search ended where the optimum was in sight: the loss falls evenly towards it
};

struct CalibratedParameter {
  int parameter = 0;                     // index in kParameters
  double value = 0;                      // kept
  double optimum = 0;                    // the best on the fitted clips
  bool at_base = false;                  // kept at the base: the data does not tell the two apart
  std::optional<double> standard_error;  // of the optimum; none where the data does not say
  bool at_min = false, at_max = false;   // the optimum, of its range
  bool profiled = false;                 // the profile is complete
  Profile profile;

  // Whether the loss does not depend on it. Its pass is then a candidate for being left out.
  bool NotNeeded() const { return profiled && profile.Flat(); }
};

struct CalibrationResult {
  Candidate best;  // the least loss
  Candidate kept;  // the point to use
  // Standard error of the loss kept minus the least; nothing if what to keep was not judged, as
  // time was up: the base is kept then.
  std::optional<double> kept_error = 0;
  double default_loss = 0;  // of CalibrationOptions::base
  double paper_loss = 0;    // of kPaperParameters
  int planned_starts = 0;   // of which `starts` were begun
  std::vector<CalibrationStart> starts;
  std::vector<Candidate> optima;  // best first; between any two of them the loss has a ridge
  std::vector<CalibratedParameter> parameters;  // as CalibrationOptions::fitted
  std::vector<double> correlations;             // of the fitted, row by row; empty if unknown
  float covariance_width = 0;  // of the gates that errors and correlations were computed at
  int search_runs = 0;         // of the pipeline, for the search
  int runs = 0;                // and with profiles and errors
  double seconds = 0;          // of this call
  RunLog::Stop stop = RunLog::Stop::kNone;
};

// The share of a time limit that the search, the profiles and the errors may take.
inline constexpr double kSearchShare = 0.8;

// Two ends of the search belong together if midway between them the loss is larger than at the
// worse one by no more than kRidge; they are the same optimum if, besides, their losses differ by
// no more than kSameLoss.
inline constexpr double kRidge = 1e-4;
inline constexpr double kSameLoss = 1e-4;

// Minimises 1/2 sum of r^2 of `function`. The options must be valid. An interruption or a time
// limit writes the checkpoint and returns the best point so far; `stop` tells which, and parts
// that are not complete say so. The caller removes the checkpoint. Errors are those of RunLog.
CalibrationResult Calibrate(const CalibrationOptions& options, ResidualFunction& function);

}  // namespace warplut
