#include "datasets/sequence/camera_fill.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace warplut {
namespace {

using Matrix = std::array<double, 16>;  // row-major

Matrix Product(const Matrix& a, const Matrix& b) {
  Matrix product{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) product[4 * i + j] += a[4 * i + k] * b[4 * k + j];
    }
  }
  return product;
}

// By elimination with pivots; nothing where a pivot vanishes.
std::optional<Matrix> Inverse(Matrix m) {
  Matrix inverse{};
  for (std::size_t i = 0; i < 4; ++i) inverse[5 * i] = 1;
  for (std::size_t c = 0; c < 4; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < 4; ++r) {
      if (std::abs(m[4 * r + c]) > std::abs(m[4 * pivot + c])) pivot = r;
    }
    if (!(std::abs(m[4 * pivot + c]) > 1e-12)) return std::nullopt;
    for (std::size_t k = 0; k < 4; ++k) {
      std::swap(m[4 * pivot + k], m[4 * c + k]);
      std::swap(inverse[4 * pivot + k], inverse[4 * c + k]);
    }
    const double scale = 1 / m[5 * c];
    for (std::size_t k = 0; k < 4; ++k) {
      m[4 * c + k] *= scale;
      inverse[4 * c + k] *= scale;
    }
    for (std::size_t r = 0; r < 4; ++r) {
      const double factor = m[4 * r + c];
      if (r == c || factor == 0) continue;
      for (std::size_t k = 0; k < 4; ++k) {
        m[4 * r + k] -= factor * m[4 * c + k];
        inverse[4 * r + k] -= factor * inverse[4 * c + k];
      }
    }
  }
  return inverse;
}

}  // namespace

CameraStep::CameraStep(const Camera& previous, const Camera& current, int width, int height,
                       Vec2 jitter)
    : at_rest_(previous.view == current.view && previous.projection == current.projection),
      projection_(current.projection),
      previous_projection_(previous.projection),
      width_(width),
      height_(height),
      jitter_(jitter) {
  const auto inverse = Inverse(current.view);
  const Matrix& p = projection_;
  if (!inverse || p[0] == 0 || p[5] == 0 || (p[14] == 0) == (p[15] == 0)) return;
  to_previous_ = Product(previous.view, *inverse);
  valid_ = true;
}

std::optional<Vec2> CameraStep::MotionAt(int x, int y, double view_depth) const {
  const double ndc_x = 2 * (x + 0.5 + jitter_.x) / width_ - 1;
  const double ndc_y = 1 - 2 * (y + 0.5 + jitter_.y) / height_;
  const bool background = !std::isfinite(view_depth);
  const double z = background ? 1 : view_depth;
  const Matrix& p = projection_;
  // Perspective: clip w is the view depth, which is -z of view space. Orthographic: it is 1.
  const double w = p[14] != 0 ? z : 1;
  const std::array<double, 4> view = {(ndc_x * w + p[2] * z - p[3]) / p[0],
                                      (ndc_y * w + p[6] * z - p[7]) / p[5], -z,
                                      background ? 0.0 : 1.0};
  const auto row = [](const Matrix& m, std::size_t r, const std::array<double, 4>& v) {
    return m[4 * r] * v[0] + m[4 * r + 1] * v[1] + m[4 * r + 2] * v[2] + m[4 * r + 3] * v[3];
  };
  std::array<double, 4> before{};
  for (std::size_t r = 0; r < 4; ++r) before[r] = row(to_previous_, r, view);
  const double w_before = row(previous_projection_, 3, before);
  if (!(w_before > 0)) return std::nullopt;
  const double before_x = row(previous_projection_, 0, before) / w_before;
  const double before_y = row(previous_projection_, 1, before) / w_before;
  return Vec2{(ndc_x - before_x) * width_ / 2, (before_y - ndc_y) * height_ / 2};
}

bool MayMissMotion(const Image& motion) {
  for (std::size_t i = 0; i < motion.data.size(); i += 2) {
    const float x = motion.data[i], y = motion.data[i + 1];
    if ((x == 0 && y == 0) || std::isnan(x) || std::isnan(y)) return true;
  }
  return false;
}

std::size_t FillMissingMotion(const CameraStep& step, const Image& depth, double unit,
                              double background, Image* motion) {
  if (!step.Valid() || step.AtRest()) return 0;
  std::size_t filled = 0;
  for (int y = 0; y < motion->height; ++y) {
    for (int x = 0; x < motion->width; ++x) {
      float* m = &motion->at(x, y);
      const double d = depth.at(x, y);
      const bool is_background = d >= background;
      const bool missing =
          std::isnan(m[0]) || std::isnan(m[1]) || (is_background && m[0] == 0 && m[1] == 0);
      if (!missing || std::isnan(d) || d <= 0) continue;
      const double view_depth = is_background ? std::numeric_limits<double>::infinity() : d * unit;
      const auto camera = step.MotionAt(x, y, view_depth);
      if (!camera) continue;
      m[0] = static_cast<float>(camera->x);
      m[1] = static_cast<float>(camera->y);
      ++filled;
    }
  }
  return filled;
}

}  // namespace warplut
