// The wall time that a section has.
#pragma once

#include <chrono>

namespace warplut {

class SectionTime {
 public:
  explicit SectionTime(double seconds) : seconds_(seconds) {}

  double Spent() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  // Whether work that lasts about `seconds` would end too late.
  bool Lacks(double seconds = 0) const { return Spent() + seconds > seconds_; }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double seconds_;
};

}  // namespace warplut
