#include "train/fit/rollout/trajectory.h"

#include <numeric>

#include "luts/contract.h"
#include "train/fit/random.h"

namespace warplut {
namespace {

// A component on the grid: a displacement of `fraction` / steps whose whole part keeps |sum| below
// one pixel.
int Step(int fraction, int steps, int sum) {
  if (fraction == 0) return 0;
  return sum > 0 || (sum == 0 && fraction > steps / 2) ? fraction - steps : fraction;
}

struct Pan {
  int x = 0, y = 0;  // in 1 / steps of a pixel
  int steps = 1;
};

// The offset of a random node, which returns after kNodes warps.
Pan NodePan(int steps, Random& random) {
  const int node = steps / kNodes;
  const int x = random.Below(kNodes) * node;
  return {.x = x, .y = random.Below(kNodes) * node, .steps = steps};
}

// Any fractions that return after `warps` warps, but for (0, 0).
Pan FreePan(int warps, Random& random) {
  Pan pan{.steps = warps};
  while (pan.x == 0 && pan.y == 0) {
    pan.x = random.Below(warps);
    pan.y = random.Below(warps);
  }
  return pan;
}

int CommonDivisor(std::span<const int> horizons) {
  int divisor = 0;
  for (const int horizon : horizons) divisor = std::gcd(divisor, horizon);
  return divisor;
}

}  // namespace

std::vector<Displacement> MakeTrajectory(Offsets offsets, std::span<const int> horizons, int steps,
                                         std::uint64_t seed) {
  std::vector<Displacement> trajectory;
  trajectory.reserve(horizons.back());
  Random random(seed);
  Pan pan = NodePan(steps, random);
  if (offsets == Offsets::kPan) {
    const int divisor = CommonDivisor(horizons);
    if (divisor % kNodes != 0) pan = FreePan(divisor, random);
    steps = pan.steps;
  }
  int sum_x = 0;  // in 1 / steps of a pixel
  int sum_y = 0;
  for (const int horizon : horizons) {
    while (static_cast<int>(trajectory.size()) < horizon) {
      const bool last = static_cast<int>(trajectory.size()) + 1 == horizon;
      int x = 0;
      int y = 0;
      if (offsets == Offsets::kHalf) {
        x = y = sum_x == 0 ? steps / 2 : -steps / 2;
      } else if (offsets == Offsets::kPan) {
        x = Step(pan.x, steps, sum_x);
        y = Step(pan.y, steps, sum_y);
      } else if (last) {
        x = -sum_x;
        y = -sum_y;
      } else {
        x = Step(random.Below(steps), steps, sum_x);
        y = Step(random.Below(steps), steps, sum_y);
      }
      sum_x += x;
      sum_y += y;
      trajectory.push_back({static_cast<double>(x) / steps, static_cast<double>(y) / steps});
    }
  }
  return trajectory;
}

}  // namespace warplut
