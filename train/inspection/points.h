// Pairs of frames, the points at which they are compared, and the errors there.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "train/inspection/inspected_clip.h"
#include "train/inspection/questions.h"

namespace warplut {

// Places in InspectedClip::frames of two neighbouring frames of which the later is no cut.
struct FramePair {
  std::size_t earlier, later;
};

inline std::vector<FramePair> UsablePairs(const InspectedClip& clip) {
  std::vector<FramePair> pairs;
  for (std::size_t i = 1; i < clip.frames.size(); ++i) {
    const InspectedFrame& later = clip.frames[i];
    const InspectedFrame& earlier = clip.frames[i - 1];
    if (!later.Follows(earlier) || later.luma.empty() || earlier.luma.empty()) continue;
    pairs.push_back({i - 1, i});
  }
  return pairs;
}

// The offset of the frame at `index`, (0, 0) without jitter.
inline Vec2 JitterAt(const std::vector<Vec2>& cycle, int index) {
  return cycle.empty() ? Vec2{} : cycle[static_cast<std::size_t>(index) % cycle.size()];
}

// The upper of the two in the middle; 0 of nothing.
inline double Median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// point(x, y) at about kQuestionPoints pixels of the grid, in a fixed order.
template <class Point>
void ForPoints(GridSize grid, const Point& point) {
  const double pixels = static_cast<double>(grid.width) * grid.height;
  const int step = std::max(1, static_cast<int>(std::sqrt(pixels / kQuestionPoints)));
  for (int y = step / 2; y < grid.height; y += step) {
    for (int x = step / 2; x < grid.width; x += step) point(x, y);
  }
}

inline constexpr std::size_t kFewestPairs = 8;
inline constexpr int kTiles = 4;  // in each axis

// Truncated squared errors of a pair, by tiles of the image.
struct PairCost {
  std::array<double, kTiles * kTiles> sum{};
  std::array<int, kTiles * kTiles> count{};

  // `error` NaN: an outlier.
  void Add(int x, int y, GridSize grid, float error) {
    constexpr float kMost = static_cast<float>(kOutlier * kOutlier);
    const float squared = error * error;
    const auto tile =
        static_cast<std::size_t>(y * kTiles / grid.height * kTiles + x * kTiles / grid.width);
    sum[tile] += squared < kMost ? squared : kMost;
    ++count[tile];
  }

  // NaN without points.
  double Mean() const {
    double total = 0;
    int points = 0;
    for (std::size_t tile = 0; tile < sum.size(); ++tile) {
      total += sum[tile];
      points += count[tile];
    }
    return points == 0 ? std::nan("") : total / points;
  }
};

// The squared error that counts as none: a tenth of an 8-bit code.
inline double Decibels(double squared_error) {
  constexpr double kLeast = 1.5e-7;
  return -10 * std::log10(squared_error + kLeast);
}

inline SampleScores ScoresOf(const std::vector<PairCost>& costs, bool tiled) {
  SampleScores scores;
  for (const PairCost& cost : costs) {
    if (!tiled) {
      scores.push_back(Decibels(cost.Mean()));
      continue;
    }
    for (std::size_t tile = 0; tile < cost.sum.size(); ++tile) {
      scores.push_back(cost.count[tile] == 0 ? std::nan("")
                                             : Decibels(cost.sum[tile] / cost.count[tile]));
    }
  }
  return scores;
}

}  // namespace warplut
