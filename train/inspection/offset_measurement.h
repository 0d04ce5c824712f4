// The translation between two images, found in the images themselves.
#pragma once

#include <cmath>
#include <optional>

#include "train/inspection/points.h"

namespace warplut {

// The offset d, in pixels of `here`, at which there(place(x, y) + scale d) matches here(x, y) best,
// |d| <= kMostOffset in each axis. place(x, y) is in texels of `there` from the centre of its
// first. Gauss-Newton on points of a regular grid, errors weighted by (1 + (e / 0.05)^2)^-2, so
// that what is covered or aliased does not count. Nothing where the images have too little detail
// or the steps do not settle. Source: Lucas, Kanade, "An iterative image registration technique",
// 1981.
inline constexpr double kMostOffset = 2;

template <class Place>
std::optional<Vec2> MeasureOffset(const Image& here, const Image& there, Vec2 scale,
                                  const Place& place) {
  constexpr int kRounds = 12;
  constexpr double kScale = 0.05, kSettled = 1e-3, kLeastDetail = 1e-6;
  Vec2 d;
  for (int round = 0; round < kRounds; ++round) {
    double xx = 0, xy = 0, yy = 0, xe = 0, ye = 0;
    int points = 0;
    ForPoints({here.width, here.height}, [&](int x, int y) {
      const Vec2 base = place(x, y);
      const double at_x = base.x + d.x * scale.x, at_y = base.y + d.y * scale.y;
      const double e = BilinearAt(there, at_x, at_y) - here.at(x, y);
      const double gx =
          (BilinearAt(there, at_x + 1, at_y) - BilinearAt(there, at_x - 1, at_y)) / 2 * scale.x;
      const double gy =
          (BilinearAt(there, at_x, at_y + 1) - BilinearAt(there, at_x, at_y - 1)) / 2 * scale.y;
      if (std::isnan(e + gx + gy)) return;
      const double fall = 1 + e / kScale * (e / kScale);
      const double weight = 1 / (fall * fall);
      xx += weight * gx * gx;
      xy += weight * gx * gy;
      yy += weight * gy * gy;
      xe += weight * gx * e;
      ye += weight * gy * e;
      ++points;
    });
    const double determinant = xx * yy - xy * xy;
    if (points < 100 || !(determinant > kLeastDetail * points * kLeastDetail * points)) {
      return std::nullopt;
    }
    const double step_x = (yy * xe - xy * ye) / determinant;
    const double step_y = (xx * ye - xy * xe) / determinant;
    d.x -= step_x;
    d.y -= step_y;
    if (!(std::abs(d.x) <= kMostOffset && std::abs(d.y) <= kMostOffset)) return std::nullopt;
    if (std::hypot(step_x, step_y) < kSettled) break;
  }
  return d;
}

}  // namespace warplut
