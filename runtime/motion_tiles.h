// Kinds of motion of a tile. Tiles are kTileWidth x kTileHeight pixels from the upper
// left; those at the right and lower edge may be smaller.
#pragma once

#include <cstdint>
#include <vector>

#include "luts/visibility.h"
#include "runtime/image_view.h"

namespace WARPLUT_PUBLIC warplut {

inline constexpr int kTileWidth = 64;
inline constexpr int kTileHeight = 16;

enum class MotionKind : std::uint8_t {
  kStatic,   // zero everywhere
  kWhole,    // one motion everywhere, of whole pixels
  kUniform,  // one motion everywhere
  kGeneral,
};
inline constexpr int kMotionKinds = 4;

constexpr const char* Name(MotionKind kind) {
  switch (kind) {
    case MotionKind::kStatic:
      return "static";
    case MotionKind::kWhole:
      return "whole";
    case MotionKind::kUniform:
      return "uniform";
    case MotionKind::kGeneral:
      return "general";
  }
  return "";
}

// Pixels [x0, x1) x [y0, y1).
struct TileRect {
  int x0, y0, x1, y1;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
};

struct TileMotion {
  MotionKind kind = MotionKind::kGeneral;
  float x = 0;  // the motion, if it is uniform
  float y = 0;
};

// Classifies one tile. Motion with a NaN is general.
TileMotion ClassifyTile(const MotionView& motion, const TileRect& tile);

class MotionTiles {
 public:
  explicit MotionTiles(const MotionView& motion);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const TileMotion& At(int column, int row) const {
    return tiles_[static_cast<std::size_t>(row) * columns_ + column];
  }

 private:
  int columns_;
  int rows_;
  std::vector<TileMotion> tiles_;
};

// The number of tiles along `size` pixels, and the pixels of tile (column, row) of an image.
constexpr int TileCount(int size, int tile) { return (size + tile - 1) / tile; }

inline TileRect TileAt(int column, int row, int width, int height) {
  const int x0 = column * kTileWidth;
  const int y0 = row * kTileHeight;
  return {x0, y0, x0 + kTileWidth < width ? x0 + kTileWidth : width,
          y0 + kTileHeight < height ? y0 + kTileHeight : height};
}

}  // namespace warplut
