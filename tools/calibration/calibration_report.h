// What a calibration found, as text for people and as JSON for programs and for the file of
// parameters.
#pragma once

#include <string>
#include <vector>

#include "tools/tables/record_table.h"
#include "train/calibration/calibration.h"

namespace warplut {

// The mean SSIM of one method over one clip.
struct CalibrationScore {
  std::string clip;
  std::string mode;
  bool held_out = false;
  double calibrated = 0, defaults = 0, paper = 0;  // at these parameters
};

struct CalibrationReport {
  std::string filter;  // of history and generated frames, by name
  std::vector<std::string> modes;
  int every = 1;       // one frame in so many is rendered, in the modes that generate
  int max_pixels = 0;  // of a frame; 0: whole frames
  std::uint64_t seed = 0;
  CalibrationResult result;
  std::vector<CalibrationScore> scores;

  bool HoldsOut() const;
  // The mean over modes of the mean over clips of 1 - SSIM, of those held out or of the others.
  double Loss(double CalibrationScore::*at, bool held_out) const;
};

Json ToJson(const CalibrationReport& report);

// Tables of parameters, losses and starts, and sentences about what a reader should not overlook.
std::string ToText(const CalibrationReport& report);

}  // namespace warplut
