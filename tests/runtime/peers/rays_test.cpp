// Rays on the screen: mip-maps and mesh against their plain versions, and against worlds of which
// everything is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "runtime/peers/rays/depth_pyramid.h"
#include "runtime/peers/rays/screen_mesh.h"

namespace warplut::peers {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kAnyThickness = std::numeric_limits<double>::infinity();

using Place = std::array<double, 3>;

struct DepthImage {
  int width, height;
  std::vector<float> depth;

  DepthImage(int w, int h, const std::function<float(int, int)>& at) : width(w), height(h) {
    for (int y = 0; y < h; ++y) {
      for (int x = 0; x < w; ++x) depth.push_back(at(x, y));
    }
  }
  ImageView view() const {
    return {depth.data(), width, height, static_cast<std::ptrdiff_t>(sizeof(float)) * width,
            PixelFormat::kR32F};
  }
  Pinhole pinhole() const { return {0.8 * width, 0.8 * width, 0.5 * width, 0.5 * height}; }
  // The point of view space at a position and a depth.
  Place At(double x, double y, double z) const {
    const Pinhole p = pinhole();
    return {(x - p.cx) / p.fx * z, (y - p.cy) / p.fy * z, z};
  }
  ScreenRay Ray(const Place& from, const Place& to) const {
    return ScreenRay::Of(pinhole(), from, {to[0] - from[0], to[1] - from[1], to[2] - from[2]},
                         width, height);
  }
};

// A floor that rises, boxes, a pole, sky, and pixels without depth.
DepthImage Clutter(int width, int height) {
  return {width, height, [&](int x, int y) {
            if (y < height / 6) return x % 2 == 0 ? kInf : kNan;
            if (x == width / 2) return 1.5f;
            if (x > width / 5 && x < width / 3 && y > height / 3) return 3.0f;
            if (x > 3 * width / 4 && y < 3 * height / 4)
              return 2.0f + 0.02f * static_cast<float>(x);
            return 8.0f * static_cast<float>(height) / static_cast<float>(y + height);
          }};
}

// Rays between random points of the view, some along an axis of the screen, some towards the
// camera, some parallel to the screen.
std::vector<ScreenRay> RandomRays(const DepthImage& image, int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-0.1, 1.1), depth(0.3, 12);
  std::vector<ScreenRay> rays;
  for (int i = 0; i < count; ++i) {
    double x = share(random) * image.width, y = share(random) * image.height, z = depth(random);
    const Place from = image.At(x, y, z);
    if (i % 7 != 1) x = share(random) * image.width;
    if (i % 7 != 2) y = share(random) * image.height;
    if (i % 7 != 3) z = depth(random);
    if (i % 7 == 4) x = std::floor(x);
    rays.push_back(image.Ray(from, i % 7 == 5 ? Place{0, 0, 0} : image.At(x, y, z)));
  }
  return rays;
}

void ExpectSame(const ScreenHit& fast, const ScreenHit& plain, int ray) {
  ASSERT_EQ(fast.is_hit, plain.is_hit) << "ray " << ray;
  if (!fast.is_hit) return;
  EXPECT_NEAR(fast.x, plain.x, 1e-6) << "ray " << ray;
  EXPECT_NEAR(fast.y, plain.y, 1e-6) << "ray " << ray;
  EXPECT_NEAR(fast.depth, plain.depth, 1e-6 * plain.depth) << "ray " << ray;
}

constexpr int kSizes[][2] = {{67, 45}, {64, 32}, {5, 33}, {3, 2}, {1, 1}};

TEST(ScreenRay, IsWhatAPinholeShowsOfALine) {
  const DepthImage image(60, 40, [](int, int) { return 1.0f; });
  const Place from = image.At(10, 30, 2), to = image.At(50, 5, 7);
  const ScreenRay ray = image.Ray(from, to);
  EXPECT_NEAR(ray.from.x, 10, 1e-9);
  EXPECT_NEAR(1 / ray.from.g, 2, 1e-9);
  const double t = (50 - ray.from.x) / ray.by.x;
  EXPECT_NEAR(ray.At(t).y, 5, 1e-9);
  EXPECT_NEAR(1 / ray.At(t).g, 7, 1e-9);
  // It goes on to its vanishing point, or leaves the screen before.
  EXPECT_GT(ray.end, t);
  EXPECT_NEAR(ray.At(ray.end).y * ray.At(ray.end).g, 0, 1e-9);
}

