// The samples of one rendered frame on an output image: the linear maps by which they refresh it.
//
// Sample (i, j) of the render grid lies at output position ((i + 1/2 + jitter_x) s, (j + 1/2 +
// jitter_y) s), s the upscale factor, pixel centres at + 1/2. With h the warped history and S the
// samples, the frame enters in the residual form of runtime/super_resolution.h:
//
//   x = h + share (I (S - B h))
//
//   I      bilinear interpolation of the samples at the pixel centres
//   B      Catmull-Rom reading of an image at the samples' positions
//   share  BlendShare(a, SampleWeight(b, d)), d the distance from the pixel centre to the nearest
//          sample, in render pixels (runtime/gates.h)
//
// Positions outside the grid or the image are moved to its edge before interpolation.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "datasets/frame.h"
#include "luts/contract.h"
#include "train/fit/rollout/stencil.h"

namespace warplut {

// What is the same for every frame of a rollout. The share's parameters are those of
// runtime/parameters.h.
struct SampleGridOptions {
  int width = 0;  // of the output image
  int height = 0;
  double scale = 2;  // output / render
  double blend_a = 0;
  double blend_b = 0;
};

// Two neighbours and the share of the second, for every position of one axis.
struct LinearTaps {
  std::vector<int> first;
  std::vector<float> fraction;  // in [0, 1]
};

// Four neighbours, those beyond the edge moved to it, and their weights, for every position of one
// axis.
struct CubicTaps {
  std::vector<std::array<int, kTaps>> index;
  std::vector<std::array<float, kTaps>> weight;
};

// Immutable; serves any number of threads.
class SampleGrid {
 public:
  // Enough samples to cover the image: ceil(width / scale) columns, ceil(height / scale) rows, at
  // least two of each (not checked).
  SampleGrid(const SampleGridOptions& options, const Vec2& jitter);

  int columns() const { return static_cast<int>(sample_x_.index.size()); }
  int rows() const { return static_cast<int>(sample_y_.index.size()); }

  // Output position of a column (row) of samples, in pixels.
  double PositionX(int column) const { return (column + 0.5 + jitter_.x) * options_.scale; }
  double PositionY(int row) const { return (row + 0.5 + jitter_.y) * options_.scale; }

  // `share` at pixel (x, y).
  float Share(int x, int y) const {
    return share_[static_cast<std::size_t>(y) * options_.width + x];
  }

  // out = I samples; `samples` has rows() rows of columns() values. The border of `out` is kept.
  void Interpolate(std::span<const float> samples, BorderedPlane& out) const;

  // samples = B image.
  void Read(const BorderedPlane& image, std::span<float> samples) const;

  // out = history + share (I (samples - B history)). The border of `out` is kept; `out` is another
  // plane than `history`.
  void Refresh(std::span<const float> samples, const BorderedPlane& history,
               BorderedPlane& out) const;

  // The adjoint of Refresh with respect to `history`: gradient = gradient - B' I' (share gradient).
  // Inside the image; the border is kept.
  void AdjointRefresh(BorderedPlane& gradient) const;

 private:
  SampleGridOptions options_;
  Vec2 jitter_;
  LinearTaps pixel_x_, pixel_y_;   // samples around each pixel centre
  CubicTaps sample_x_, sample_y_;  // pixels around each sample
  std::vector<float> share_;
};

}  // namespace warplut
