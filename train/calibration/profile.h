// The loss as a function of one parameter while the others stay.
#pragma once

#include <vector>

#include "train/calibration/pattern_search.h"

namespace warplut {

struct ProfilePoint {
  double value = 0;  // of the parameter
  double loss = 0;   // on hard gates
};

// A parameter over whose profile the loss changes by less is not needed.
inline constexpr double kFlatProfile = 1e-5;

struct Profile {
  std::vector<ProfilePoint> points;  // ascending in value; the centre is among them

  // Largest minus least loss.
  double Spread() const;
  bool Flat() const { return Spread() < kFlatProfile; }
};

// The values of a profile: kProfileSteps + 1 over the whole range, evenly spaced in the coordinate,
// and those at kProfileFactors of the centre.
inline constexpr int kProfileSteps = 6;
inline constexpr double kProfileFactors[] = {0.5, 0.8, 1.0, 1.25, 2.0};

// The profile of coordinate i of the space through `centre`. If a point is better than the centre,
// *better (may be null) becomes the best one. Fewer points if the log stops.
Profile ProfileOf(RunLog& log, const SearchSpace& space, int i, const Candidate& centre,
                  Candidate* better);

}  // namespace warplut
