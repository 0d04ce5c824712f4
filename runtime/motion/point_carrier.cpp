#include "runtime/motion/point_carrier.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "runtime/core/image_check.h"
#include "runtime/float_environment.h"

namespace warplut {
namespace {

using Matrix3 = std::array<double, 9>;
using Vector3 = std::array<double, 3>;

// The matrix of four rows whose last is (0, 0, 0, 1).
struct Affine {
  Matrix3 a{1, 0, 0, 0, 1, 0, 0, 0, 1};
  Vector3 b{};
};

Vector3 Times(const Matrix3& m, const Vector3& v) {
  Vector3 product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) product[i] += m[3 * i + k] * v[k];
  }
  return product;
}

Matrix3 Times(const Matrix3& m, const Matrix3& n) {
  Matrix3 product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) product[3 * i + j] += m[3 * i + k] * n[3 * k + j];
    }
  }
  return product;
}

Matrix3 Transposed(const Matrix3& m) {
  return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]};
}

Affine operator*(const Affine& m, const Affine& n) {
  Affine product{Times(m.a, n.a), Times(m.a, n.b)};
  for (std::size_t i = 0; i < 3; ++i) product.b[i] += m.b[i];
  return product;
}

// By cofactors; entries that are not finite where there is none.
Matrix3 Inverse(const Matrix3& m) {
  const auto minor = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return m[a] * m[d] - m[b] * m[c];
  };
  const Matrix3 cofactors = {minor(4, 5, 7, 8), minor(2, 1, 8, 7), minor(1, 2, 4, 5),
                             minor(5, 3, 8, 6), minor(0, 2, 6, 8), minor(2, 0, 5, 3),
                             minor(3, 4, 6, 7), minor(1, 0, 7, 6), minor(0, 1, 3, 4)};
  const double determinant = m[0] * cofactors[0] + m[1] * cofactors[3] + m[2] * cofactors[6];
  Matrix3 inverse{};
  for (std::size_t i = 0; i < 9; ++i) inverse[i] = cofactors[i] / determinant;
  return inverse;
}

Affine Inverse(const Affine& m) {
  const Matrix3 a = Inverse(m.a);
  Vector3 b = Times(a, m.b);
  for (double& v : b) v = -v;
  return {a, b};
}

Affine ViewOf(const CameraMatrices& camera, double unit) {
  const auto& v = camera.view;
  return {{v[0], v[1], v[2], v[4], v[5], v[6], v[8], v[9], v[10]},
          {v[3] / unit, v[7] / unit, v[11] / unit}};
}

// From (x, y, z, 1) / depth in view space to (x, y, 1, 1 / depth) with x and y in pixels.
Affine PixelsOf(const CameraMatrices& camera, double unit, int width, int height) {
  const auto& p = camera.projection;
  const double half_width = width / 2.0, half_height = height / 2.0;
  Affine pixels;
  for (std::size_t k = 0; k < 4; ++k) {
    const double scale = k == 3 ? 1 / unit : 1;
    const double w = p[12 + k] * scale;
    const double x = half_width * (p[k] * scale + w) - 0.5 * w;
    const double y = half_height * (w - p[4 + k] * scale) - 0.5 * w;
    if (k == 3) {
      pixels.b = {x, y, w};
      continue;
    }
    pixels.a[k] = x;
    pixels.a[3 + k] = y;
    pixels.a[6 + k] = w;
  }
  return pixels;
}

PointMap MapOf(const Affine& m) {
  PointMap map;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t k = 0; k < 3; ++k) map.m[4 * r + k] = static_cast<float>(m.a[3 * r + k]);
    map.m[4 * r + 3] = static_cast<float>(m.b[r]);
  }
  return map;
}

bool IsFiniteMap(const PointMap& map) {
  return std::all_of(map.m.begin(), map.m.end(), [](float v) { return std::isfinite(v); });
}

// exp(t log R) of a rotation R.
Matrix3 Turned(const Matrix3& r, double t) {
  const Vector3 axis = {r[7] - r[5], r[2] - r[6], r[3] - r[1]};
  const double twice_sine = std::hypot(axis[0], axis[1], axis[2]);
  if (!(twice_sine > 1e-12)) return Affine().a;
  const double angle = t * std::atan2(twice_sine, r[0] + r[4] + r[8] - 1);
  const double x = axis[0] / twice_sine, y = axis[1] / twice_sine, z = axis[2] / twice_sine;
  const double c = std::cos(angle), s = std::sin(angle), v = 1 - c;
  return {c + x * x * v,     x * y * v - z * s, x * z * v + y * s, y * x * v + z * s, c + y * y * v,
          y * z * v - x * s, z * x * v - y * s, z * y * v + x * s, c + z * z * v};
}

}  // namespace

