// What holds for every filter, pixel format and instruction set.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>

#include "tests/runtime/warp/warp_fixture.h"

namespace warplut {
namespace {

constexpr int kWidth = 83;
constexpr int kHeight = 21;

class WarpProperty : public testing::TestWithParam<PixelFormat> {
 protected:
  TestTable stored = MakeKeysTable(TableFormat::kI16);
  Table table{stored.view()};
};

TEST_P(WarpProperty, WeightsSumToOne) {
  for (const TestFilter& filter : TestFilters(&table)) {
    for (float dx = 0; dx < 1; dx += 0.07f) {
      for (float dy = 0; dy < 1; dy += 0.07f) {
        double sum = 0;
        for (const float w : FilterWeights(filter.options, dx, dy)) sum += w;
        EXPECT_NEAR(sum, 1.0, 0x1p-21) << filter.name;
      }
    }
  }
}

// Zero motion copies all bits, also those of infinities and negative zeros, and whatever the
// neighbours are.
TEST_P(WarpProperty, ZeroMotionIsACopy) {
  TestImage history(kWidth, kHeight, GetParam());
  history.Randomise(1);
  if (GetParam() != PixelFormat::kRgba8) {
    history.Set(5, 5, 0, std::numeric_limits<float>::infinity());
    history.Set(9, 5, 0, -0.0f);
    history.Set(12, 5, 0, std::numeric_limits<float>::quiet_NaN());
    history.Set(15, 5, 0, 1e-30f);
  }
  const TestMotion still(kWidth, kHeight);
  for (const TestFilter& filter : TestFilters(&table)) {
    SCOPED_TRACE(filter.name);
    for (const bool general : {false, true}) {
      WarpOptions options = filter.options;
      options.general_only = general;
      TestImage out(kWidth, kHeight, GetParam());
      TestHistory(history, options).WarpTo(still.view(), options, out);
      EXPECT_EQ(out, history);
    }
  }
}

TEST_P(WarpProperty, StaticPixelsAmongMovingOnesAreCopied) {
  TestImage history(kWidth, kHeight, GetParam());
  history.Randomise(1);
  TestMotion motion(kWidth, kHeight);
  motion.Randomise(3, 4);
  for (int y = 0; y < kHeight; ++y) motion.Set(y, y, 0, 0);
  for (const TestFilter& filter : TestFilters(&table)) {
    TestImage out(kWidth, kHeight, GetParam());
    TestHistory(history, filter.options).WarpTo(motion.view(), filter.options, out);
    for (int y = 0; y < kHeight; ++y) {
      for (int c = 0; c < Channels(GetParam()); ++c) {
        ASSERT_EQ(out.Get(y, y, c), history.Get(y, y, c)) << filter.name;
      }
    }
  }
}

// Flipping image and motion flips the result. Offsets halfway between nodes are avoided: there the
// nearest lookup must prefer one side.
TEST_P(WarpProperty, FlipCommutes) {
  TestImage history(kWidth, kHeight, GetParam());
  TestImage flipped(kWidth, kHeight, GetParam());
  TestMotion motion(kWidth, kHeight);
  TestMotion flipped_motion(kWidth, kHeight);
  history.Randomise(1);
  motion.Randomise(2, 5);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const int fx = kWidth - 1 - x;
      const int fy = kHeight - 1 - y;
      for (int c = 0; c < Channels(GetParam()); ++c) flipped.Set(fx, fy, c, history.Get(x, y, c));
      flipped_motion.Set(fx, fy, -motion.At(x, y)[0], -motion.At(x, y)[1]);
    }
  }
  // Weights of the table are on a grid, and its closed rows need not be symmetric to the last unit.
  const float unit = GetParam() == PixelFormat::kRgba16F ? 0x1p-9f : 0x1p-10f;
  for (const TestFilter& filter : TestFilters(&table)) {
    TestImage out(kWidth, kHeight, GetParam());
    TestImage flipped_out(kWidth, kHeight, GetParam());
    const TestHistory read(history, filter.options);
    const float bound = GetParam() == PixelFormat::kRgba8 ? 1 : unit * read.Largest();
    read.WarpTo(motion.view(), filter.options, out);
    TestHistory(flipped, filter.options).WarpTo(flipped_motion.view(), filter.options, flipped_out);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        for (int c = 0; c < Channels(GetParam()); ++c) {
          ASSERT_NEAR(out.Get(x, y, c), flipped_out.Get(kWidth - 1 - x, kHeight - 1 - y, c), bound)
              << filter.name << " " << x << " " << y;
        }
      }
    }
  }
}

TEST_P(WarpProperty, FarOutsideTheBorderTexelRepeats) {
  TestImage history(kWidth, kHeight, GetParam());
  history.Randomise(1);
  for (const TestFilter& filter : TestFilters(&table)) {
    for (const float far : {200.5f, 1e6f, 1e30f}) {
      const TestMotion motion(kWidth, kHeight, far, -far);
      TestImage out(kWidth, kHeight, GetParam());
      TestHistory(history, filter.options).WarpTo(motion.view(), filter.options, out);
      for (int c = 0; c < Channels(GetParam()); ++c) {
        ASSERT_NEAR(out.Get(40, 11, c), history.Get(0, kHeight - 1, c), 1e-5f) << filter.name;
      }
    }
  }
}

// A position beyond the centres of the outermost pixels reads what one on them does.
TEST_P(WarpProperty, PrefilteredPositionsAreMovedToTheOutermostCentres) {
  TestImage history(kWidth, kHeight, GetParam());
  history.Randomise(1);
  for (const TestFilter& filter : TestFilters(&table)) {
    if (!HasPrefilter(PrefilterOf(filter.options))) continue;
    SCOPED_TRACE(filter.name);
    const TestHistory read(history, filter.options);
    TestMotion far(kWidth, kHeight);
    TestMotion moved(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const float mx = x % 2 == 0 ? x + 0.4f : x - (kWidth - 1) - 0.7f;
        far.Set(x, y, mx, 0.3f);
        moved.Set(x, y, x % 2 == 0 ? x : x - (kWidth - 1), y == 0 ? 0 : 0.3f);
      }
    }
    TestImage out(kWidth, kHeight, GetParam());
    TestImage expected(kWidth, kHeight, GetParam());
    read.WarpTo(far.view(), filter.options, out);
    read.WarpTo(moved.view(), filter.options, expected);
    EXPECT_EQ(out, expected);
  }
}

// The padding after each row is not touched.
TEST_P(WarpProperty, WritesOnlyPixels) {
  TestImage history(kWidth, kHeight, GetParam(), 64);
  history.Randomise(1);
  for (const float m : {0.0f, 2.0f, 0.3f}) {
    TestMotion motion(kWidth, kHeight, m, m);
    for (const bool general : {false, true}) {
      WarpOptions options;
      options.general_only = general;
      TestImage out(kWidth, kHeight, GetParam(), 64);
      TestHistory(history, options).WarpTo(motion.view(), options, out);
      for (int y = 0; y < kHeight; ++y) {
        const std::byte* end = out.view().Row<std::byte>(y) + kWidth * BytesPerPixel(GetParam());
        for (int i = 0; i < 64; ++i) ASSERT_EQ(end[i], std::byte{0xA5});
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, WarpProperty, testing::ValuesIn(kPixelFormats),
                         [](const auto& test) { return std::string(Name(test.param)); });

}  // namespace
}  // namespace warplut
