// Progress of long work on standard error: share done, rate, time left. Silent unless that is a
// terminal.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace warplut {

// The line for `done` of `total` units after `seconds`:
//   warping 12/40 frames  30 %  4.1 frames/s  7 s left
// With an empty unit only share and time are told; `note` comes last.
std::string ProgressLine(const std::string& label, double done, double total,
                         const std::string& unit, double seconds, const std::string& note);

// Shows the line while work goes on, and clears it in the end. Update may be called from any
// thread.
class Progress {
 public:
  Progress(std::string label, double total, std::string unit);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Sets how much is done.
  void Update(double done, const std::string& note = {});
  // Adds to what is done.
  void Add(double units);

 private:
  using Clock = std::chrono::steady_clock;

  void Show(const std::string& note);  // with mutex_ held

  const std::string label_;
  const std::string unit_;
  const double total_;
  const bool shown_;
  const Clock::time_point start_;
  std::mutex mutex_;
  Clock::time_point last_;
  double done_ = 0;
};

}  // namespace warplut
