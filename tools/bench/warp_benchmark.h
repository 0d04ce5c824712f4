// Times Warp against OpenCV's remap, and the prefilter against Warp: one thread, one process, runs
// interleaved.
#pragma once

#include <string>
#include <vector>

#include "runtime/warp.h"
#include "tools/bench/timing.h"

namespace warplut {

struct WarpBenchmarkOptions {
  int width = 1920;
  int height = 1080;
  int repeats = 15;  // timed runs of each call, >= 1
  std::vector<PixelFormat> formats = {PixelFormat::kRgba8, PixelFormat::kRgba16F,
                                      PixelFormat::kRgba32F, PixelFormat::kR32F};

  bool IsValid(std::string* why) const;
};

struct WarpBenchmarkRow {
  PixelFormat format = PixelFormat::kRgba8;
  std::string motion;      // "smooth", "uniform", "whole", "static"
  std::string filter;      // of Warp; "any" or "tiles given" where motion is whole; or a prefilter
  std::string competitor;  // what it is compared with
  Timing warp;             // milliseconds per call, of Warp or the prefilter
  Timing other;
  Timing ratio;       // other / warp of runs made one after the other: above 1 where Warp is faster
  double target = 0;  // what the median of `ratio` should reach; 0 if none is set
  double worst_error = 0;  // largest difference from the reference, in 8-bit code values
  bool exact = false;      // no difference at all

  bool met() const { return ratio.median >= target; }
};

struct WarpBenchmark {
  std::string target;  // instruction set of Warp
  std::string opencv;  // version
  std::vector<WarpBenchmarkRow> rows;
};

// Runs the benchmark. Before a call is timed its result is compared with WarpReference; an Error
// names the row if the difference is beyond the documented bound.
//
// Motion: "smooth" has a different sub-pixel motion at each pixel, up to 8 pixels long; "uniform"
// is one fractional motion; "whole" one of whole pixels; "static" zero. Competitors: cv::remap,
// INTER_CUBIC, BORDER_REPLICATE with CV_32FC2 maps (motion comes as floats, so this is the one with
// a target) and with CV_16SC2 maps made beforehand; for "static" and "whole" one memcpy of the
// image, and the same with all of the motion read, which is what has to be done where its tiles are
// not given. remap has no half floats: RGBA16F is compared with remap of RGBA32F. RGBA32F texels of
// about 1e-40, which processors are slow with, race ordinary ones
// ("... 1e-40"; of the spline its prefilter).
// A warp with the spline reads coefficients that are made before. Its prefilter has a row of its
// own: the competitor is the warp with bilinear lookup.
WarpBenchmark RunWarpBenchmark(const WarpBenchmarkOptions& options);

}  // namespace warplut
