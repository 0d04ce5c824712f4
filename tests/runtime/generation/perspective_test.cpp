// The perspective motion model on a rigid scene with a known camera.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "runtime/generation/motion/surface_before.h"
#include "runtime/generation/motion/target_motion.h"
#include "runtime/generation/splat.h"
#include "tests/runtime/generation/camera_travel.h"

namespace warplut::generation {
namespace {

constexpr int kWidth = Travel::kWidth, kHeight = Travel::kHeight;

// The 90th percentile of the distance of arrivals from where the surface is, over pixels whose
// surface the frames before show.
double ArrivalError(const Travel& travel, MotionModel model, bool interpolates, float alpha) {
  const TestFrame frame0 = travel.Frame(0), frame1 = travel.Frame(1);
  FrameGenerationOptions options = OptionsFor(frame0);
  options.motion_model = model;
  const GenerationJob job{options,
                          interpolates,
                          alpha,
                          model != MotionModel::kLinear,
                          frame0.depth.view(),
                          frame1.depth.view(),
                          frame0.motion.view(),
                          frame1.motion.view()};
  std::vector<double> errors;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Travel::Point world = travel.Seen(x, y, 1);
      const auto before = travel.Pixel(world, 0);
      if (!(before[0] > 1 && before[0] < kWidth - 1 && before[1] > 1 && before[1] < kHeight - 1)) {
        continue;
      }
      const auto truth = travel.Pixel(world, interpolates ? alpha : 1 + alpha);
      const Vector d = ForwardDisplacement(job, x, y);
      errors.push_back(std::hypot(x + 0.5 + d.x - truth[0], y + 0.5 + d.y - truth[1]));
    }
  }
  const auto rank = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() * 9 / 10);
  std::nth_element(errors.begin(), rank, errors.end());
  return *rank;
}

TEST(PerspectiveMotion, FollowsRigidScenesUnderAKnownCamera) {
  const Travel travel;
  for (const bool interpolates : {true, false}) {
    const double perspective = ArrivalError(travel, MotionModel::kPerspective, interpolates, 0.5f);
    const double quadratic = ArrivalError(travel, MotionModel::kQuadratic, interpolates, 0.5f);
    const double linear = ArrivalError(travel, MotionModel::kLinear, interpolates, 0.5f);
    RecordProperty(interpolates ? "interpolated" : "extrapolated", std::to_string(perspective));
    EXPECT_LT(perspective, interpolates ? 0.08 : 0.5);
    EXPECT_GT(quadratic, interpolates ? 0.3 : 2);
    EXPECT_LT(perspective, 0.2 * quadratic) << quadratic;
    EXPECT_GT(linear, quadratic);
  }
}

// The 90th percentile of how far off the motion from frame 0 is where nothing arrived, in the lower
// half, over pixels whose surface frame 0 shows.
double DisocclusionError(const Travel& travel, MotionModel model, int* count) {
  constexpr float kAlpha = 0.5f;
  const TestFrame frame0 = travel.Frame(0), frame1 = travel.Frame(1);
  FrameGenerationOptions options = OptionsFor(frame0);
  options.motion_model = model;
  const GenerationJob job{options,
                          true,
                          kAlpha,
                          true,
                          frame0.depth.view(),
                          frame1.depth.view(),
                          frame0.motion.view(),
                          frame1.motion.view()};
  std::vector<float> forward(2 * kWidth * kHeight);
  std::vector<SplatKey> keys(kWidth * kHeight, kNoSplat);
  const MutableMotionView displacements{forward.data(), kWidth, kHeight, 8 * kWidth};
  for (int y = 0; y < kHeight; ++y) ForwardRowReference(job, y, displacements);
  for (int y = 0; y < kHeight; ++y) {
    SplatRowReference(job, displacements, y, {0, kHeight}, {keys.data(), kWidth});
  }
  std::vector<double> errors;
  for (int y = kHeight / 2; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const TargetMotion motion = TargetMotionAt(job, {displacements, {keys.data(), kWidth}}, x, y);
      const auto before = travel.Pixel(travel.Seen(x, y, kAlpha), 0);
      const bool shown =
          before[0] > 1 && before[0] < kWidth - 1 && before[1] > 1 && before[1] < kHeight - 1;
      if (!motion.filled || !shown) continue;
      errors.push_back(
          std::hypot(x + 0.5 - motion.from0.x - before[0], y + 0.5 - motion.from0.y - before[1]));
    }
  }
  *count = static_cast<int>(errors.size());
  if (errors.empty()) return 0;
  const auto rank = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() * 9 / 10);
  std::nth_element(errors.begin(), rank, errors.end());
  return *rank;
}

TEST(PerspectiveMotion, FindsWhatLeavesTheImageInFrame0) {
  int found = 0, background = 0;
  const double error = DisocclusionError(Travel{}, MotionModel::kPerspective, &found);
  const double nearest = DisocclusionError(Travel{}, MotionModel::kQuadratic, &background);
  EXPECT_GT(found, 500);
  EXPECT_LT(error, 2) << nearest;
  EXPECT_GT(nearest, 4 * error) << error;
}

