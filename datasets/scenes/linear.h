// The vector types of the scenes, and small helpers on them.
//
// World axes: x right, y up, z towards the viewer, metres. Colours are linear RGB.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace warplut::scenes {

using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;
using Vec2d = Eigen::Vector2d;
using Vec3d = Eigen::Vector3d;
using Rgb = Eigen::Array3f;
// Rotation, translation and uniform scale.
using Transform = Eigen::Affine3d;

inline constexpr double kPi = std::numbers::pi;
inline constexpr float kTau = static_cast<float>(2 * kPi);  // a whole turn
inline constexpr double kDegree = kPi / 180;

// The greatest integer not above x, |x| < 2^31.
inline std::int32_t Floor(float x) {
  const auto i = static_cast<std::int32_t>(x);
  return i - (x < static_cast<float>(i) ? 1 : 0);
}

inline float Saturate(float x) { return std::clamp(x, 0.f, 1.f); }

// 0 at and below a, 1 at and above b, cubic between.
inline float SmoothStep(float a, float b, float x) {
  const float t = Saturate((x - a) / (b - a));
  return t * t * (3 - 2 * t);
}

inline Rgb Mix(const Rgb& a, const Rgb& b, float t) { return a + (b - a) * t; }

inline Transform Translate(double x, double y, double z) {
  return Transform(Eigen::Translation3d(x, y, z));
}

// Turns about the y axis, radians, counter-clockwise seen from above.
inline Transform TurnY(double angle) { return Transform(Eigen::AngleAxisd(angle, Vec3d::UnitY())); }

inline Transform Turn(const Vec3d& axis, double angle) {
  return Transform(Eigen::AngleAxisd(angle, axis.normalized()));
}

inline Transform Scale(double s) { return Transform(Eigen::UniformScaling<double>(s)); }

}  // namespace warplut::scenes
