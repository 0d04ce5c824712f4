// The closed-form filters that a training must beat, and their losses: the baselines of objectives.
#pragma once

#include <vector>

#include "train/fit/objective/objective.h"

namespace warplut {

struct Rival {
  Resampler resampler;
  std::vector<double> losses;  // Objective::Losses
};

// The closed-form filters: the Keys kernels of train/fit/rivals/keys_search.h; with `largest_side`
// > 0 kRivalSplines cubic splines with their exact prefilters, of sides evenly spaced up to that
// one; for a footprint of 24 or 36 taps kRivalKaisers windowed sincs of 36 taps, of b evenly
// spaced.
struct RivalFamily {
  double largest_side = 0;
  Footprint footprint = Footprint::k16;

  bool HasKeys() const { return !(largest_side > 0) && footprint == Footprint::k16; }
};

std::vector<Rival> JudgeRivals(const Objective& objective, const RivalFamily& family);

inline constexpr int kRivalSplines = 8;
inline constexpr double kLeastRivalSide = 0.15;
inline constexpr int kRivalKaisers = 8;
inline constexpr double kLeastRivalKaiser = 3.5;
inline constexpr double kLargestRivalKaiser = 7;

// The least loss of any rival in each protocol.
std::vector<double> LeastLosses(const std::vector<Rival>& rivals);

// The rival that loses least in this protocol.
const Rival& BestRival(const std::vector<Rival>& rivals, std::size_t protocol);

}  // namespace warplut