// One row, with motion and depth of each frame.
struct Row {
  explicit Row(int width)
      : frame0(width, 1, PixelFormat::kRgba8),
        frame1(width, 1, PixelFormat::kRgba8),
        options(OptionsFor(frame0)) {
    options.motion_model = MotionModel::kPerspective;
  }

  GenerationJob Job(bool interpolates, float alpha) const {
    return {options,
            interpolates,
            alpha,
            true,
            frame0.depth.view(),
            frame1.depth.view(),
            frame0.motion.view(),
            frame1.motion.view()};
  }
  float At(int x, bool interpolates = false, float alpha = 0.5f) const {
    return ForwardDisplacement(Job(interpolates, alpha), x, 0).x;
  }

  TestFrame frame0, frame1;
  FrameGenerationOptions options;
};

TEST(SurfaceBefore, IsReadBetweenThePixelsOfOneSurface) {
  Row row(8);
  row.frame1.depth.Set(4, 0, 0, 0.5f);
  row.frame0.depth.Set(2, 0, 0, 0.5f);
  row.frame0.depth.Set(3, 0, 0, 0.52f);
  row.frame0.motion.Set(2, 0, 1, 0);
  row.frame0.motion.Set(3, 0, 2, 4);
  const auto find = [&] { return FindSurfaceBefore(row.Job(true, 0.5f), 4, 0, {1.75f, 0}); };
  SurfaceBefore before = find();
  EXPECT_FLOAT_EQ(before.motion.x, 1.25f);
  EXPECT_FLOAT_EQ(before.motion.y, 1);
  EXPECT_FLOAT_EQ(before.ratio, 1 / (0.75f / 0.5f + 0.25f / 0.52f) / 0.5f);
  EXPECT_EQ(before.gate, 1);
  // Another surface, or no motion, leaves the pixel out.
  row.frame0.depth.Set(3, 0, 0, 0.56f);
  EXPECT_FLOAT_EQ(find().motion.x, 1);
  row.frame0.depth.Set(3, 0, 0, 0.52f);
  row.frame0.motion.Set(2, 0, std::nanf(""), 0);
  EXPECT_FLOAT_EQ(find().motion.x, 2);
  // The anchor is the pixel nearest in depth, though farther away.
  row.frame0.motion.Set(2, 0, 1, 0);
  row.frame0.depth.Set(2, 0, 0, 0.1f);
  EXPECT_FLOAT_EQ(find().motion.x, 2);
}

TEST(SurfaceBefore, IsNotFoundOutsideOrAtOtherDepths) {
  Row row(8);
  const auto gate = [&](float motion) {
    return FindSurfaceBefore(row.Job(true, 0.5f), 4, 0, {motion, 0}).gate;
  };
  EXPECT_EQ(gate(1), 1);
  EXPECT_EQ(gate(5), 0);
  row.frame1.depth.Set(4, 0, 0, 0.2f);
  EXPECT_EQ(gate(1), 0);
  row.options.depth = DepthMeasure::kNone;
  EXPECT_EQ(gate(1), 1);
}

TEST(PerspectiveMotion, IsQuadraticWhereDepthDoesNotChange) {
  Row row(16);
  row.frame1.motion.Set(10, 0, 4, 0);
  row.frame0.motion.Set(6, 0, 2, 0);
  EXPECT_EQ(row.At(10, true), -2.25f);
  EXPECT_EQ(row.At(10), 2.75f);
  row.frame0.depth.Fill(kFarthestDepth);
  row.frame1.depth.Fill(std::numeric_limits<float>::infinity());
  EXPECT_EQ(row.At(10), 2.75f);
}

TEST(PerspectiveMotion, IsLinearWhereFrame0CannotTell) {
  Row row(16);
  row.frame1.motion.Set(10, 0, 4, 0);
  row.frame0.motion.Set(6, 0, 2, 0);
  row.frame0.depth.Fill(0.9f);
  EXPECT_EQ(row.At(10), 2);
  EXPECT_EQ(row.At(10, true), -2);
}

TEST(PerspectiveMotion, ArrivesNowhereBehindTheCamera) {
  Row row(16);
  row.options.depth = DepthMeasure::kNone;
  row.frame1.motion.Set(10, 0, 1, 0);
  row.frame0.motion = TestMotion(16, 1, 1, 0);
  row.frame1.depth.Set(10, 0, 0, 0.1f);
  row.frame0.depth.Fill(0.25f);  // at 1.9 the depth is 0.1 - 0.9 * 0.15
  EXPECT_TRUE(std::isnan(row.At(10, false, 0.9f)));
  EXPECT_TRUE(std::isfinite(row.At(10, true, 0.9f)));
  // In frame -1 it was behind the camera: steady in homogeneous coordinates, m0 does not count.
  row.frame0.depth.Fill(0.04f);
  const float steady = 0.5f * 0.4f / (0.4f + 1.5f * 0.6f);
  EXPECT_FLOAT_EQ(row.At(10), steady);
  row.frame0.motion = TestMotion(16, 1, 9, 0);
  EXPECT_FLOAT_EQ(row.At(10), steady);
}

}  // namespace
}  // namespace warplut::generation
