#include "runtime/sr/aliasing.h"

#include <algorithm>
#include <cmath>

namespace warplut {
namespace {

constexpr int kReach = 2;
constexpr float kBinomial[2 * kReach + 1] = {1.0f / 16, 4.0f / 16, 6.0f / 16, 4.0f / 16, 1.0f / 16};

// The blur of value(0), ..., value(count - 1) at k.
template <class Value>
float Blurred(int k, int count, const Value& value) {
  float sum = 0;
  for (int tap = -kReach; tap <= kReach; ++tap) {
    sum += kBinomial[tap + kReach] * value(std::clamp(k + tap, 0, count - 1));
  }
  return sum;
}

// From 0 to 1.
float Ramp(float variance) {
  const float above = (std::sqrt(variance) - kLeastAliasing) / (kMostAliasing - kLeastAliasing);
  return std::clamp(above, 0.0f, 1.0f);
}

}  // namespace

float ResidualVariance(float sum_of_squares, const float (&sums)[3], int count) {
  const float n = static_cast<float>(count);
  const float squared_sums = sums[0] * sums[0] + sums[1] * sums[1] + sums[2] * sums[2];
  return std::max(sum_of_squares - squared_sums / n, 0.0f) / (3 * n);
}

AliasingMap::AliasingMap(int render_width, int render_height, float area, float contrast)
    : most_smoothing_(MostSmoothing(area)),
      variance_unit_(contrast * contrast),
      columns_(TileCount(render_width, kAliasingTile)),
      rows_(TileCount(render_height, kAliasingTile)),
      variances_(Index(rows_, 0)),
      smoothing_(variances_.size()),
      smooth_rows_(static_cast<std::size_t>(rows_)) {}

void AliasingMap::SetSize(int render_width, int render_height, float area) {
  most_smoothing_ = MostSmoothing(area);
  columns_ = TileCount(render_width, kAliasingTile);
  rows_ = TileCount(render_height, kAliasingTile);
}

void AliasingMap::Finish() {
  for (int y = 0; y < rows_; ++y) {
    for (int x = 0; x < columns_; ++x) {
      smoothing_[Index(y, x)] =
          Blurred(x, columns_, [&](int column) { return variances_[Index(y, column)]; });
    }
  }
  std::swap(smoothing_, variances_);
  for (int y = 0; y < rows_; ++y) {
    bool any = false;
    for (int x = 0; x < columns_; ++x) {
      const float variance = Blurred(y, rows_, [&](int row) { return variances_[Index(row, x)]; });
      smoothing_[Index(y, x)] = most_smoothing_ * Ramp(variance / variance_unit_);
      any = any || smoothing_[Index(y, x)] > 0;
    }
    smooth_rows_[static_cast<std::size_t>(y)] = any ? 1 : 0;
  }
}

bool AliasingMap::FillRow(int j, float* row) const {
  constexpr float kTile = kAliasingTile;
  // Between the centres of the rows of tiles `upper` and `upper + 1`.
  const int upper = (j + kAliasingTile / 2) / kAliasingTile - 1;
  const float t =
      (static_cast<float>(j - upper * kAliasingTile - kAliasingTile / 2) + 0.5f) / kTile;
  const int above = std::max(upper, 0);
  const int below = std::min(upper + 1, rows_ - 1);
  if (smooth_rows_[static_cast<std::size_t>(above)] == 0 &&
      smooth_rows_[static_cast<std::size_t>(below)] == 0) {
    return false;
  }
  const auto value = [&](int column) {
    const int inside = std::clamp(column, 0, columns_ - 1);
    const float a = smoothing_[Index(above, inside)];
    return a + t * (smoothing_[Index(below, inside)] - a);
  };
  float left = value(-1);
  for (int column = -1; column < columns_; ++column) {
    const float right = value(column + 1);
    float* tile = row + column * kAliasingTile + kAliasingTile / 2;
    for (int k = 0; k < kAliasingTile; ++k) {
      tile[k] = left + (static_cast<float>(k) + 0.5f) / kTile * (right - left);
    }
    left = right;
  }
  return true;
}

}  // namespace warplut
