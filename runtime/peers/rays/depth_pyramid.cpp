#include "runtime/peers/rays/depth_pyramid.h"

#include <algorithm>

#include "runtime/camera_motion.h"

namespace warplut::peers {

DepthPyramid::DepthPyramid(const ImageView& depth) {
  Level pixels{depth.width, depth.height, {}};
  for (int y = 0; y < depth.height; ++y) {
    const float* row = depth.Row<float>(y);
    for (int x = 0; x < depth.width; ++x) pixels.nearest.push_back(InverseDepth(row[x]));
  }
  levels_.push_back(std::move(pixels));
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level& finer = levels_.back();
    Level level{(finer.width + 1) / 2, (finer.height + 1) / 2, {}};
    for (int y = 0; y < level.height; ++y) {
      const int below = std::min(2 * y + 1, finer.height - 1);
      for (int x = 0; x < level.width; ++x) {
        const int right = std::min(2 * x + 1, finer.width - 1);
        level.nearest.push_back(std::max({finer.At(2 * x, 2 * y), finer.At(right, 2 * y),
                                          finer.At(2 * x, below), finer.At(right, below)}));
      }
    }
    levels_.push_back(std::move(level));
  }
}

ScreenHit DepthPyramid::March(const ScreenRay& ray, double thickness, int top) const {
  ScreenHit hit;
  if (ray.IsEmpty()) return hit;
  int level = 0;
  for (CellWalk walk(ray, width(), height()); !walk.IsDone();) {
    ++hit.cells;
    const int side = 1 << level;
    const double leaves = walk.Leaves(side);
    const double nearest = InverseDepthAt(level, walk.x() >> level, walk.y() >> level);
    const double least = std::min(ray.InverseAt(walk.t()), ray.InverseAt(leaves));
    if (nearest == 0 || least > nearest) {
      walk.Leave(side);
      level = std::min({level + 1, top, this->top()});
    } else if (level > 0) {
      --level;
    } else {
      const Touch touch = TouchOf(ray, walk.t(), leaves, nearest, thickness);
      if (touch.is_touched) {
        hit.Take(ray, touch.t);
        return hit;
      }
      walk.Leave(side);
    }
  }
  return hit;
}

ScreenHit DepthPyramid::MarchReference(const ScreenRay& ray, double thickness) const {
  ScreenHit hit;
  if (ray.IsEmpty()) return hit;
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) {
      double first = ray.begin, last = ray.end;
      ++hit.cells;
      ClipRay(ray.from.x, ray.by.x, x, x + 1, first, last);
      ClipRay(ray.from.y, ray.by.y, y, y + 1, first, last);
      if (first > last) continue;
      const Touch touch = TouchOf(ray, first, last, InverseDepthAt(0, x, y), thickness);
      if (touch.is_touched && (!hit.is_hit || touch.t < hit.t)) hit.Take(ray, touch.t);
    }
  }
  return hit;
}

}  // namespace warplut::peers
