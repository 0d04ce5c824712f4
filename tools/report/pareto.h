// Choices of which one is better in nothing and worse in something.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace warplut {

// Less is better in both.
struct CostPoint {
  double time = 0;
  double error = 0;
};

// For each point, the index of one that dominates it: no slower and no worse, and better in one of
// the two; of several the one with the least error, and then the least time. Nothing for points
// that are on the front, and for those that are not finite.
inline std::vector<std::optional<std::size_t>> Dominators(const std::vector<CostPoint>& points) {
  const auto dominates = [](const CostPoint& a, const CostPoint& b) {
    return a.time <= b.time && a.error <= b.error && (a.time < b.time || a.error < b.error);
  };
  std::vector<std::optional<std::size_t>> dominators(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].time) || !std::isfinite(points[i].error)) continue;
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (!dominates(points[j], points[i])) continue;
      std::optional<std::size_t>& best = dominators[i];
      if (!best || points[j].error < points[*best].error ||
          (points[j].error == points[*best].error && points[j].time < points[*best].time)) {
        best = j;
      }
    }
  }
  return dominators;
}

}  // namespace warplut
