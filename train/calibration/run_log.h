// The runs of the pipeline of a calibration: counted, remembered, and kept in a file for going on.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "train/calibration/residual_function.h"

namespace warplut {

struct RunLogOptions {
  double max_seconds = 0;            // 0: no limit
  std::filesystem::path checkpoint;  // empty: none
  bool resume = false;               // from `checkpoint`; without the file from the start
  std::string made_for;  // what decides the result; another calibration's checkpoint is refused
  std::function<bool()> go_on;  // asked before every run; may be empty
};

// A search that asks for the same runs in the same order gets the same answers, whether they come
// from the log or from the pipeline: to go on after an interruption is to search again with the log
// that was kept.
class RunLog {
 public:
  enum class Stop : std::uint8_t { kNone, kAsked, kTime };

  // Error: a checkpoint that is damaged, was made for another calibration, or whose first run does
  // not give the same bits again.
  RunLog(ResidualFunction& function, RunLogOptions options);

  // Residuals of the parameters at a gate width; null once stopped. Valid as long as the log.
  const std::vector<double>* Residuals(const Parameters& parameters, float gate_width);

  // The loss there; nothing once stopped.
  std::optional<double> Loss(const Parameters& parameters, float gate_width = 0);

  Stop stop() const { return stop_; }

  // From now on the time may run to so many seconds since construction (0: no limit); a log that
  // time has stopped goes on if there is some left.
  void LimitTo(double max_seconds);

  int runs() const {
    return static_cast<int>(runs_.size());
  }                        // of the pipeline, those of the checkpoint included
  double Seconds() const;  // since construction

  // Writes the checkpoint, if there is one to write.
  void Save();

 private:
  using Clock = std::chrono::steady_clock;
  using Key = std::array<float, kParameters.size() + 1>;  // parameters, then the gate width

  void Load();
  void CheckThatRunsRepeat();

  ResidualFunction& function_;
  const RunLogOptions options_;
  const Clock::time_point start_;
  std::optional<Clock::time_point> saved_;  // nothing before the first run: a full disk shows early
  double limit_;                            // seconds; 0: none
  Stop stop_ = Stop::kNone;
  std::map<Key, std::vector<double>> runs_;
};

}  // namespace warplut
