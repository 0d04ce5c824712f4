// The cross table of upscale factors: filters judged by objective `sr`
// (train/fit/objective/sr_objective.h) at factors for which they were trained, and at others.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "datasets/image.h"
#include "luts/quantize/baked_table.h"
#include "train/fit/resampler.h"
#include "train/fit/train_options.h"

namespace warplut {

// The weights of a checked table at the canonical nodes, and its prefilter. A table that lacks the
// symmetries of the square is judged as if it had those of its first octant.
Resampler TableResampler(const BakedTable& table);

struct CrossFilter {
  std::string name;
  Resampler resampler;
};

// One filter at one factor.
struct CrossScore {
  double loss = 0;           // L, against the best Keys kernel of each protocol; lower is better
  std::vector<double> ssim;  // of each protocol
};

struct CrossColumn {
  TrainOptions options;                // resolved; the factor among them
  std::vector<std::string> protocols;  // "64 random"
  double keys_a = 0;                   // of the Keys kernel with the least L
  CrossScore keys;
  std::vector<CrossScore> scores;  // of the filters, in order
};

// Judges the filters at options.scale, with the horizons, blend, pans and seed of the options, on
// options.crops crops. Images are luma, of at least a crop (CheckedLuma). The same bits for any
// number of threads.
CrossColumn JudgeAtScale(const std::vector<CrossFilter>& filters, const std::vector<Image>& luma,
                         const TrainOptions& options);

}  // namespace warplut
