// Trainings small enough to be run by the hundred, and what every training must keep.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "datasets/image.h"
#include "tests/stability/cases/stability_case.h"
#include "train/fit/objective/mlp_objective.h"
#include "train/fit/objective/warp_objective.h"

namespace warplut {

inline constexpr int kTinySide = 48;  // pixels of an image; SSIM sees half of them in each axis

struct TinyProblem {
  std::vector<Image> images;  // 1 channel, kTinySide x kTinySide
  std::vector<int> horizons = {2, 6};
  int iterations = 10;  // of L-BFGS
  std::uint64_t seed = 5;
};

struct TinyResult {
  std::vector<double> parameters;
  double start = 0, end = 0;  // objective with the penalty on gain
  double start_gradient = 0;  // its norm
  double end_gradient = 0;
  double gain = 0, gain_bound = 0;  // largest |H| of any node, and what was asked for
  double share = 1;                 // of the residual that LimitGain left
  std::int64_t safe_warps = 0;  // by that gain, as a certificate has it; at most kMaxRecordedWarps
  double sum_error = 0;         // largest |sum of weights - 1|
  bool identity = false;        // offset 0 has weight 1 and 15 zeros, to the last bit of a float

  // Everything finite, the end not above the start, the identity exact, sums within 1e-12.
  bool KeepsContract() const;
  bool SafeFor(int warps) const { return safe_warps >= warps; }
  std::string Text() const;
};

// The objective of the problem, as a training ends with it.
WarpObjective MakeObjective(const TinyProblem& problem);

// L-BFGS on `objective` from `parameters` and LimitGain, as a training does them, judged.
TinyResult RunTiny(const TinyProblem& problem, const Objective& objective,
                   std::vector<double> parameters);

}  // namespace warplut
