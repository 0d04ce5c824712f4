// What the cases of the runtime are judged by sees what it is there for.
#include <gtest/gtest.h>

#include <limits>

#include "tests/stability/cases/passes/runtime_methods.h"
#include "tests/stability/cases/stability_clip.h"

namespace warplut {
namespace {

constexpr GridSize kRender{12, 10}, kOutput{24, 20};

TEST(DifferenceFromStill, SeesThatHistoryAndMotionCount) {
  const Clip clip = PanningGround(kRender, kOutput, 4);
  for (const char* name : {"sr", "sr-sample", "sr-residual", "sr-paper", "i", "e", "isr", "esr"}) {
    const MethodInfo& method = *FindMethod(name);
    EXPECT_GT(DifferenceFromStill(clip, method, RunMethod(clip, method), Between::kMean), 0.002)
        << name;
  }
}

TEST(DifferenceFromStill, KnowsTheBaselines) {
  const Clip clip = PanningGround(kRender, kOutput, 4);
  for (const char* name : {"bilinear", "bicubic", "repeat", "average"}) {
    const MethodInfo& method = *FindMethod(name);
    EXPECT_LT(DifferenceFromStill(clip, method, RunMethod(clip, method), Between::kMean), 1e-6)
        << name;
  }
}

TEST(Comparison, ANumberThatIsNoneIsInfinitelyFar) {
  ImageBuffer a(3, 2, PixelFormat::kRgba32F), b(3, 2, PixelFormat::kRgba32F);
  EXPECT_TRUE(SameBits(a.view(), b.view()));
  a.view().Row<float>(1)[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(SameBits(a.view(), b.view()));
  EXPECT_EQ(LargestDifference(a.view(), b.view()), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(DifferingShare(a.view(), b.view(), 0.1), 1.0 / 6, 1e-12);
  EXPECT_FALSE(RangeOf(a.view()).IsWithin(-1e9, 1e9));
  EXPECT_TRUE(RangeOf(b.view()).IsWithin(0, 0));
}

TEST(Overshoot, OfTheShippedTableIsSomeShareOfTheRange) {
  EXPECT_GT(Overshoot(StoredHistoryTable()), 0.05);
  EXPECT_LT(Overshoot(StoredHistoryTable()), 0.5);
}

TEST(MakeClip, RendersBothGridsOfOneContent) {
  const Clip clip = MakeClip(kRender, kOutput, 2, [](double x, double y, int frame) {
    return ClipTexel{.color = {static_cast<float>(x), static_cast<float>(y), 0},
                     .depth = static_cast<float>(frame),
                     .motion_x = 1,
                     .motion_y = -2};
  });
  const ClipFrame& frame = clip.frames[1];
  EXPECT_FLOAT_EQ(frame.color.view().Row<float>(4)[4 * 3], 3.75f);  // jitter 1/4
  EXPECT_FLOAT_EQ(frame.reference.view().Row<float>(8)[4 * 6], 3.25f);
  EXPECT_FLOAT_EQ(frame.reference_motion.view().Row(8)[2 * 6 + 1], -4);
  EXPECT_FLOAT_EQ(frame.motion.view().Row(4)[2 * 3 + 1], -2);
  EXPECT_EQ(frame.reference_depth.view().Row<float>(0)[0], 1);
}

}  // namespace
}  // namespace warplut
