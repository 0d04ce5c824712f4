// The closed-form filters that a training must beat, and their losses: the baselines of objectives.
#pragma once

#include <vector>

#include "train/fit/objective.h"

namespace warplut {

struct Rival {
  Resampler resampler;
  std::vector<double> losses;  // Objective::Losses
};

// The Keys kernels of train/fit/keys_search.h, or with `largest_side` > 0 kRivalSplines cubic splines
// with their exact prefilters, of sides evenly spaced up to that one.
std::vector<Rival> JudgeRivals(const Objective& objective, double largest_side);

inline constexpr int kRivalSplines = 8;
inline constexpr double kLeastRivalSide = 0.15;

// The least loss of any rival in each protocol.
std::vector<double> LeastLosses(const std::vector<Rival>& rivals);

// The rival that loses least in this protocol.
const Rival& BestRival(const std::vector<Rival>& rivals, std::size_t protocol);

}  // namespace warplut
