#include "luts/quantize/row_closure.h"

#include <cmath>
#include <limits>

namespace warplut {

bool RoundToSum(std::int32_t total, const RoundingGrid& grid, std::vector<RoundingTerm>* terms) {
  // best[i][reach + s]: the least cost of the first i terms when their steps add up to s.
  std::vector<int> steps = {0};
  for (int s = 1; s <= grid.most_step; ++s) steps.insert(steps.end(), {s, -s});
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const int n = static_cast<int>(terms->size());
  std::int64_t rest = total;
  int reach = 0;
  for (const RoundingTerm& term : *terms) {
    rest -= term.count * std::llround(term.value);
    reach += term.count * grid.most_step;
  }
  if (rest < -reach || rest > reach) return false;

  const int width = 2 * reach + 1;
  std::vector<double> best(static_cast<std::size_t>(n + 1) * width, kNone);
  std::vector<int> step(static_cast<std::size_t>(n + 1) * width, 0);
  best[reach] = 0;
  for (int i = 0; i < n; ++i) {
    const RoundingTerm& term = (*terms)[i];
    const auto nearest = static_cast<std::int32_t>(std::llround(term.value));
    for (const int s : steps) {
      if (!grid.Has(nearest + s)) continue;
      const double cost = term.count * std::abs(nearest + s - term.value);
      for (int from = 0; from < width; ++from) {
        const int to = from + term.count * s;
        if (to < 0 || to >= width || best[i * width + from] == kNone) continue;
        const double sum = best[i * width + from] + cost;
        if (sum < best[(i + 1) * width + to]) {
          best[(i + 1) * width + to] = sum;
          step[(i + 1) * width + to] = s;
        }
      }
    }
  }

  int at = reach + static_cast<int>(rest);
  if (best[n * width + at] == kNone) return false;
  for (int i = n - 1; i >= 0; --i) {
    RoundingTerm& term = (*terms)[i];
    const int s = step[(i + 1) * width + at];
    term.rounded = static_cast<std::int32_t>(std::llround(term.value)) + s;
    at -= term.count * s;
  }
  return true;
}

}  // namespace warplut
