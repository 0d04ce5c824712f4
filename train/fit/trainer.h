// Fits the MLP of resampling weights to images, by the objective that the options name.
//
// The training goes in stages. Each draws crops and trajectories anew, so that no stage can learn
// its trajectories by heart, and starts the optimizer from where the last one ended; early stages
// have fewer crops and a smoother objective. At the end of a stage the gain is limited, so that the
// weights keep their bound (train/fit/objective/gain_limit.h). With a prefilter the start is the
// spline with the least objective, and the baselines are splines
// (train/fit/rivals/spline_family.h). With 24 and 36 taps the start is a wide kernel, and the
// baselines are windowed sincs (train/fit/rivals/kaiser_family.h). After each stage the fit is
// validated on crops that are drawn from other places and trajectories of their own; the best stage
// is the result.
#pragma once

#include <functional>
#include <vector>

#include "datasets/image.h"
#include "luts/fit/fit.h"
#include "train/fit/train_options.h"

namespace warplut {

// A training image: 1 (luma) or 3 channels, values in [0, 1].
struct TrainImage {
  FitData record;
  Image image;
};

// The luma of the images. An Error if there are none or all are constant, or names one that is
// smaller than a crop or has values outside [0, 1] (a NaN too).
std::vector<Image> CheckedLuma(const std::vector<TrainImage>& images);

struct TrainProgress {
  double seconds = 0;
  std::int64_t evaluations = 0;
  double loss = 0;
  double validation = 0;  // after the last stage that is complete
  double fraction = 0;    // of the iterations, or of max_seconds, whichever is further; [0, 1]
};

// Called after every iteration of the optimizer; returns false to stop.
using TrainCallback = std::function<bool(const TrainProgress&)>;

struct TrainResult {
  Fit fit;                   // not valid if interrupted before the first stage was complete
  bool interrupted = false;  // by the callback; the checkpoint is kept
  bool cut = false;          // by max_seconds; the checkpoint is kept
};

// Trains. An Error says what is wrong with the data (as CheckedLuma) or the checkpoint (damaged, or
// of other options or data, and which). Same options, data and seed give the same bits for any
// number of threads and ranks, also across an interruption, unless max_seconds ends it; between
// instruction sets the bits differ. A collective call of Ranks::World(); the root alone writes the
// checkpoint.
TrainResult Train(const TrainOptions& options, const std::vector<TrainImage>& images,
                  const TrainCallback& progress = {});

}  // namespace warplut
