#include "runtime/motion/point_carrier.h"

#include <gtest/gtest.h>

#include "tests/runtime/peers/test_camera.h"

namespace warplut {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;
constexpr double kUnit = 50;

struct Seen {
  double x, y, depth;
};

// Where a point of the scene is seen, in pixels from the centre of the first.
Seen See(const CameraMatrices& camera, const std::array<double, 3>& point) {
  const auto row = [&](const std::array<double, 16>& m, std::size_t r,
                       const std::array<double, 4>& v) {
    return m[4 * r] * v[0] + m[4 * r + 1] * v[1] + m[4 * r + 2] * v[2] + m[4 * r + 3] * v[3];
  };
  const std::array<double, 4> scene = {point[0], point[1], point[2], 1};
  std::array<double, 4> view{}, clip{};
  for (std::size_t r = 0; r < 4; ++r) view[r] = row(camera.view, r, scene);
  for (std::size_t r = 0; r < 4; ++r) clip[r] = row(camera.projection, r, view);
  return {(clip[0] / clip[3] + 1) / 2 * kWidth - 0.5, (1 - clip[1] / clip[3]) / 2 * kHeight - 0.5,
          -view[2] / kUnit};
}

TEST(PointCarrier, CarriesWhatTheMatricesProject) {
  const Reprojection known =
      KnownCameras(LookingCamera({1, 2, 3}, 0.3, kWidth, kHeight),
                   LookingCamera({1.4, 2.2, 2.5}, 0.35, kWidth, kHeight), kUnit);
  const auto carrier = PointCarrier::Of(known, kWidth, kHeight);
  ASSERT_TRUE(carrier);
  for (double x = -3; x <= 8; x += 1.3) {
    for (double y = -1; y <= 5; y += 1.1) {
      for (const double z : {-4.0, -9.0, -40.0}) {
        const Seen from = See(known.source, {x, y, z}), to = See(known.generated, {x, y, z});
        if (from.depth <= 0 || std::abs(from.x) > 4000) continue;
        const auto at =
            carrier->forward.Apply(static_cast<float>(from.x), static_cast<float>(from.y),
                                   static_cast<float>(1 / from.depth));
        EXPECT_NEAR(at.x, to.x, 3e-3);
        EXPECT_NEAR(at.y, to.y, 3e-3);
        EXPECT_NEAR(from.depth * at.w, to.depth, 1e-5 * to.depth);
        const auto back = carrier->backward.Apply(at.x, at.y, static_cast<float>(1 / to.depth));
        EXPECT_NEAR(back.x, from.x, 5e-3);
        EXPECT_NEAR(back.y, from.y, 5e-3);
      }
    }
  }
}

TEST(PointCarrier, ACameraAtRestMovesNothing) {
  const CameraMatrices camera = LookingCamera({1, 2, 3}, 0.3, kWidth, kHeight);
  const auto carrier = PointCarrier::Of(KnownCameras(camera, camera), kWidth, kHeight);
  ASSERT_TRUE(carrier);
  for (const float x : {0.0f, 17.0f, 1919.0f}) {
    const auto at = carrier->forward.Apply(x, 500, 3);
    EXPECT_NEAR(at.x, x, 1e-4);
    EXPECT_NEAR(at.y, 500, 1e-4);
    EXPECT_NEAR(at.w, 1, 1e-6);
  }
}

TEST(CameraBetween, MovesAndTurnsUniformly) {
  const auto camera = [](double t) {
    return LookingCamera({1 + t, 2 - t, 3 * t}, 0.1 + 0.4 * t, kWidth, kHeight);
  };
  for (const double t : {-0.5, 0.0, 0.25, 1.0, 1.5}) {
    const CameraMatrices between = CameraBetween(camera(0), camera(1), t);
    const CameraMatrices wanted = camera(t);
    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_NEAR(between.view[i], wanted.view[i], 1e-12) << t << " " << i;
      EXPECT_NEAR(between.projection[i], wanted.projection[i], 1e-12);
    }
  }
}

}  // namespace
}  // namespace warplut
