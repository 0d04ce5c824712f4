// Times each pass of super resolution and frame generation on a GPU, by its timestamps.
#pragma once

#include <string>
#include <vector>

#include "tools/bench/timing.h"

namespace warplut {

class GpuDevice;

struct PassBenchmarkOptions {
  int width = 1920, height = 1080;  // of the output, each in [2, 16384]
  double scale = 2;                 // output / render of super resolution, in [1, 4]
  int repeats = 15;                 // timed frames of each mode, >= 1

  bool IsValid(std::string* why) const;
};

struct PassBenchmarkRow {
  std::string mode;  // "sr", "i" or "e"
  std::string pass;  // the last row of a mode, "all", has the sum of each frame
  Timing time;       // milliseconds of the device
};

struct PassBenchmark {
  std::string device;
  std::vector<PassBenchmarkRow> rows;
};

// Default options, a table with prefilter, colour and history in RGBA16F. Uploads and downloads do
// not count. Frames of generation are new each time. An Error where the device has no timestamps,
// or the build no passes.
PassBenchmark RunPassBenchmark(const GpuDevice& device, const PassBenchmarkOptions& options);

}  // namespace warplut
