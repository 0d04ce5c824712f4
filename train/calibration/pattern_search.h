// A deterministic search without derivatives, for losses with steps, as hard gates give them.
#pragma once

#include <functional>

#include "train/calibration/run_log.h"
#include "train/calibration/search_space.h"

namespace warplut {

struct Candidate {
  Parameters parameters;
  double loss = 0;  // on hard gates
};

// Steps, of the unit cube's side.
inline constexpr double kFirstPatternStep = 0.05;
inline constexpr double kCoarsePatternStep = 0.0125;  // enough to tell where a start leads
inline constexpr double kLastPatternStep = 0.003;
inline constexpr double kPatternShrink = 0.25;
inline constexpr double kPatternGain = 2e-5;  // of the loss; a round that gains less ends its step

// Hooke and Jeeves, 1961, with a parabola through each coordinate's three points: tries a step up
// and down each coordinate, then the parabola's least point, then once more the way that a whole
// round of coordinates went; where a round gains nothing the steps shrink, from `first_step` to no
// less than `last_step`. Coordinates along which nothing changes are left alone. Only less loss is
// accepted, so the result is never worse than `start`; stops early with the log. With a factor,
// what falls is the loss times the factor of the point, and the gain that ends a step is of that;
// losses of candidates are without it.
Candidate PatternSearch(RunLog& log, const SearchSpace& space, const Candidate& start,
                        double first_step, double last_step,
                        const std::function<double(const Point&)>& factor = {});

}  // namespace warplut
