// Where samples alias, and how much smoother the history is updated there.
//
// A sample that is one point of a texture far above the render resolution differs from what it
// should be at random, from pixel to pixel; the residuals of a region show by how much. Where that
// is little, residuals are detail that the history lacks; where it is much, the history does better
// to average.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/core/band.h"

namespace warplut {

// Residuals are judged in tiles of so many samples squared.
inline constexpr int kAliasingTile = kBandRows;

// Standard deviation of residuals (encoded colour, [0, 1]) from which on samples count as aliased,
// and from which on wholly.
inline constexpr float kLeastAliasing = 0.035f;
inline constexpr float kMostAliasing = 0.1f;

// Smoothing where samples are wholly aliased and a sample has to do for `area` output pixels: the
// fewer samples there are, the more the current frame alone blurs.
constexpr float MostSmoothing(float area) { return std::min(0.7f, 2.8f / area); }

// The share of the current frame for smoothing 1.
inline constexpr float kSmoothShare = 0.35f;

// Variance of `count` residuals of three channels, about the mean of each, in the mean of the
// channels; 0 where rounding makes it less.
float ResidualVariance(float sum_of_squares, const float (&sums)[3], int count);

// Smoothing, in [0, MostSmoothing], of every sample of a frame. Variances of tiles, blurred by
// (1, 4, 6, 4, 1) / 16 tiles along each axis, the outermost repeated; their root on a ramp from
// kLeastAliasing to kMostAliasing; bilinear between the centres of tiles.
class AliasingMap {
 public:
  AliasingMap() = default;
  // `area`: output pixels for each sample; `contrast`: CodeContrast of the colours that residuals
  // are differences of.
  AliasingMap(int render_width, int render_height, float area, float contrast = 1);

  // As if made for this size, which has at most as many tiles as that of the constructor.
  void SetSize(int render_width, int render_height, float area);

  // Of the tiles of rows [kAliasingTile tile_row, ...), to be set by whoever made the residuals;
  // threads may set different rows.
  float* Variances(int tile_row) { return &variances_[Index(tile_row, 0)]; }

  // Smoothing from the variances, once all are set. Allocates nothing.
  void Finish();

  // Smoothing of the samples of row j, 0 to render_height - 1, of the last Finish; false and
  // nothing written where it is 0 for all. `row` has room for kAliasingTile floats before sample 0
  // and 2 kAliasingTile after the last one.
  bool FillRow(int j, float* row) const;

  std::size_t bytes() const {
    return (variances_.size() + smoothing_.size()) * sizeof(float) + smooth_rows_.size();
  }

 private:
  std::size_t Index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  float most_smoothing_ = 0;
  float variance_unit_ = 1;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> variances_, smoothing_;
  std::vector<std::uint8_t> smooth_rows_;  // rows of tiles where some smoothing is not 0
};

}  // namespace warplut
