// Times frame generation and its passes on one thread against one warp of an image with the same
// motion, runs interleaved.
#pragma once

#include <string>
#include <vector>

#include "runtime/image_view.h"
#include "tools/bench/timing.h"

namespace warplut {

// How much longer than one warp an interpolated frame may take with the default options, smooth
// motion, at 1920 x 1080.
inline constexpr double kGenerationTarget = 5;

struct GenerationBenchmarkOptions {
  int repeats = 15;  // timed frames of each row, >= 1

  bool IsValid(std::string* why) const;
};

struct GenerationBenchmarkRow {
  int width = 0, height = 0;
  std::string content;        // of sources and output: "rgba8", "rgba16f" or, linear HDR, "HDR16f"
  std::string motion;         // "smooth" (another motion at every pixel) or "uniform"
  bool interpolates = false;  // else extrapolates
  Timing frame;               // milliseconds per frame
  Timing warp;                // of Warp on one source, LUT, bilinear lookup, the motion of frame 1
  Timing ratio;               // frame / warp of runs made one after the other
  Timing forward, splat, target_motion,
      blend;           // of the passes alone, on buffers of the whole frame
  double target = 0;   // what the median of `ratio` should not exceed; 0 if none is set
  double flipped = 0;  // share of pixels that differ from the reference by more than a code value
  double memory = 0;   // bytes of all buffers, in RGBA16F images

  bool met() const { return target == 0 || ratio.median <= target; }
};

// 1280 x 720 and 1920 x 1080, RGBA8, RGBA16F and linear HDR in RGBA16F. Before a row is timed its
// frame is compared with the plain version of every pass; an Error names the row if any pixel
// differs by more than a code value.
std::vector<GenerationBenchmarkRow> RunGenerationBenchmark(
    const GenerationBenchmarkOptions& options);

}  // namespace warplut