TEST(ScreenRay, ThatIsNoneIsEmpty) {
  const DepthImage image(60, 40, [](int, int) { return 1.0f; });
  const Pinhole p = image.pinhole();
  const double nan = kNan, inf = kInf;
  EXPECT_TRUE(ScreenRay::Of(p, {0, 0, -1}, {0, 0, 1}, 60, 40).IsEmpty());
  EXPECT_TRUE(ScreenRay::Of(p, {0, 0, 0}, {0, 0, 1}, 60, 40).IsEmpty());
  EXPECT_TRUE(ScreenRay::Of(p, {0, 0, 1}, {0, 0, 0}, 60, 40).IsEmpty());
  EXPECT_TRUE(ScreenRay::Of(p, {nan, 0, 1}, {0, 0, 1}, 60, 40).IsEmpty());
  EXPECT_TRUE(ScreenRay::Of(p, {0, 0, inf}, {1, 0, 0}, 60, 40).IsEmpty());
  EXPECT_TRUE(ScreenRay::Of(p, {0, 0, 1}, {0, inf, 0}, 60, 40).IsEmpty());
  EXPECT_TRUE(ScreenRay::Of(p, {9, 0, 1}, {1, 0, 0}, 60, 40).IsEmpty());  // beside, and away
  EXPECT_FALSE(ScreenRay::Of(p, {9, 0, 1}, {-1, 0, 0}, 60, 40).IsEmpty());
  // Straight at the camera it stays at one position.
  const ScreenRay at_camera = ScreenRay::Of(p, {0, 0, 3}, {0, 0, -1}, 60, 40);
  EXPECT_FALSE(at_camera.IsEmpty());
  EXPECT_EQ(at_camera.At(at_camera.end).x, 30);
}

TEST(DepthPyramid, LevelsHaveTheNearestOfTheirPixels) {
  for (const auto& [width, height] : kSizes) {
    const DepthImage image = Clutter(width, height);
    const DepthPyramid pyramid(image.view());
    for (int level = 0; level <= pyramid.top(); ++level) {
      for (int y = 0; y <= (height - 1) >> level; ++y) {
        for (int x = 0; x <= (width - 1) >> level; ++x) {
          float nearest = 0;
          for (int j = y << level; j < std::min((y + 1) << level, height); ++j) {
            for (int i = x << level; i < std::min((x + 1) << level, width); ++i) {
              const float z = image.depth[static_cast<std::size_t>(j * width + i)];
              if (z < kInf) nearest = std::max(nearest, 1 / z);
            }
          }
          ASSERT_EQ(pyramid.InverseDepthAt(level, x, y), nearest);
        }
      }
    }
    EXPECT_EQ((width - 1) >> pyramid.top(), 0);
    EXPECT_EQ((height - 1) >> pyramid.top(), 0);
  }
}

TEST(DepthPyramid, MarchesAsThePlainVersion) {
  for (const auto& [width, height] : kSizes) {
    const DepthImage image = Clutter(width, height);
    const DepthPyramid pyramid(image.view());
    const std::vector<ScreenRay> rays = RandomRays(image, 400);
    int hits = 0;
    for (int i = 0; i < 400; ++i) {
      for (const double thickness : {0.0, 0.02, 0.3, kAnyThickness}) {
        const ScreenHit plain = pyramid.MarchReference(rays[i], thickness);
        for (const int top : {0, 2, pyramid.top()}) {
          ExpectSame(pyramid.March(rays[i], thickness, top), plain, i);
        }
        hits += plain.is_hit ? 1 : 0;
      }
    }
    EXPECT_GT(hits, width > 8 ? 400 : -1);
  }
}

