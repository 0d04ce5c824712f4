// A history that is warped and blended again and again, and what its certificate allows.
//
//   x <- (1 - blend) (W x + e) + blend u + e'
//
// x lies on a torus, as the certificate knows no borders; W warps by one motion, u is the input of
// the frame, e and e' are roundings. With c any constant, g the gain of W, and |.| the root mean
// square,
//   |x - c|  <=  r_n,   r_0 = |x_0 - c|,   r_(n+1) = (1 - blend) (g r_n + |e|) + blend
//            |u - c| + |e'|
// as W keeps constants, whatever the inputs are. docs/CERTIFICATE.md has the rest.
#pragma once

#include <functional>
#include <span>

#include "luts/contract.h"
#include "runtime/image_view.h"
#include "runtime/warp.h"

namespace warplut {

// Fills one value in [0, 1] for each pixel of the torus, one row after the other, with those of a
// frame.
using LoopInput = std::function<void(int frame, std::span<double> values)>;

struct LoopOptions {
  PixelFormat format = PixelFormat::kRgba32F;
  WarpOptions warp;
  float motion_x = 0, motion_y = 0;  // pixels, less than 2 in size
  double gain = 1;                   // of one warp by this motion
  double blend = 0;                  // 0: warps alone
  int size = 32;                     // pixels of the torus, in each axis
  int frames = 10000;
  double center = 0.5;  // c
  LoopInput first;      // x_0, of frame 0
  LoopInput input;      // u; not called for blend 0
};

struct LoopResult {
  double worst_ratio =
      0;  // the largest |x - c| / r over the frames; at most 1 if the prediction holds
  double first = 0, last = 0;  // |x - c|, of 0 and after all frames
  double drift = 0;            // largest |mean of x - mean of x_0|
  bool finite = true;          // all the way
  int judged = 0;  // frames before the first value above 4 in size; what follows is not judged
};

LoopResult RunLoop(const LoopOptions& options);

// The gain of a warp by this motion: of the weights that the filter has at its offset, with what
// float lookups may add.
double GainOfMotion(const WarpOptions& warp, float motion_x, float motion_y);

}  // namespace warplut
