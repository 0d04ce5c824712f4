#include "runtime/peers/rays/screen_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/camera_motion.h"

namespace warplut::peers {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

int PixelOf(double at, int first, int last) {
  return static_cast<int>(
      std::clamp(std::floor(at), static_cast<double>(first), static_cast<double>(last)));
}

}  // namespace

void ClipRay(double from, double by, double low, double high, double& begin, double& end) {
  if (by == 0) {
    if (!(from >= low && from <= high)) end = begin - 1;
    return;
  }
  const auto [first, last] = std::minmax({(low - from) / by, (high - from) / by});
  begin = std::max(begin, first);
  end = std::min(end, last);
}

ScreenRay ScreenRay::Of(const Pinhole& pinhole, const std::array<double, 3>& origin,
                        const std::array<double, 3>& direction, int width, int height) {
  const auto [x, y, z] = origin;
  const auto [dx, dy, dz] = direction;
  ScreenRay ray{{pinhole.cx + pinhole.fx * x / z, pinhole.cy + pinhole.fy * y / z, 1 / z},
                {pinhole.fx * (dx * z - x * dz), pinhole.fy * (dy * z - y * dz), -dz},
                0,
                kInfinity};
  ClipRay(ray.from.x, ray.by.x, 0, width, ray.begin, ray.end);
  ClipRay(ray.from.y, ray.by.y, 0, height, ray.begin, ray.end);
  ClipRay(ray.from.g, ray.by.g, 0, 1 / kLeastDepth, ray.begin, ray.end);
  const bool is_sound = z > 0 && std::isfinite(ray.from.x) && std::isfinite(ray.from.y) &&
                        std::isfinite(ray.from.g) && std::isfinite(ray.by.x) &&
                        std::isfinite(ray.by.y) && std::isfinite(ray.by.g);
  if (!is_sound || !(ray.begin < ray.end) || !std::isfinite(ray.end)) ray.begin = ray.end = 0;
  return ray;
}

Touch TouchOf(const ScreenRay& ray, double first, double last, double g, double thickness) {
  const double front = g, back = g / (1 + thickness), at = ray.InverseAt(first);
  const auto [least, greatest] = std::minmax({at, ray.InverseAt(last)});
  if (!(g > 0) || least > front || greatest < back) return {false, 0};
  if (at >= back && at <= front) return {true, first};
  const double t = ((at > front ? front : back) - ray.from.g) / ray.by.g;
  return {true, std::clamp(t, first, last)};
}

CellWalk::CellWalk(const ScreenRay& ray, int width, int height) : ray_(ray), t_(ray.begin) {
  const ScreenRay::Point p = ray.At(t_);
  x_ = PixelOf(p.x, 0, width - 1);
  y_ = PixelOf(p.y, 0, height - 1);
}

double CellWalk::Border(int pixel, int side, double from, double by) const {
  if (by == 0) return kInfinity;
  const int border = (pixel / side + (by > 0 ? 1 : 0)) * side;
  return std::max(t_, (border - from) / by);
}

double CellWalk::Leaves(int side) const {
  return std::min({Border(x_, side, ray_.from.x, ray_.by.x),
                   Border(y_, side, ray_.from.y, ray_.by.y), ray_.end});
}

void CellWalk::Leave(int side) {
  const double across = Border(x_, side, ray_.from.x, ray_.by.x);
  const double down = Border(y_, side, ray_.from.y, ray_.by.y);
  t_ = std::min({across, down, ray_.end});
  if (IsDone()) return;
  const int left = x_ / side * side, top = y_ / side * side;
  const ScreenRay::Point p = ray_.At(t_);
  if (across <= down) {
    x_ = ray_.by.x > 0 ? left + side : left - 1;
    y_ = PixelOf(p.y, top, top + side - 1);
  } else {
    x_ = PixelOf(p.x, left, left + side - 1);
    y_ = ray_.by.y > 0 ? top + side : top - 1;
  }
}

}  // namespace warplut::peers