// The march in small steps: it finds nothing before, and what it finds is found.
TEST(DepthPyramid, SmallStepsFindTheSame) {
  const DepthImage image = Clutter(67, 45);
  const DepthPyramid pyramid(image.view());
  int stepped = 0, found = 0;
  for (const ScreenRay& ray : RandomRays(image, 400)) {
    if (ray.IsEmpty()) continue;
    constexpr double kSteps = 8192;
    const double step = (ray.end - ray.begin) / kSteps;
    const ScreenHit hit = pyramid.March(ray, kAnyThickness, pyramid.top());
    double first = -1;
    for (double t = ray.begin; t < ray.end && first < 0; t += step) {
      const ScreenRay::Point p = ray.At(t);
      const float g = pyramid.InverseDepthAt(0, std::clamp(static_cast<int>(p.x), 0, 66),
                                             std::clamp(static_cast<int>(p.y), 0, 44));
      if (g > 0 && p.g <= g) first = t;
    }
    found += hit.is_hit ? 1 : 0;
    if (first < 0) continue;
    ++stepped;
    ASSERT_TRUE(hit.is_hit);
    EXPECT_LE(hit.t, first);
    EXPECT_GE(hit.t, first - step - 0.02 * (ray.end - ray.begin));
  }
  EXPECT_GT(stepped, 150);
  EXPECT_LE(found - stepped, 2);  // corners that all steps pass
}

TEST(DepthPyramid, SkipsWhatIsBehindTheRay) {
  const DepthImage image(256, 256, [](int, int) { return 100.0f; });
  const DepthPyramid pyramid(image.view());
  const ScreenRay ray = image.Ray(image.At(3, 5, 1), image.At(250, 240, 1));
  const ScreenHit slow = pyramid.March(ray, 0.1, 0), fast = pyramid.March(ray, 0.1, 8);
  EXPECT_FALSE(slow.is_hit);
  EXPECT_GT(slow.cells, 400);
  EXPECT_LT(fast.cells, 40);
}

TEST(DepthPyramid, AThinSurfaceLetsRaysPassBehindIt) {
  const DepthImage image(64, 64, [](int x, int) { return x > 30 && x < 34 ? 2.0f : 10.0f; });
  const DepthPyramid pyramid(image.view());
  const ScreenRay ray = image.Ray(image.At(10, 32, 4), image.At(50, 32, 12));
  const ScreenHit thin = pyramid.March(ray, 0.1, 6), thick = pyramid.March(ray, 5, 6);
  ASSERT_TRUE(thin.is_hit && thick.is_hit);
  EXPECT_NEAR(thin.depth, 10, 1e-5);
  EXPECT_NEAR(thick.x, 31, 1e-9);
}

TEST(ScreenMesh, TracesAsThePlainVersion) {
  for (const auto& [width, height] : kSizes) {
    const DepthImage image = Clutter(width, height);
    const std::vector<ScreenRay> rays = RandomRays(image, 400);
    for (const int tile : {4, 7, 16}) {
      const ScreenMesh mesh(image.view(), {.tile = tile});
      int hits = 0;
      for (int i = 0; i < 400; ++i) {
        for (const double thickness : {0.02, 0.3, kAnyThickness}) {
          const ScreenHit fast = mesh.Trace(rays[i], thickness);
          ExpectSame(fast, mesh.TraceReference(rays[i], thickness), i);
          EXPECT_LE(fast.triangles, mesh.Triangles());
          hits += fast.is_hit ? 1 : 0;
        }
      }
      EXPECT_GT(hits, width > 8 ? 60 : -1);
    }
  }
}

// Planes of the world are planes of the mesh: rays meet them where they are.
TEST(ScreenMesh, MeetsPlanesWhereTheyAre) {
  for (const auto& [width, height] : {std::pair{61, 47}, {128, 96}}) {
    const Pinhole p = DepthImage(width, height, [](int, int) { return 1.0f; }).pinhole();
    // n . (x, y, z) = 1
    for (const Place& n : {Place{0, 0, 0.2}, Place{0, 0.5, 0.1}, Place{0.2, -0.05, 0.15}}) {
      const auto inverse = [&](double x, double y) {
        return n[0] * (x - p.cx) / p.fx + n[1] * (y - p.cy) / p.fy + n[2];
      };
      const DepthImage image(width, height, [&](int x, int y) {
        const double g = inverse(x + 0.5, y + 0.5);
        return g > 0 ? static_cast<float>(1 / g) : kInf;
      });
      const ScreenMesh mesh(image.view(), {.tile = 8});
      int met = 0;
      for (int i = 0; i < 100; ++i) {
        const double x = width * (0.2 + 0.006 * i), y = height * (0.7 - 0.002 * i);
        if (inverse(x, y) < 0.05) continue;
        const Place from = image.At(width * 0.5, height * 0.6, 0.3),
                    to = image.At(x, y, 1 / inverse(x, y));
        const ScreenHit hit = mesh.Trace(image.Ray(from, to), 0.2);
        ASSERT_TRUE(hit.is_hit) << i;
        EXPECT_NEAR(hit.x, x, 0.01);
        EXPECT_NEAR(hit.y, y, 0.01);
        ++met;
      }
      EXPECT_GT(met, 50);
    }
  }
}

