#include "train/calibration/tile_grid.h"

#include <algorithm>

namespace warplut {

TileGrid::TileGrid(int width, int height)
    : map_width_(width - kSsimWindow + 1), map_height_(height - kSsimWindow + 1) {
  const int side =
      std::clamp(std::min(map_width_, map_height_) / kTilesAcross, kMinTileSide, kMaxTileSide);
  columns_ = std::max(1, map_width_ / side);
  rows_ = std::max(1, map_height_ / side);
}

TileGrid::Span TileGrid::Column(int tile) const {
  const int i = tile % columns_;
  const int begin = i * map_width_ / columns_;
  return {begin, (i + 1) * map_width_ / columns_ - begin};
}

TileGrid::Span TileGrid::Row(int tile) const {
  const int j = tile / columns_;
  const int begin = j * map_height_ / rows_;
  return {begin, (j + 1) * map_height_ / rows_ - begin};
}

double TileGrid::Share(int tile) const {
  return static_cast<double>(Column(tile).size) * Row(tile).size /
         (static_cast<double>(map_width_) * map_height_);
}

PlaneView TileGrid::Window(const PlaneView& image, int tile) const {
  const Span column = Column(tile), row = Row(tile);
  return {image.data + row.begin * image.stride + column.begin, column.size + kSsimWindow - 1,
          row.size + kSsimWindow - 1, image.stride};
}

}  // namespace warplut
