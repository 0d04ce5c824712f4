// The motion and jitter of the built-in scenes, checked against pictures and camera matrices.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "datasets/scenes/scene_renderer.h"

namespace warplut {
namespace {

RenderOptions Medium() {
  RenderOptions options;
  options.width = 192;
  options.height = 108;
  options.samples = 8;
  options.inputs = false;
  return options;
}

// Bilinear lookup at a position in pixels; the caller keeps it half a pixel inside.
float Lookup(const Image& image, double x, double y, int c) {
  const int ix = std::clamp(static_cast<int>(std::floor(x - 0.5)), 0, image.width - 2);
  const int iy = std::clamp(static_cast<int>(std::floor(y - 0.5)), 0, image.height - 2);
  const auto fx = static_cast<float>(x - 0.5 - ix), fy = static_cast<float>(y - 0.5 - iy);
  const float upper = image.at(ix, iy, c) + fx * (image.at(ix + 1, iy, c) - image.at(ix, iy, c));
  const float lower =
      image.at(ix, iy + 1, c) + fx * (image.at(ix + 1, iy + 1, c) - image.at(ix, iy + 1, c));
  return upper + fy * (lower - upper);
}

Vec2 MotionAt(const Frame& frame, int x, int y) {
  return {frame.reference_motion.at(x, y, 0), frame.reference_motion.at(x, y, 1)};
}

// The camera's local axes: x right, y up, z backwards.
using Vec3 = std::array<double, 3>;

// Through the centre of pixel (x, y), view depth 1.
Vec3 Ray(const Camera& camera, const Image& grid, double x, double y) {
  return {(2 * x / grid.width - 1) / camera.projection[0],
          (1 - 2 * y / grid.height) / camera.projection[5], -1};
}

// To the world: a point (w = 1) or a direction (w = 0). The view matrix is a rigid motion.
Vec3 ToWorld(const Camera& camera, const Vec3& v, double w) {
  Vec3 world{};
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r)
      world[c] += camera.view[r * 4 + c] * (v[r] - w * camera.view[r * 4 + 3]);
  }
  return world;
}

// Where a world point or direction projects, in pixels, by the matrices alone.
Vec2 Project(const Camera& camera, const Image& grid, const Vec3& world, double w) {
  std::array<double, 4> local{}, clip{};
  const std::array<double, 4> from = {world[0], world[1], world[2], w};
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) local[r] += camera.view[r * 4 + c] * from[c];
  }
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) clip[r] += camera.projection[r * 4 + c] * local[c];
  }
  return {(0.5 + 0.5 * clip[0] / clip[3]) * grid.width,
          (0.5 - 0.5 * clip[1] / clip[3]) * grid.height};
}

// Previous position of what a pixel shows, had nothing but the camera moved.
Vec2 CameraOnly(const SceneRenderer& renderer, const Frame& frame, int x, int y) {
  const Camera now = renderer.CameraAt(frame.number), before = renderer.CameraAt(frame.number - 1);
  const float depth = frame.reference_depth.at(x, y);
  Vec3 local = Ray(now, frame.reference, x + 0.5, y + 0.5);
  if (depth < 1) {
    for (double& v : local) v *= depth * renderer.far_plane();
  }
  const double w = depth < 1 ? 1 : 0;
  return Project(before, frame.reference, ToWorld(now, local, w), w);
}

using Source = std::function<Vec2(int x, int y)>;

// Mean squared error of frame against the frame before, fetched at source(x, y), over pixels that
// `counts` accepts and whose source is inside.
double WarpError(const Frame& frame, const Frame& before, const Source& source,
                 const std::function<bool(int, int)>& counts) {
  double sum = 0;
  int n = 0;
  for (int y = 0; y < frame.reference.height; ++y) {
    for (int x = 0; x < frame.reference.width; ++x) {
      if (!counts(x, y)) continue;
      const Vec2 p = source(x, y);
      if (!(p.x > 1 && p.y > 1 && p.x < frame.reference.width - 1 &&
            p.y < frame.reference.height - 1))
        continue;
      for (int c = 0; c < 3; ++c) {
        const double e = frame.reference.at(x, y, c) - Lookup(before.reference, p.x, p.y, c);
        sum += e * e;
        ++n;
      }
    }
  }
  EXPECT_GT(n, 300);
  return sum / std::max(n, 1);
}