// A box before a wall: no sheet hangs between them, and the wall goes on to the box.
TEST(ScreenMesh, EndsAtTheEdgeOfAnObject) {
  const DepthImage image(
      128, 96, [](int x, int y) { return x >= 50 && x < 78 && y >= 30 && y < 62 ? 2.0f : 8.0f; });
  for (const int tile : {4, 8, 16}) {
    const ScreenMesh mesh(image.view(), {.tile = tile});
    int on_wall = 0, on_box = 0;
    for (int y = 4; y < 92; ++y) {
      for (int x = 4; x < 124; ++x) {
        // From a place near the camera, to what the pixel shows.
        const bool is_box = image.depth[static_cast<std::size_t>(y * 128 + x)] < 3;
        const ScreenHit hit = mesh.Trace(
            image.Ray(image.At(64, 48, 0.5), image.At(x + 0.5, y + 0.5, is_box ? 2 : 8)), 0.1);
        const bool is_there =
            hit.is_hit && std::abs(hit.x - x - 0.5) < 0.01 && std::abs(hit.y - y - 0.5) < 0.01;
        (is_box ? on_box : on_wall) += is_there ? 1 : 0;
      }
    }
    // The more of a corner is cut off, the coarser the mesh is.
    EXPECT_GT(on_box, 28 * 32 * (tile == 16 ? 0.7 : 0.9)) << tile;
    EXPECT_GT(on_wall, (120 * 88 - 28 * 32) * 0.95) << tile;
    // Behind the box the ray meets the wall, or nothing; never what spans from one to the other.
    for (int y = 40; y < 52; ++y) {
      const ScreenHit hit = mesh.Trace(image.Ray(image.At(20.5, y, 5), image.At(110.5, y, 8)), 0.1);
      ASSERT_TRUE(hit.is_hit);
      EXPECT_NEAR(hit.x, 110.5, 0.01);
    }
  }
}

TEST(ScreenMesh, RaysFromBehindMeetNothing) {
  const DepthImage image(64, 48, [](int, int) { return 4.0f; });
  const ScreenMesh mesh(image.view(), {.tile = 8});
  EXPECT_FALSE(mesh.Trace(image.Ray(image.At(20, 20, 6), image.At(40, 30, 1)), 1).is_hit);
  EXPECT_FALSE(mesh.Trace(image.Ray(image.At(20, 20, 6), {0, 0, 0}), 1).is_hit);
  EXPECT_TRUE(mesh.Trace(image.Ray(image.At(20, 20, 1), image.At(40, 30, 6)), 1).is_hit);
}

TEST(Rays, MeetNothingWithoutDepth) {
  for (const float depth : {kInf, kNan, -1.0f}) {
    const DepthImage image(37, 21, [&](int, int) { return depth; });
    const DepthPyramid pyramid(image.view());
    const ScreenMesh mesh(image.view(), {.tile = 4});
    for (const ScreenRay& ray : RandomRays(image, 100)) {
      EXPECT_FALSE(pyramid.March(ray, kAnyThickness, pyramid.top()).is_hit);
      EXPECT_FALSE(mesh.Trace(ray, kAnyThickness).is_hit);
    }
  }
}

TEST(ScreenMeshOptions, AreChecked) {
  std::string why;
  EXPECT_TRUE(ScreenMeshOptions().IsValid(&why));
  EXPECT_FALSE((ScreenMeshOptions{.tile = 3}.IsValid(&why)));
  EXPECT_NE(why.find("tile is 3"), std::string::npos) << why;
  EXPECT_FALSE((ScreenMeshOptions{.tile = 65}.IsValid(&why)));
  EXPECT_FALSE((ScreenMeshOptions{.tear = 0}.IsValid(&why)));
  EXPECT_NE(why.find("tear is 0"), std::string::npos) << why;
  EXPECT_FALSE((ScreenMeshOptions{.tear = kInf}.IsValid(&why)));
}

}  // namespace
}  // namespace warplut::peers
