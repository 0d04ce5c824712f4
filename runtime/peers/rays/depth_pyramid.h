// A ray against the pixels of a depth image, by mip-maps of the least depth (docs/METHODS.md).
//
// Level 0 has the inverse depth of each pixel, 0 where depth is NaN, negative or infinite. Each
// further level halves the size, rounded up, and keeps the nearest of 2 x 2: the greatest inverse
// depth. The last level has one texel. Each pixel is a surface that fills the depths from its own
// to (1 + thickness) times that. Source: Uludag, "Hi-Z Screen-Space Cone-Traced Reflections", GPU
// Pro 5, 2014.
#pragma once

#include <vector>

#include "runtime/image_view.h"
#include "runtime/peers/rays/screen_ray.h"

namespace warplut::peers {

class DepthPyramid {
 public:
  // `depth` is R32F and not empty.
  explicit DepthPyramid(const ImageView& depth);

  // Level l, cell after cell: while the ray is in front of all that a cell holds, it goes on behind
  // the cell, a level up, at most `top`. Else it goes a level down; on level 0 it has hit, or goes
  // on behind the pixel. top = 0 walks from pixel to pixel. thickness >= 0; infinity is allowed. A
  // ray that begins in a surface hits it at once.
  ScreenHit March(const ScreenRay& ray, double thickness, int top) const;
  // The first touch among those of all pixels: the same, but for rounding where a ray passes the
  // corner of a pixel.
  ScreenHit MarchReference(const ScreenRay& ray, double thickness) const;

  int width() const { return levels_.front().width; }
  int height() const { return levels_.front().height; }
  int top() const { return static_cast<int>(levels_.size()) - 1; }
  float InverseDepthAt(int level, int x, int y) const { return levels_[level].At(x, y); }

 private:
  struct Level {
    int width, height;
    std::vector<float> nearest;

    float At(int x, int y) const {
      return nearest[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)];
    }
  };
  std::vector<Level> levels_;
};

}  // namespace warplut::peers