TEST(SceneMotion, CameraMotionAgreesWithTheMatrices) {
  for (const char* scene : {"street", "colonnade", "machinery"}) {
    SCOPED_TRACE(scene);
    const SceneRenderer renderer(scene, Medium());
    const Frame frame = renderer.Render(3);
    int agree = 0, sky = 0, sky_agree = 0;
    for (int y = 0; y < frame.reference.height; ++y) {
      for (int x = 0; x < frame.reference.width; ++x) {
        const Vec2 p = CameraOnly(renderer, frame, x, y), m = MotionAt(frame, x, y);
        const bool same = std::hypot(x + 0.5 - m.x - p.x, y + 0.5 - m.y - p.y) < 2e-3;
        agree += same;
        if (frame.reference_depth.at(x, y) == 1) {
          ++sky;
          sky_agree += same;
        }
      }
    }
    // The rest is on objects that move by themselves.
    EXPECT_GT(agree, 0.85 * static_cast<double>(frame.reference.pixels()));
    EXPECT_GT(sky, 500);
    EXPECT_EQ(sky_agree, sky);
  }
}

TEST(SceneMotion, NothingMovesInStill) {
  const SceneRenderer renderer("still", Medium());
  const Frame one = renderer.Render(1), two = renderer.Render(2);
  for (const float v : two.reference_motion.data) ASSERT_EQ(v, 0);
  EXPECT_EQ(one.reference.data, two.reference.data);
}

TEST(SceneMotion, PlazaLightChangesWhereNothingMoves) {
  const SceneRenderer renderer("plaza", Medium());
  const Frame one = renderer.Render(1), two = renderer.Render(4);
  int changed = 0, resting = 0;
  for (int y = 0; y < two.reference.height; ++y) {
    for (int x = 0; x < two.reference.width; ++x) {
      const Vec2 m = MotionAt(two, x, y);
      if (m.x != 0 || m.y != 0) continue;
      ++resting;
      changed += std::abs(two.reference.at(x, y, 1) - one.reference.at(x, y, 1)) > 0.02f;
    }
  }
  EXPECT_GT(changed, resting / 10);
}

TEST(SceneMotion, WarpingByMotionExplainsTheNextFrame) {
  for (const char* scene : {"courtyard", "street", "colonnade", "meadow"}) {
    SCOPED_TRACE(scene);
    const SceneRenderer renderer(scene, Medium());
    const Frame before = renderer.Render(2), frame = renderer.Render(3);
    const auto by_motion = [&](int x, int y) {
      const Vec2 m = MotionAt(frame, x, y);
      return Vec2{x + 0.5 - m.x, y + 0.5 - m.y};
    };
    const auto in_place = [](int x, int y) { return Vec2{x + 0.5, y + 0.5}; };
    // Moving pixels whose previous position shows the same depth: no disocclusion.
    const auto counts = [&](int x, int y) {
      const Vec2 m = MotionAt(frame, x, y), p = by_motion(x, y);
      if (std::hypot(m.x, m.y) < 0.25) return false;
      if (!(p.x > 1 && p.y > 1 && p.x < frame.reference.width - 1 &&
            p.y < frame.reference.height - 1))
        return false;
      const float depth = frame.reference_depth.at(x, y);
      return std::abs(Lookup(before.reference_depth, p.x, p.y, 0) - depth) < 0.05f * depth;
    };
    const double warped = WarpError(frame, before, by_motion, counts);
    EXPECT_LT(warped, 0.6 * WarpError(frame, before, in_place, counts));
  }
}

