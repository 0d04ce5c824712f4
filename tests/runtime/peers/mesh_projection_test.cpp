// Mesh projection: fast against plain, and against rigid scenes whose cameras are known.
#include <algorithm>

#include "runtime/method.h"
#include "tests/image_difference.h"
#include "tests/runtime/generation/generation_fixture.h"
#include "tests/runtime/peers/test_camera.h"

namespace warplut::generation {
namespace {

FrameGenerationOptions MeshOptions(int width, int height) {
  FrameGenerationOptions options;
  options.width = width;
  options.height = height;
  FindMethod("mesh")->configure_generation(options);
  options.warp.filter = Filter::kBilinear;
  return options;
}

// A frame whose colour at each pixel is its place: what a generated frame shows is where it is
// taken from.
TestFrame Places(int width, int height) {
  TestFrame frame(width, height, PixelFormat::kRgba32F);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      frame.color.Set(x, y, 0, static_cast<float>(x) / 256);
      frame.color.Set(x, y, 1, static_cast<float>(y) / 256);
    }
  }
  return frame;
}

TestImage Project(const FrameGenerationOptions& options, const TestFrame& frame,
                  const Reprojection* known) {
  DisplayedFrame frame1 = frame.view();
  frame1.reprojection = known;
  return Generate(options, frame.view(), frame1, 0.5f, false, frame.color.format());
}

// Moves right and up, and turns, between the frames.
Reprojection Walk(int width, int height) {
  return KnownCameras(LookingCamera({0, 0, 0}, 0, width, height),
                      LookingCamera({0.05, 0.02, -0.08}, 0.02, width, height));
}

// The largest distance, in pixels, of what each pixel of `shown` shows from where the plane of
// inverse depth g(x, y) = g0 + gx x + gy y has it in frame 1; pixels whose source is not in the
// frame are left out.
struct Plane {
  float g0, gx, gy;
  float InverseAt(float x, float y) const { return g0 + gx * x + gy * y; }
};
float FarthestFromPlane(const TestImage& shown, const Reprojection& known, const Plane& plane,
                        int border = 0) {
  const auto carrier = *PointCarrier::Of(known, shown.width(), shown.height());
  float farthest = 0;
  for (int y = border; y < shown.height() - border; ++y) {
    for (int x = border; x < shown.width() - border; ++x) {
      // The source that is carried to (x, y), by steps of what is missing.
      float px = static_cast<float>(x), py = static_cast<float>(y);
      for (int step = 0; step < 20; ++step) {
        const auto at = carrier.forward.Apply(px, py, plane.InverseAt(px, py));
        px += static_cast<float>(x) - at.x;
        py += static_cast<float>(y) - at.y;
      }
      const bool inside = px >= 0 && px <= static_cast<float>(shown.width() - 1) && py >= 0 &&
                          py <= static_cast<float>(shown.height() - 1);
      if (!inside) continue;
      farthest = std::max({farthest, std::abs(256 * shown.Get(x, y, 0) - px),
                           std::abs(256 * shown.Get(x, y, 1) - py)});
    }
  }
  return farthest;
}

TEST(MeshProjection, APlaneIsExactToTheShearThreshold) {
  constexpr int kWidth = 150, kHeight = 90;
  TestFrame frame = Places(kWidth, kHeight);
  const Plane plane{2, 0.005f, 0.01f};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      frame.depth.Set(x, y, 0, 1 / plane.InverseAt(static_cast<float>(x), static_cast<float>(y)));
    }
  }
  const Reprojection known = Walk(kWidth, kHeight);
  FrameGenerationOptions options = MeshOptions(kWidth, kHeight);
  for (const float tile : {4.0f, 8.0f, 11.0f, 16.0f}) {
    for (const float shear : {0.03125f, 0.25f}) {
      options.parameters.mesh_tile = tile;
      options.parameters.mesh_shear = shear;
      const TestImage shown = Project(options, frame, &known);
      // The depth that is carried back is that of u. Beside the anchored border u is far from v.
      const int border = static_cast<int>(2 * tile);
      EXPECT_LE(FarthestFromPlane(shown, known, plane, border), shear + 0.05f) << tile << shear;
      EXPECT_LE(FarthestFromPlane(shown, known, plane), shear + 0.1f) << tile << " " << shear;
    }
  }
}

