#include "runtime/generation/splat.h"

#include <map>

#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

TEST(SplatKey, OrdersByDepthThenSource) {
  const float depths[] = {0.0f, 1e-30f, 0.0028f,       0.0028f * (1 + 0x1p-23f),
                          0.5f, 1.0f,   kFarthestDepth};
  for (std::size_t i = 0; i + 1 < std::size(depths); ++i) {
    EXPECT_LT(MakeSplatKey(depths[i], 0xFFFFFFFFu), MakeSplatKey(depths[i + 1], 0));
  }
  EXPECT_LT(MakeSplatKey(0.5f, 3), MakeSplatKey(0.5f, 4));
  EXPECT_LT(MakeSplatKey(kFarthestDepth, 0xFFFFFFFFu), kNoSplat);
  EXPECT_EQ(SplatDepth(MakeSplatKey(0.37f, 9)), 0.37f);
  EXPECT_EQ(SplatSource(MakeSplatKey(0.37f, 9)), 9u);
  EXPECT_EQ(SplatDepth(kNoSplat), kNoArrivalDepth);
}

// One row of frame 1 with its own motion and depth.
struct Row {
  explicit Row(int width)
      : frame0(width, 1, PixelFormat::kRgba8),
        frame1(width, 1, PixelFormat::kRgba8),
        options(OptionsFor(frame0)) {}

  GenerationJob Job(bool interpolates, float alpha, bool motion0_counts = true) const {
    return {options,
            interpolates,
            alpha,
            motion0_counts,
            frame0.depth.view(),
            frame1.depth.view(),
            frame0.motion.view(),
            frame1.motion.view()};
  }

  TestFrame frame0, frame1;
  FrameGenerationOptions options;
};

TEST(ForwardDisplacement, ReadsTheMotionOfFrame0WherePixelsWere) {
  Row row(16);
  row.frame1.motion.Set(10, 0, 4, 0);
  row.frame0.motion.Set(6, 0, 2, 0);
  // m1 = 4, m0 = 2, alpha = 1/2: 1/4 (6) + 1/8 (2) - 4.
  EXPECT_EQ(ForwardDisplacement(row.Job(true, 0.5f), 10, 0).x, -2.25f);
  // 1/4 (10) + 1/8 (2).
  EXPECT_EQ(ForwardDisplacement(row.Job(false, 0.5f), 10, 0).x, 2.75f);
}

TEST(ForwardDisplacement, IsLinearWhereFrame0CannotTell) {
  const auto linear = [](const Row& row, bool counts = true) {
    return ForwardDisplacement(row.Job(true, 0.5f, counts), 10, 0).x == -2.0f;
  };
  Row row(16);
  row.frame1.motion.Set(10, 0, 4, 0);
  row.frame0.motion.Set(6, 0, 2, 0);
  EXPECT_FALSE(linear(row));
  EXPECT_TRUE(linear(row, false));
  Row other_depth = row;
  other_depth.frame0.depth.Set(6, 0, 0, 0.9f);
  EXPECT_TRUE(linear(other_depth));
  Row no_motion = row;
  no_motion.frame0.motion.Set(6, 0, std::nanf(""), 0);
  EXPECT_TRUE(linear(no_motion));
  Row outside(16);
  outside.frame1.motion.Set(2, 0, 4, 0);
  EXPECT_EQ(ForwardDisplacement(outside.Job(true, 0.5f), 2, 0).x, -2.0f);
}

TEST(ForwardDisplacement, SoftGateMixesBothModels) {
  Row row(16);
  row.frame1.motion.Set(10, 0, 4, 0);
  row.frame0.motion.Set(6, 0, 2, 0);
  const float threshold = row.options.parameters.generation_depth_threshold;
  row.frame0.depth.Set(6, 0, 0, 0.5f * (1 + threshold));  // on the threshold: the gate is 1/2
  row.options.gate_width = 0.5f;
  EXPECT_NEAR(ForwardDisplacement(row.Job(true, 0.5f), 10, 0).x, -2.125f, 1e-4f);
}

TEST(ForwardDisplacement, IsNoNumberWithoutMotion) {
  Row row(4);
  row.frame1.motion.Set(1, 0, std::numeric_limits<float>::infinity(), 0);
  EXPECT_TRUE(std::isnan(ForwardDisplacement(row.Job(true, 0.5f), 1, 0).x));
}

// Every arrival, kept in a map, whatever the order of rows.
TEST(Splat, KeepsTheLeastOfAllArrivals) {
  const TestFrame frame0 = RandomFrame(53, 37, PixelFormat::kRgba8, 5);
  const TestFrame frame1 = RandomFrame(53, 37, PixelFormat::kRgba8, 6);
  const FrameGenerationOptions options = OptionsFor(frame0);
  const GenerationJob job{options,
                          true,
                          0.4f,
                          true,
                          frame0.depth.view(),
                          frame1.depth.view(),
                          frame0.motion.view(),
                          frame1.motion.view()};
  std::vector<float> xy(2 * 53 * 37);
  const MutableMotionView forward{xy.data(), 53, 37, 53 * 8};
  std::map<std::pair<int, int>, SplatKey> expected;
  for (int y = 0; y < 37; ++y) {
    for (int x = 0; x < 53; ++x) {
      const Vector v = ForwardDisplacement(job, x, y);
      SetMotion(forward, x, y, v);
      const PixelIndex q = NearestPixel(job, x, y, v);
      if (q.x < 0) continue;
      const SplatKey key =
          MakeSplatKey(DepthAt(job.depth1, x, y), static_cast<std::uint32_t>(y * 53 + x));
      const auto [at, is_new] = expected.try_emplace({q.x, q.y}, key);
      if (!is_new) at->second = std::min(at->second, key);
    }
  }
  std::vector<SplatKey> keys(53 * 37, kNoSplat);
  for (int y = 36; y >= 0; --y) SplatRowReference(job, forward, y, {0, 20}, {keys.data(), 53});
  for (int y = 0; y < 37; ++y) SplatRowReference(job, forward, y, {20, 37}, {keys.data(), 53});
  for (int y = 0; y < 37; ++y) {
    for (int x = 0; x < 53; ++x) {
      const auto at = expected.find({x, y});
      EXPECT_EQ(keys[static_cast<std::size_t>(y * 53 + x)],
                at == expected.end() ? kNoSplat : at->second);
    }
  }
}

}  // namespace
}  // namespace warplut::generation
