// A training from images on disk to a fit: the work of `warplut train`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "luts/contract.h"
#include "luts/fit/prefilter_json.h"
#include "train/fit/trainer.h"

namespace warplut {

// Choices of `options` that a person names stand beside it, as words.
struct TrainingRequest {
  TrainOptions options;
  std::vector<std::string> data;  // ListImages
  std::string streams_below;      // ReadSequence
  std::string out;                // the fit; a checkpoint stands next to it meanwhile
  std::string name;               // of the fit; empty: the file's
  std::string objective = Name(TrainObjective::kWarp);
  std::string prefilter = PrefilterName({});
  int taps = TapCount(TrainOptions().footprint);
  std::string optimizer = Name(Optimizer::kLbfgs);
};

struct TrainingOutcome {
  TrainResult result;
  int tone_mapped = 0;  // images that were linear
  std::size_t images = 0;
};

// Trains on all ranks; the root writes the fit and returns what it found, the others return
// nothing. UsageError: a request that makes no sense, told before an image is read. Error: an input
// or an output that cannot be used, an interruption.
std::optional<TrainingOutcome> RunTraining(const TrainingRequest& request);

}  // namespace warplut
