// Times super resolution on one thread against the warp of its history alone, runs interleaved.
#pragma once

#include <string>
#include <vector>

#include "tools/bench/timing.h"

namespace warplut {

// How much longer than the warp of its history a frame may take with the default options, smooth
// motion, at 1920 x 1080.
inline constexpr double kSrTarget = 3;

struct SrBenchmarkOptions {
  double scale = 2;  // output / render, in [1, 4]
  int repeats = 15;  // timed frames of each row, >= 1

  bool IsValid(std::string* why) const;
};

struct SrBenchmarkRow {
  int width = 0, height = 0;  // output
  std::string motion;         // "smooth" (another motion at every pixel) or "uniform"
  std::string variant;        // what differs from the default options
  Timing process;             // milliseconds per frame
  Timing warp;  // milliseconds of Warp on an RGBA16F history, LUT, bilinear lookup, the same motion
  Timing ratio;       // process / warp of runs made one after the other
  double target = 0;  // what the median of `ratio` should not exceed; 0 if none is set
  double flipped =
      0;  // share of pixels that differ from the reference by more than half a code value
  double memory = 0;  // bytes of all buffers, in RGBA16F images of the output size

  bool met() const { return target == 0 || ratio.median <= target; }
};

// 1280 x 720 and 1920 x 1080. Before a row is timed some frames are compared with the plain version
// of every pass; an Error names the row if more than a thousandth of the pixels differ (a gate may
// fall on the other side by rounding).
std::vector<SrBenchmarkRow> RunSrBenchmark(const SrBenchmarkOptions& options);

}  // namespace warplut
