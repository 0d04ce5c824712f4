// The tiles whose losses a calibration tells apart.
#pragma once

#include "train/metrics/ssim.h"

namespace warplut {

// About as many along the shorter side of the SSIM map, within the limits of a tile's side.
inline constexpr int kTilesAcross = 8;
inline constexpr int kMinTileSide = 16;
inline constexpr int kMaxTileSide = 128;

// Splits the SSIM map of a width x height image (train/metrics/ssim.h: smaller by the window) into
// tiles of nearly one size, row by row. The window of a tile is the part of the image that its
// SSIMs look at: windows overlap, the tiles themselves do not.
class TileGrid {
 public:
  // Both at least kSsimWindow (not checked).
  TileGrid(int width, int height);

  int count() const { return columns_ * rows_; }

  // Share of the tile in the map's pixels; they sum to 1.
  double Share(int tile) const;

  PlaneView Window(const PlaneView& image, int tile) const;

 private:
  struct Span {
    int begin = 0, size = 0;
  };
  Span Column(int tile) const;
  Span Row(int tile) const;

  int map_width_, map_height_;
  int columns_, rows_;
};

}  // namespace warplut
