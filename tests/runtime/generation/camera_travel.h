// A rigid scene under a camera whose travel is known.
#pragma once

#include <algorithm>
#include <array>

#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {

// A camera above a ground, before a wall: x right, y down, z ahead. It travels and turns with a
// constant acceleration; `turn` is in radians for each frame.
struct Travel {
  static constexpr int kWidth = 160, kHeight = 96;
  static constexpr double kFocal = 120;  // pixels
  static constexpr double kFar = 100;
  using Point = std::array<double, 3>;

  double speed = 0.8, acceleration = 0.02, turn = 0.006;

  Point Position(double t) const { return {0.1 * t, 0, speed * t + 0.5 * acceleration * t * t}; }
  double Heading(double t) const { return turn * t; }

  Point ToWorld(const Point& p, double t) const {
    const double c = std::cos(Heading(t)), s = std::sin(Heading(t));
    const Point at = Position(t);
    return {c * p[0] + s * p[2] + at[0], p[1] + at[1], c * p[2] - s * p[0] + at[2]};
  }
  Point ToCamera(const Point& p, double t) const {
    const double c = std::cos(Heading(t)), s = std::sin(Heading(t));
    const Point at = Position(t);
    const Point d = {p[0] - at[0], p[1] - at[1], p[2] - at[2]};
    return {c * d[0] - s * d[2], d[1], s * d[0] + c * d[2]};
  }

  // Where the ray through a pixel of frame t meets ground (y = 1.5) or wall (z = 30).
  Point Seen(int x, int y, double t) const {
    const Point through = {(x + 0.5 - kWidth / 2.0) / kFocal, (y + 0.5 - 20) / kFocal, 1};
    const Point at = Position(t), to = ToWorld(through, t);
    const Point ray = {to[0] - at[0], to[1] - at[1], to[2] - at[2]};
    double reach = (30 - at[2]) / ray[2];
    if (ray[1] > 0) reach = std::min(reach, (1.5 - at[1]) / ray[1]);
    return {at[0] + reach * ray[0], at[1] + reach * ray[1], at[2] + reach * ray[2]};
  }
  // The position of a point of the world in frame t.
  std::array<double, 2> Pixel(const Point& world, double t) const {
    const Point p = ToCamera(world, t);
    return {kFocal * p[0] / p[2] + kWidth / 2.0, kFocal * p[1] / p[2] + 20};
  }

  // Black, with depth and motion.
  TestFrame Frame(double t, PixelFormat format = PixelFormat::kRgba8) const {
    TestFrame frame(kWidth, kHeight, format);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const Point world = Seen(x, y, t);
        const auto before = Pixel(world, t - 1);
        frame.depth.Set(x, y, 0, static_cast<float>(ToCamera(world, t)[2] / kFar));
        frame.motion.Set(x, y, static_cast<float>(x + 0.5 - before[0]),
                         static_cast<float>(y + 0.5 - before[1]));
      }
    }
    return frame;
  }
};

}  // namespace warplut::generation