bool CameraMatrices::IsValid(std::string* why) const {
  constexpr double kSlack = 1e-3;
  const auto finite = [](double v) { return std::isfinite(v); };
  if (!std::all_of(view.begin(), view.end(), finite) ||
      !std::all_of(projection.begin(), projection.end(), finite)) {
    return Refuse({"A camera matrix has an entry that is not finite; expected numbers."}, why);
  }
  const auto& p = projection;
  if (p[12] != 0 || p[13] != 0 || std::abs(p[14] + 1) > 1e-6 || p[15] != 0 || p[0] == 0 ||
      p[5] == 0) {
    return Refuse({"The projection of a camera is not perspective; expected w = -z."}, why);
  }
  const Matrix3 rotation = ViewOf(*this, 1).a;
  const Matrix3 unit = Times(rotation, Transposed(rotation));
  for (std::size_t i = 0; i < 9; ++i) {
    if (std::abs(unit[i] - (i % 4 == 0 ? 1 : 0)) > kSlack) {
      return Refuse({"The view of a camera scales; expected a rotation and a shift."}, why);
    }
  }
  return true;
}

CameraMatrices CameraBetween(const CameraMatrices& from, const CameraMatrices& to, double time) {
  const Affine a = ViewOf(from, 1), b = ViewOf(to, 1);
  const Vector3 place_a = Inverse(a).b, place_b = Inverse(b).b;
  const Matrix3 rotation = Times(Turned(Times(b.a, Transposed(a.a)), time), a.a);
  Vector3 place{};
  for (std::size_t i = 0; i < 3; ++i) place[i] = place_a[i] + time * (place_b[i] - place_a[i]);
  const Vector3 shift = Times(rotation, place);
  CameraMatrices between;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t k = 0; k < 3; ++k) between.view[4 * r + k] = rotation[3 * r + k];
    between.view[4 * r + 3] = -shift[r];
  }
  between.view[15] = 1;
  for (std::size_t i = 0; i < 16; ++i) {
    between.projection[i] = from.projection[i] + time * (to.projection[i] - from.projection[i]);
  }
  return between;
}

std::optional<PointCarrier> PointCarrier::Of(const Reprojection& reprojection, int width,
                                             int height) {
  const double unit = reprojection.depth_unit;
  if (!(unit > 0) || !std::isfinite(unit)) return std::nullopt;
  if (!reprojection.source.IsValid() || !reprojection.generated.IsValid()) return std::nullopt;
  const Affine source =
      PixelsOf(reprojection.source, unit, width, height) * ViewOf(reprojection.source, unit);
  const Affine generated =
      PixelsOf(reprojection.generated, unit, width, height) * ViewOf(reprojection.generated, unit);
  const PointCarrier carrier = {MapOf(generated * Inverse(source)),
                                MapOf(source * Inverse(generated))};
  if (!IsFiniteMap(carrier.forward) || !IsFiniteMap(carrier.backward)) return std::nullopt;
  return carrier;
}

int Overscan(const Reprojection& reprojection, int width, int height, double nearest) {
  const FloatEnvironment environment;
  const auto carrier = PointCarrier::Of(reprojection, width, height);
  if (!carrier) return kMostOverscan;
  double most = 0;
  const auto visit = [&](float x, float y) {
    for (const double g : {0.0, 1 / nearest}) {
      const PointMap::Point p = carrier->backward.Apply(x, y, static_cast<float>(g));
      const double distance =
          p.w > 0 ? std::max(std::abs(p.x - x), std::abs(p.y - y)) : double{kMostOverscan};
      most = std::max(most, distance);
    }
  };
  const float right = static_cast<float>(width) - 0.5f, bottom = static_cast<float>(height) - 0.5f;
  for (int x = 0; x <= width; ++x) {
    visit(static_cast<float>(x) - 0.5f, -0.5f);
    visit(static_cast<float>(x) - 0.5f, bottom);
  }
  for (int y = 0; y <= height; ++y) {
    visit(-0.5f, static_cast<float>(y) - 0.5f);
    visit(right, static_cast<float>(y) - 0.5f);
  }
  return static_cast<int>(std::min(std::ceil(most), double{kMostOverscan}));
}

}  // namespace warplut
