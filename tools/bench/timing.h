// Processor time of calls on one thread.
#pragma once

#include <time.h>

#include <algorithm>
#include <vector>

namespace warplut {

// Milliseconds of processor time of the calling thread, per call.
struct Timing {
  double min = 0;
  double median = 0;
  double max = 0;
};

// `values` is not empty.
inline Timing Summarise(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values.front(), values[values.size() / 2], values.back()};
}

// Time that this thread has spent on a processor, so that other programs do not count.
inline double ThreadMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

template <class Call>
double Milliseconds(const Call& call) {
  const double start = ThreadMilliseconds();
  call();
  return ThreadMilliseconds() - start;
}

}  // namespace warplut
