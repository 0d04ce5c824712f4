#include "runtime/motion_tiles.h"

#include "runtime/float_environment.h"
#include "runtime/motion/motion_split.h"
#include "runtime/warp/warp_kernels.h"

namespace warplut {

TileMotion ClassifyTile(const MotionView& motion, const TileRect& tile) {
  const FloatEnvironment environment;
  const float mx = motion.Row(tile.y0)[2 * tile.x0];
  const float my = motion.Row(tile.y0)[2 * tile.x0 + 1];
  if (!IsUniform(motion, tile)) return {};
  if (!IsFinite(mx) || !IsFinite(my)) return {};
  if (mx == 0 && my == 0) return {MotionKind::kStatic, 0, 0};
  const bool whole = SplitMotion(mx).offset == 0 && SplitMotion(my).offset == 0;
  return {whole ? MotionKind::kWhole : MotionKind::kUniform, mx, my};
}

MotionTiles::MotionTiles(const MotionView& motion)
    : columns_(TileCount(motion.width, kTileWidth)), rows_(TileCount(motion.height, kTileHeight)) {
  tiles_.reserve(static_cast<std::size_t>(columns_) * rows_);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      tiles_.push_back(ClassifyTile(motion, TileAt(column, row, motion.width, motion.height)));
    }
  }
}

}  // namespace warplut