// A square before a wall; the camera moves to the right.
TEST(MeshProjection, SurfacesKeepTheirPlacesBesideDepthEdges) {
  constexpr int kWidth = 160, kHeight = 96;
  TestFrame frame = Places(kWidth, kHeight);
  frame.depth.Fill(0.8f);
  for (int y = 32; y < 64; ++y) {
    for (int x = 60; x < 100; ++x) frame.depth.Set(x, y, 0, 0.2f);
  }
  const Reprojection known = KnownCameras(LookingCamera({0, 0, 0}, 0, kWidth, kHeight),
                                          LookingCamera({0.2, 0, 0}, 0, kWidth, kHeight));
  const auto carrier = *PointCarrier::Of(known, kWidth, kHeight);
  const float near_move = carrier.forward.Apply(60, 40, 5).x - 60;
  const float far_move = carrier.forward.Apply(60, 40, 1.25f).x - 60;
  ASSERT_LT(near_move, far_move - 3);  // so many pixels of the wall appear at the right
  const TestImage shown = Project(MeshOptions(kWidth, kHeight), frame, &known);
  int off = 0, all = 0;
  for (int y = 4; y < kHeight - 4; ++y) {
    for (int x = 4; x < kWidth - 8; ++x) {
      const auto fx = static_cast<float>(x);
      const bool near = y >= 32 && y < 64 && fx - near_move >= 60 && fx - near_move < 100;
      const float source = fx - (near ? near_move : far_move);
      const bool uncovered = !near && y >= 31 && y <= 64 && source >= 59 && source <= 100;
      if (uncovered) continue;
      ++all;
      if (std::abs(256 * shown.Get(x, y, 0) - source) > 0.3f) ++off;
    }
  }
  EXPECT_LT(off, all / 50);
}

// Where the mesh is stretched over what it uncovers, a vertex that shows the background keeps the
// foreground from being stretched with it.
TEST(MeshProjection, TheForegroundIsNotStretchedOverWhatItUncovers) {
  constexpr int kWidth = 96, kHeight = 64;
  TestFrame frame(kWidth, kHeight, PixelFormat::kRgba32F, 0.8f);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 32; x < 61; ++x) {
      frame.depth.Set(x, y, 0, 0.1f);
      for (int c = 0; c < 3; ++c) frame.color.Set(x, y, c, 1);
    }
  }
  const Reprojection known = KnownCameras(LookingCamera({0, 0, 0}, 0, kWidth, kHeight),
                                          LookingCamera({0.25, 0, 0}, 0, kWidth, kHeight));
  FrameGenerationOptions options = MeshOptions(kWidth, kHeight);
  const auto white = [&](float tensile) {
    options.parameters.mesh_tensile = tensile;
    const TestImage shown = Project(options, frame, &known);
    float sum = 0;
    for (int x = 0; x < kWidth; ++x) sum += shown.Get(x, 32, 0);
    return sum;
  };
  EXPECT_NEAR(white(2), 29, 3);
  EXPECT_GT(white(64), white(2) + 2);
}

TEST(MeshProjection, FastPassesAgree) {
  constexpr int kSizes[][2] = {{1, 1}, {3, 5}, {9, 2}, {17, 9}, {64, 16}, {131, 50}};
  unsigned seed = 40;
  for (const auto& [width, height] : kSizes) {
    for (const float tile : {4.0f, 8.0f, 13.0f}) {
      for (const bool wild : {false, true}) {
        const TestFrame frame = RandomFrame(width, height, PixelFormat::kRgba32F, ++seed, wild);
        const TestFrame other = RandomFrame(width, height, PixelFormat::kRgba32F, ++seed, false);
        TestImage moving(width, height, PixelFormat::kR32F, 4);
        for (int y = 0; y < height; ++y) {
          for (int x = 0; x < width; ++x) moving.Set(x, y, 0, other.depth.Get(x, y, 0) < 0.2f);
        }
        Reprojection known = Walk(width, height);
        for (const bool moves : {false, true}) {
          if (moves) known.moving = moving.history();
          FrameGenerationOptions options = MeshOptions(width, height);
          options.parameters.mesh_tile = tile;
          const TestImage fast = Project(options, frame, &known);
          options.reference = true;
          EXPECT_LE(Compare(fast.view(), Project(options, frame, &known).view()).largest, 0.3 / 255)
              << width << " x " << height << ", seed " << seed;
        }
      }
    }
  }
}

TEST(MeshProjection, BackgroundMovesByTheTurnAlone) {
  constexpr int kWidth = 96, kHeight = 64;
  TestFrame frame = Places(kWidth, kHeight);
  frame.depth.Fill(std::numeric_limits<float>::infinity());
  Reprojection known = Walk(kWidth, kHeight);
  const TestImage walked = Project(MeshOptions(kWidth, kHeight), frame, &known);
  known.generated = LookingCamera({0, 0, 0}, 0.02, kWidth, kHeight);
  const TestImage turned = Project(MeshOptions(kWidth, kHeight), frame, &known);
  EXPECT_LE(Compare(walked.view(), turned.view()).largest, 1e-5);
  EXPECT_LE(FarthestFromPlane(turned, known, {0, 0, 0}), 0.3f);
}

