// Fits the MLP of resampling weights to images: objective `warp`, a sum of 1 - SSIM over repeated warps.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "datasets/image.h"
#include "luts/fit.h"

namespace warplut {

enum class Optimizer : std::uint8_t { kLbfgs, kAdam };

constexpr const char* Name(Optimizer optimizer) {
  return optimizer == Optimizer::kLbfgs ? "lbfgs" : "adam";
}

struct TrainOptions {
  double scale = 2;               // output / render, [1, 4]
  std::vector<int> horizons;      // even, ascending; empty: DefaultHorizons(scale)
  Optimizer optimizer = Optimizer::kLbfgs;
  std::uint64_t seed = 1;
  int threads = 0;                // 0: all
  double max_seconds = 0;         // 0: no limit; the result then does not depend on the machine's speed
  int iterations = 0;             // of the optimizer; 0: its default
  double gain_bound = 0;          // largest |H| of any node and frequency; 0: the default for the horizons
  int crops = 0;                  // 0: the default
  std::filesystem::path checkpoint;  // empty: none; written atomically, removed when the fit is done
  bool resume = false;            // from `checkpoint`, made with the same options and data

  bool IsValid(std::string* why) const;
};

// Horizons for an upscale factor: how many warps history lives through at factor `scale`.
std::vector<int> DefaultHorizons(double scale);

// A training image: 1 (luma) or 3 channels, values in [0, 1].
struct TrainImage {
  FitData record;
  Image image;
};

struct TrainProgress {
  double seconds = 0;
  std::int64_t evaluations = 0;
  double loss = 0;
  double validation = 0;
  double fraction = 0;  // of the work, or of max_seconds, in [0, 1]
};

// Called between evaluations; returns false to stop well (a checkpoint is kept, the fit so far is returned).
using TrainCallback = std::function<bool(const TrainProgress&)>;

struct TrainResult {
  Fit fit;
  bool interrupted = false;
};

// Trains. Images smaller than a crop, empty data, or a checkpoint of other options are an Error. Same options, data and
// seed give the same bits for any number of threads, unless max_seconds or the callback ends it.
TrainResult Train(const TrainOptions& options, const std::vector<TrainImage>& images,
                  const TrainCallback& progress = {});

}  // namespace warplut
