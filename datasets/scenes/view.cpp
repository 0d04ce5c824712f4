#include "datasets/scenes/view.h"

namespace warplut::scenes {

View LookAt(const Vec3d& eye, const Vec3d& target, double fov_y_degrees, double roll) {
  View view;
  view.eye = eye;
  view.fov_y = fov_y_degrees * kDegree;
  const Vec3d back = (eye - target).normalized();
  const Vec3d right = Vec3d::UnitY().cross(back).normalized();
  const Vec3d up = back.cross(right);
  view.axes.col(0) = std::cos(roll) * right + std::sin(roll) * up;
  view.axes.col(1) = std::cos(roll) * up - std::sin(roll) * right;
  view.axes.col(2) = back;
  return view;
}

Lens::Lens(const View& view, double aspect, double near_plane, double far_plane)
    : view_(view),
      tan_x_(aspect * std::tan(view.fov_y / 2)),
      tan_y_(std::tan(view.fov_y / 2)),
      near_(near_plane),
      far_(far_plane) {}

Vec3d Lens::Direction(const Vec2d& position) const {
  const Vec3d local((2 * position.x() - 1) * tan_x_, (1 - 2 * position.y()) * tan_y_, -1);
  return (view_.axes * local).normalized();
}

Vec3d Lens::ToView(const Vec3d& offset) const {
  return Vec3d(1, -1, -1).cwiseProduct(view_.axes.transpose() * offset);
}

double Lens::Depth(const Vec3d& point) const { return -view_.axes.col(2).dot(point - view_.eye); }

std::optional<Vec2d> Lens::ProjectFromEye(const Vec3d& offset) const {
  const Vec3d local = view_.axes.transpose() * offset;
  const double depth = -local.z();
  if (depth <= 1e-6 * offset.norm()) return std::nullopt;
  return Vec2d(0.5 + 0.5 * local.x() / (depth * tan_x_), 0.5 - 0.5 * local.y() / (depth * tan_y_));
}

Camera Lens::Matrices() const {
  Camera camera;
  const Vec3d shift = -(view_.axes.transpose() * view_.eye);
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) camera.view[row * 4 + col] = view_.axes(col, row);
    camera.view[row * 4 + 3] = shift[row];
  }
  camera.view[15] = 1;
  camera.projection[0] = 1 / tan_x_;
  camera.projection[5] = 1 / tan_y_;
  camera.projection[10] = -(far_ + near_) / (far_ - near_);
  camera.projection[11] = -2 * far_ * near_ / (far_ - near_);
  camera.projection[14] = -1;
  return camera;
}

}  // namespace warplut::scenes
