#include "train/fit/rivals/rivals.h"

#include <algorithm>
#include <cmath>

#include "train/fit/rivals/kaiser_family.h"
#include "train/fit/rivals/keys_search.h"
#include "train/fit/rivals/spline_family.h"

namespace warplut {

std::vector<Rival> JudgeRivals(const Objective& objective, const RivalFamily& family) {
  std::vector<Rival> rivals;
  if (family.footprint != Footprint::k16) {
    for (int i = 0; i < kRivalKaisers; ++i) {
      const Resampler kaiser = KaiserResampler(
          std::lerp(kLeastRivalKaiser, kLargestRivalKaiser, i / (kRivalKaisers - 1.0)));
      rivals.push_back({kaiser, objective.Losses(kaiser)});
    }
    return rivals;
  }
  const double largest_side = family.largest_side;
  if (family.HasKeys()) {
    for (KeysLoss& keys : KeysLosses(objective)) {
      rivals.push_back({KeysCanonicalWeights(keys.a), std::move(keys.losses)});
    }
    return rivals;
  }
  const double first = std::min(kLeastRivalSide, largest_side / 2);
  for (int i = 0; i < kRivalSplines; ++i) {
    const double side = std::lerp(first, largest_side, i / (kRivalSplines - 1.0));
    const Resampler spline = SplineResampler(RecursivePrefilter(side));
    rivals.push_back({spline, objective.Losses(spline)});
  }
  return rivals;
}

std::vector<double> LeastLosses(const std::vector<Rival>& rivals) {
  std::vector<double> least = rivals.front().losses;
  for (const Rival& rival : rivals) {
    for (std::size_t i = 0; i < least.size(); ++i) least[i] = std::min(least[i], rival.losses[i]);
  }
  return least;
}

const Rival& BestRival(const std::vector<Rival>& rivals, std::size_t protocol) {
  return *std::min_element(rivals.begin(), rivals.end(), [&](const Rival& a, const Rival& b) {
    return a.losses[protocol] < b.losses[protocol];
  });
}

}  // namespace warplut