// An upright mirror keeps heights, so the floor in it lies on the floor's own plane, behind the
// mirror: there the ray of a pixel meets what moves as a resting point does.
TEST(SceneMotion, MirrorShowsTheReflectedPointsMotion) {
  const SceneRenderer renderer("gallery", Medium());
  const Frame frame = renderer.Render(5);
  const Camera now = renderer.CameraAt(5), before = renderer.CameraAt(4);
  constexpr double kMirrorZ = -6.95,
                   kRoom = 13.9;  // the wall with the mirror, and the depth of the room
  const Vec3 eye = ToWorld(now, {0, 0, 0}, 1);
  int seen = 0, reflected = 0, on_surface = 0;
  for (int y = 0; y < frame.reference.height; ++y) {
    for (int x = 0; x < frame.reference.width; ++x) {
      const Vec3 ray = Ray(now, frame.reference, x + 0.5, y + 0.5);
      const Vec3 d = ToWorld(now, ray, 0);
      const double depth = frame.reference_depth.at(x, y) * renderer.far_plane();
      const bool on_wall = std::abs(eye[2] + depth * d[2] - kMirrorZ) < 1e-3;
      const double floor = -eye[1] / d[1];
      const double z = eye[2] + floor * d[2];
      if (!on_wall || floor < depth || z > kMirrorZ || z < kMirrorZ - kRoom) continue;
      ++seen;
      const Vec2 m = MotionAt(frame, x, y);
      const Vec2 p = Project(before, frame.reference, {eye[0] + floor * d[0], 0, z}, 1);
      reflected += std::hypot(x + 0.5 - m.x - p.x, y + 0.5 - m.y - p.y) < 1e-4;
      const Vec2 s = CameraOnly(renderer, frame, x, y);
      on_surface += std::hypot(x + 0.5 - m.x - s.x, y + 0.5 - m.y - s.y) < 0.02;
    }
  }
  EXPECT_GT(seen, 300);
  EXPECT_GT(reflected, 0.5 * seen);  // the rest shows things that stand or roll on the floor
  EXPECT_LT(on_surface, 0.1 * seen);
}

// A whole jitter cycle of a scene at rest, each sample put where the convention says it lies, is
// the reference.
TEST(SceneJitter, SamplesLieAtPixelCentrePlusJitter) {
  RenderOptions options;
  options.width = 128;
  options.height = 72;
  options.frames = 32;
  options.samples = 64;
  const SceneRenderer renderer("still", options);
  const Frame first = renderer.Render(0);
  options.reference = false;
  const SceneRenderer inputs("still", options);
  const auto error = [&](double sign) {
    Image sum(options.width, options.height, 3);
    std::vector<int> count(sum.pixels());
    for (int f = 0; f < options.frames; ++f) {
      const Frame frame = inputs.Render(f);
      for (int y = 0; y < frame.color.height; ++y) {
        for (int x = 0; x < frame.color.width; ++x) {
          const int hx =
              std::clamp(static_cast<int>(std::floor(2 * (x + 0.5 + sign * frame.jitter.x))), 0,
                         sum.width - 1);
          const int hy =
              std::clamp(static_cast<int>(std::floor(2 * (y + 0.5 + sign * frame.jitter.y))), 0,
                         sum.height - 1);
          ++count[static_cast<std::size_t>(hy) * sum.width + hx];
          for (int c = 0; c < 3; ++c) sum.at(hx, hy, c) += frame.color.at(x, y, c);
        }
      }
    }
    double squares = 0;
    for (std::size_t i = 0; i < sum.data.size(); ++i) {
      EXPECT_GT(count[i / 3], 0);
      const double e =
          sum.data[i] / static_cast<float>(std::max(count[i / 3], 1)) - first.reference.data[i];
      squares += e * e;
    }
    return squares / static_cast<double>(sum.data.size());
  };
  const double right = error(1), wrong = error(-1);
  EXPECT_LT(right, 0.006);
  EXPECT_LT(right, 0.3 * wrong);
}

}  // namespace
}  // namespace warplut
