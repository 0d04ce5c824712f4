// An image after many warps.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernel_main.h"
#include "tests/runtime/warp/warp_fixture.h"

namespace warplut {
namespace {

int Warps() { return LongRuns() ? 10000 : 300; }
constexpr int kWidth = 19;
constexpr int kHeight = 7;

// Motion that differs from warp to warp and, every second warp, from pixel to pixel.
void Step(int warp, TestMotion& motion) {
  if (warp % 2 == 0) {
    motion.Randomise(static_cast<unsigned>(warp), 3);
  } else {
    const float m = 0.001f * static_cast<float>(warp);
    motion = TestMotion(kWidth, kHeight, m, 1.7f * m);
  }
}

TEST(WarpDrift, ZeroMotionKeepsEveryBit) {
  const TestTable stored = MakeKeysTable(TableFormat::kI16);
  const Table table(stored.view());
  const TestMotion still(kWidth, kHeight);
  for (const PixelFormat format : kPixelFormats) {
    for (TestFilter& filter : TestFilters(&table)) {
      filter.options.general_only = true;
      TestImage first(kWidth, kHeight, format);
      first.Randomise(1);
      TestImage image = first;
      TestImage next = first;
      for (int warp = 0; warp < Warps(); ++warp) {
        TestHistory(image, filter.options).WarpTo(still.view(), filter.options, next);
        std::swap(image, next);
      }
      EXPECT_EQ(image, first) << Name(format) << " " << filter.name;
    }
  }
}

class WarpDriftOfConstant : public testing::TestWithParam<TableFormat> {};

// Exactly, where pixels are rounded to less than a float; to half a code value in float.
TEST_P(WarpDriftOfConstant, StaysConstant) {
  const TestTable stored = MakeKeysTable(GetParam());
  const Table table(stored.view());
  TestMotion motion(kWidth, kHeight);
  for (const PixelFormat format : kPixelFormats) {
    const bool is_float = format == PixelFormat::kRgba32F || format == PixelFormat::kR32F;
    for (const TestFilter& filter : TestFilters(&table)) {
      // Filters without this table are run with the first format only.
      if (filter.options.table != &table && GetParam() != kTableFormats[0]) continue;
      TestImage first(kWidth, kHeight, format);
      first.Fill(format == PixelFormat::kRgba8 ? 173 : 0.7f);
      TestImage image = first;
      TestImage next = first;
      for (int warp = 0; warp < Warps(); ++warp) {
        Step(warp, motion);
        TestHistory(image, filter.options).WarpTo(motion.view(), filter.options, next);
        std::swap(image, next);
      }
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          ASSERT_NEAR(image.Get(x, y, 0), first.Get(x, y, 0), is_float ? 0.5 / 255 : 0)
              << Name(format) << " " << filter.name;
        }
      }
    }
  }
}

// The B-spline's gain is 1: whatever the motion, values stay in range, but for overshoot.
TEST(WarpDrift, SplineStaysBounded) {
  const WarpOptions options = {.filter = Filter::kSpline};
  TestMotion motion(kWidth, kHeight);
  for (const PixelFormat format : kPixelFormats) {
    TestImage image(kWidth, kHeight, format);
    image.Randomise(1);
    TestImage next = image;
    for (int warp = 0; warp < Warps(); ++warp) {
      Step(warp, motion);
      TestHistory(image, options).WarpTo(motion.view(), options, next);
      std::swap(image, next);
    }
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        for (int c = 0; c < Channels(format); ++c) {
          ASSERT_LE(std::abs(image.Get(x, y, c)), 2.5f * ChannelScale(format)) << Name(format);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tables, WarpDriftOfConstant, testing::ValuesIn(kTableFormats),
                         [](const auto& test) { return std::string(Name(test.param)); });

}  // namespace
}  // namespace warplut
