// Calibration beside searches that know nothing: the loss against the number of runs of the
// pipeline.
#pragma once

#include <functional>
#include <vector>

#include "train/calibration/residual_function.h"

namespace warplut {

// All searches start with the losses of `base` and of the paper's constants, as Calibrate does, and
// know no other point.
struct CalibrationStudyOptions {
  std::vector<int> fitted;  // as in CalibrationOptions
  Parameters base;
  int seeds = 5;          // of calibrations: 1 .. seeds, each with its own random starts
  int random_seeds = 15;  // of random searches
  // Points per axis, ascending: a grid of n has n^d runs, d parameters, at the centres of n^d equal
  // cells of the range.
  std::vector<int> grids = {2, 3, 4, 5, 6, 8, 10};
  std::function<void(double share)> progress = [](double) {};
  std::function<bool()> go_on = [] {
    return true;
  };  // asked before each search; false ends the study
};

struct SearchTrace {
  std::vector<double> loss;  // the least on hard gates after 1, 2, ... runs of the pipeline
  Parameters best;           // where the last one was found

  // The loss after so many runs, at least 1; of a search that had ended by then its last one.
  double After(int runs) const;
  int runs() const { return static_cast<int>(loss.size()); }
};

struct GridTrace {
  int per_axis = 0;
  SearchTrace trace;
};

struct CalibrationStudy {
  std::vector<SearchTrace>
      calibrations;  // until the search ends; profiles and standard errors come after it
  std::vector<SearchTrace>
      // uniform in the unit cube of train/calibration/search_space.h, as long as the longest
      // calibration
      random;
  std::vector<GridTrace> grids;
  double base_loss = 0, paper_loss = 0;
  bool complete = false;

  // The search that found the least loss of all. There is one at least.
  const SearchTrace& Best() const;
};

// Options must have a valid base and at least one parameter.
CalibrationStudy StudyCalibration(ResidualFunction& function,
                                  const CalibrationStudyOptions& options);

}  // namespace warplut
