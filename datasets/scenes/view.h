// The camera of the scenes: a pinhole, its rays, its projection and its matrices.
#pragma once

#include <optional>

#include "datasets/frame.h"
#include "datasets/scenes/linear.h"

namespace warplut::scenes {

// Where the camera is: the columns of axes are its right, up and backward directions in the world.
struct View {
  Vec3d eye = Vec3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  double fov_y = 60 * kDegree;  // full vertical angle, radians
};

View LookAt(const Vec3d& eye, const Vec3d& target, double fov_y_degrees, double roll = 0);

// A view with an image: positions are (u, v) in [0, 1]^2, u right, v down, whatever the grid.
class Lens {
 public:
  // aspect: width / height of the image.
  Lens(const View& view, double aspect, double near_plane, double far_plane);

  const Vec3d& eye() const { return view_.eye; }
  // Unit direction in the world through the position.
  Vec3d Direction(const Vec2d& position) const;
  // A world direction, or the offset of a world point from the eye, in view space: x right, y down,
  // z along the viewing axis.
  Vec3d ToView(const Vec3d& offset) const;
  // View depth of a world point: distance along the viewing axis.
  double Depth(const Vec3d& point) const;
  // Where a world point, or a point at infinity in a world direction, projects; nothing when it is
  // not in front of the camera.
  std::optional<Vec2d> Project(const Vec3d& point) const {
    return ProjectFromEye(point - view_.eye);
  }
  std::optional<Vec2d> ProjectFromEye(const Vec3d& offset) const;
  // Row-major OpenGL matrices, as datasets/frame.h.
  Camera Matrices() const;
  // Angle of one of `rows` pixels at the centre of the image, radians.
  double PixelAngle(int rows) const { return 2 * tan_y_ / rows; }

 private:
  View view_;
  double tan_x_, tan_y_;
  double near_, far_;
};

}  // namespace warplut::scenes