TEST(MeshProjection, NothingBehindTheCameraIsDrawn) {
  constexpr int kWidth = 64, kHeight = 40;
  TestFrame frame = Places(kWidth, kHeight);
  const Reprojection known =
      KnownCameras(LookingCamera({0, 0, 0}, 0, kWidth, kHeight),
                   LookingCamera({0, 0, -9}, 0, kWidth, kHeight));  // the wall is 5 units away
  SerialExecutor executor;
  FrameGeneration generation(MeshOptions(kWidth, kHeight), executor);
  TestImage out(kWidth, kHeight, PixelFormat::kRgba32F, 16);
  DisplayedFrame frame1 = frame.view();
  frame1.reprojection = &known;
  generation.Extrapolate(frame.view(), frame1, 0.5f, out.view());
  EXPECT_EQ(generation.Tiles().disoccluded, generation.Tiles().total);
  EXPECT_LE(Compare(out.view(), frame.color.view()).largest, 1);
}

TEST(MeshProjection, WhatMovesIsDrawnAnewAndNotShownAgain) {
  constexpr int kWidth = 64, kHeight = 32;
  TestFrame frame(kWidth, kHeight, PixelFormat::kRgba32F, 0.5f);
  TestImage moving(kWidth, kHeight, PixelFormat::kR32F),
      drawn(kWidth, kHeight, PixelFormat::kRgba32F);
  moving.Fill(0);
  drawn.Fill(0);
  frame.color.Fill(0.25f);
  for (int y = 8; y < 24; ++y) {
    for (int x = 20; x < 36; ++x) {
      frame.depth.Set(x, y, 0, 0.2f);
      moving.Set(x, y, 0, 1);
      frame.color.Set(x, y, 0, 1);
      for (const int c : {0, 3}) drawn.Set(x + 8, y, c, c == 0 ? 0.75f : 1);
    }
  }
  Reprojection known = KnownCameras(LookingCamera({0, 0, 0}, 0, kWidth, kHeight),
                                    LookingCamera({0, 0, 0}, 0, kWidth, kHeight));
  known.moving = moving.history();
  known.drawn = drawn.history();
  const TestImage shown = Project(MeshOptions(kWidth, kHeight), frame, &known);
  for (int x = 0; x < kWidth; ++x) {
    EXPECT_NEAR(shown.Get(x, 16, 0), x >= 28 && x < 44 ? 0.75f : 0.25f, 1e-5) << x;
  }
}

// With as many pixels beyond the border as Overscan says the frame inside is found in frame 1.
TEST(MeshProjection, OverscanCoversWhatEnters) {
  constexpr int kWidth = 160, kHeight = 96;
  const Reprojection known = KnownCameras(LookingCamera({0, 0, 0}, 0, kWidth, kHeight),
                                          LookingCamera({0.2, 0, 0}, 0, kWidth, kHeight));
  const int margin = Overscan(known, kWidth, kHeight, 0.5);
  ASSERT_GE(margin, 3);
  ASSERT_LE(margin, 10);
  TestFrame frame = Places(kWidth, kHeight);
  const TestImage shown = Project(MeshOptions(kWidth, kHeight), frame, &known);
  const auto carrier = *PointCarrier::Of(known, kWidth, kHeight);
  float inside = 0, beyond = 0;
  for (int y = margin; y < kHeight - margin; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float source =
          carrier.backward.Apply(static_cast<float>(x), static_cast<float>(y), 2).x;
      const float off = std::abs(256 * shown.Get(x, y, 0) - source);
      float& most = x >= margin && x < kWidth - margin ? inside : beyond;
      most = std::max(most, off);
    }
  }
  EXPECT_LE(inside, 0.3f);
  EXPECT_GT(beyond, 1);
}

TEST(MeshProjection, RefusesCamerasThatLeadNowhere) {
  const TestFrame frame = Places(16, 16);
  SerialExecutor executor;
  const FrameGeneration generation(MeshOptions(16, 16), executor);
  TestImage out(16, 16, PixelFormat::kRgba32F);
  const auto why = [&](const Reprojection& known) {
    DisplayedFrame frame1 = frame.view();
    frame1.reprojection = &known;
    std::string sentence;
    EXPECT_FALSE(generation.IsGenerable(frame.view(), frame1, 0.5f, out.view(), &sentence));
    return sentence;
  };
  Reprojection known = Walk(16, 16);
  known.depth_unit = 0;
  EXPECT_EQ(why(known), "depth_unit is 0.000000; expected above 0.");
  known = Walk(16, 16);
  known.generated.projection[15] = 1;
  EXPECT_EQ(why(known), "The projection of a camera is not perspective; expected w = -z.");
  known = Walk(16, 16);
  known.source.view[0] = 2;
  EXPECT_EQ(why(known), "The view of a camera scales; expected a rotation and a shift.");
  known = Walk(16, 16);
  const TestImage small(8, 8, PixelFormat::kR32F);
  known.moving = small.view();
  EXPECT_NE(why(known).find("The mask of what moves"), std::string::npos);
}

}  // namespace
}  // namespace warplut::generation
