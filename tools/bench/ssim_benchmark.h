// Times SSIM with its gradient, on one thread, against an SSIM without gradient that OpenCV's
// filters make.
#pragma once

#include <string>

namespace warplut {

// The least rate that is wanted, on one thread.
inline constexpr double kSsimTargetMpixels = 40;

struct SsimBenchmark {
  double error = 0;    // |SSIM - SsimReference|, checked to be at most kSsimAccuracy
  double mpixels = 0;  // SSIM with gradient against a prepared image: median, megapixels per second
  double prepared_mpixels = 0;  // the same and preparing the image each time
  double opencv_ratio =
      0;  // OpenCV's time (value alone) over ours (value and gradient): median of pairs
};

// `repeats` timed runs of each, in turn. An Error if the result is wrong. Processor time of the
// thread.
SsimBenchmark RunSsimBenchmark(int width, int height, int repeats);

}  // namespace warplut
