// The fast warp against the reference, on every instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <vector>

#include "tests/runtime/warp/warp_fixture.h"

namespace warplut {
namespace {

struct Size {
  int width;
  int height;
};

// Counts channels that differ at all; fails for those that differ by more than the documented
// bound. `largest` is that of the texels, or coefficients.
int CountDifferent(const TestImage& fast, const TestImage& reference, float largest) {
  int different = 0;
  for (int y = 0; y < fast.height(); ++y) {
    for (int x = 0; x < fast.width(); ++x) {
      for (int c = 0; c < Channels(fast.format()); ++c) {
        const float expected = reference.Get(x, y, c);
        float bound = std::max(largest, kWarpFloor) * kWarpFloatBound;
        if (fast.format() == PixelFormat::kRgba8) bound = kWarpRgba8Bound;
        if (fast.format() == PixelFormat::kRgba16F)
          bound += 0x1p-10f * std::max(std::abs(expected), 0x1p-14f);
        const float actual = fast.Get(x, y, c);
        if (!(std::abs(actual - expected) <= bound)) {
          ADD_FAILURE() << "(" << x << ", " << y << ") channel " << c << ": " << actual
                        << ", expected " << expected;
          return different;
        }
        different += actual != expected;
      }
    }
  }
  return different;
}

// A filter that reads samples, one that reads coefficients, and tables of more taps.
const std::vector<WarpOptions>& KindsOfFilters() {
  static const Table wide_tables[] = {
      Table(MakeWideTable(TableFormat::kI16, Footprint::k24).view()),
      Table(MakeWideTable(TableFormat::kI16, Footprint::k36).view())};
  static const std::vector<WarpOptions> kinds = {
      {.filter = Filter::kCatmullRom},
      {.filter = Filter::kSpline},
      {.filter = Filter::kLut, .table = &wide_tables[0]},
      {.filter = Filter::kLut, .table = &wide_tables[1]}};
  return kinds;
}

class WarpAccuracy : public testing::TestWithParam<PixelFormat> {};

TEST_P(WarpAccuracy, RandomMotionOfEverySize) {
  const TestTable stored = MakeKeysTable(TableFormat::kI16);
  const Table table(stored.view());
  for (const Size size :
       {Size{1, 1}, {3, 3}, {17, 5}, {4, 64}, {64, 4}, {131, 37}, {5, 6}, {6, 5}}) {
    for (const int padding : {0, 48}) {
      TestImage history(size.width, size.height, GetParam(), padding);
      history.Randomise(1);
      TestMotion motion(size.width, size.height, 0, 0, padding / 8);
      motion.Randomise(2, 4);
      for (const TestFilter& filter : TestFilters(&table)) {
        SCOPED_TRACE(filter.name + " " + std::to_string(size.width) + " x " +
                     std::to_string(size.height));
        const TestHistory read(history, filter.options);
        TestImage reference(size.width, size.height, GetParam(), padding);
        read.ReferenceTo(motion.view(), filter.options, reference);
        TestImage fast(size.width, size.height, GetParam(), padding);
        read.WarpTo(motion.view(), filter.options, fast);
        CountDifferent(fast, reference, read.Largest());
      }
    }
  }
}

TEST_P(WarpAccuracy, UniformAndWholeMotion) {
  const TestTable stored = MakeKeysTable(TableFormat::kI16);
  const Table table(stored.view());
  const float motions[][2] = {{0.3f, -1.7f}, {0.5f, 0.5f}, {-3, 2},           {0, 0.25f},
                              {-7.75f, 0},   {200, -100},  {-300.5f, 80.25f}, {1e30f, -1e6f}};
  TestImage history(151, 41, GetParam(), 16);
  history.Randomise(5);
  for (const auto& [mx, my] : motions) {
    const TestMotion motion(151, 41, mx, my);
    for (const TestFilter& filter : TestFilters(&table)) {
      SCOPED_TRACE(filter.name + " " + std::to_string(mx) + " " + std::to_string(my));
      const TestHistory read(history, filter.options);
      TestImage reference(151, 41, GetParam());
      read.ReferenceTo(motion.view(), filter.options, reference);
      TestImage fast(151, 41, GetParam());
      const WarpStats stats = read.WarpTo(motion.view(), filter.options, fast);
      EXPECT_EQ(stats[MotionKind::kGeneral], 0);
      CountDifferent(fast, reference, read.Largest());
      WarpOptions general = filter.options;
      general.general_only = true;
      const WarpStats all_general = read.WarpTo(motion.view(), general, fast);
      EXPECT_EQ(all_general[MotionKind::kGeneral], 9);
      CountDifferent(fast, reference, read.Largest());
    }
  }
}

TEST_P(WarpAccuracy, UniformMotionOfNarrowAndLowImages) {
  for (const Size size :
       {Size{1, 1}, {2, 5}, {5, 3}, {16, 7}, {19, 4}, {63, 8}, {67, 9}, {70, 13}}) {
    TestImage history(size.width, size.height, GetParam());
    history.Randomise(9);
    for (const float mx : {-2.4f, -0.4f, 0.4f, 2.4f}) {
      SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height) + ", motion " +
                   std::to_string(mx));
      const TestMotion motion(size.width, size.height, mx, 0.7f);
      for (const WarpOptions& options : KindsOfFilters()) {
        const TestHistory read(history, options);
        TestImage reference(size.width, size.height, GetParam());
        read.ReferenceTo(motion.view(), options, reference);
        TestImage fast(size.width, size.height, GetParam());
        read.WarpTo(motion.view(), options, fast);
        CountDifferent(fast, reference, read.Largest());
      }
    }
  }
}

// Where history and output lie in memory decides in which direction rows are walked.
TEST_P(WarpAccuracy, UniformMotionIsTheSameBitsAtEveryAddress) {
  constexpr int kWidth = 150;
  constexpr int kHeight = 21;
  constexpr int kPage = 4096;
  const int padding = kPage - kWidth * BytesPerPixel(GetParam());
  TestImage history(kWidth, kHeight, GetParam(), padding);
  history.Randomise(11);
  const auto page_offset = [](const void* data) {
    return static_cast<int>(reinterpret_cast<std::uintptr_t>(data) % kPage);
  };
  const WarpOptions options;
  for (const float mx : {-0.3f, 3.3f}) {
    const TestMotion motion(kWidth, kHeight, mx, -1.6f);
    TestImage expected(kWidth, kHeight, GetParam(), padding);
    Warp(history.history(), motion.view(), options, expected.view());
    for (const int apart : {-512, -128, -4, 0, 4, 20, 64, 512, 2048}) {
      std::vector<std::byte> bytes(std::size_t{kPage} * (kHeight + 1), std::byte{0xA5});
      const int shift = page_offset(history.view().data) + apart - page_offset(bytes.data());
      MutableImageView out = expected.view();
      out.data = bytes.data() + (shift + 2 * kPage) % kPage;
      Warp(history.history(), motion.view(), options, out);
      for (int y = 0; y < kHeight; ++y) {
        ASSERT_EQ(std::memcmp(out.At(0, y), expected.view().At(0, y),
                              static_cast<std::size_t>(kWidth) * BytesPerPixel(GetParam())),
                  0)
            << apart << " bytes apart, row " << y;
      }
    }
  }
}

TEST_P(WarpAccuracy, MotionThatIsNotFiniteOrFarOrTiny) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kUnusual[] = {kNan,  kInfinity, -kInfinity, 1e6f,   -1e6f,
                                1e30f, -1e30f,    0.25f,      1e-30f, 0};
  constexpr int kCount = static_cast<int>(std::size(kUnusual));
  TestImage history(kCount * kCount, 9, GetParam());
  history.Randomise(7);
  TestMotion motion(kCount * kCount, 9);
  for (int i = 0; i < kCount * kCount; ++i) {
    for (int y = 0; y < 9; ++y) motion.Set(i, y, kUnusual[i % kCount], kUnusual[i / kCount]);
  }
  for (const WarpOptions& options : KindsOfFilters()) {
    const TestHistory read(history, options);
    TestImage reference(kCount * kCount, 9, GetParam());
    read.ReferenceTo(motion.view(), options, reference);
    for (int y = 0; y < 9; ++y) {
      for (int c = 0; c < Channels(GetParam()); ++c) {
        EXPECT_EQ(reference.Get(0, y, c), history.Get(0, y, c)) << "NaN counts as zero";
      }
    }
    TestImage fast(kCount * kCount, 9, GetParam());
    read.WarpTo(motion.view(), options, fast);
    CountDifferent(fast, reference, read.Largest());
  }
}

// Products and sums that are flushed to zero.
TEST_P(WarpAccuracy, TexelsAboutTheLeastNormalNumber) {
  if (GetParam() != PixelFormat::kRgba32F && GetParam() != PixelFormat::kR32F) return;
  TestImage history(97, 21, GetParam());
  for (const float scale : {0x1p-100f, 0x1p-120f, 0x1p-126f, 0x1p-135f}) {
    history.Randomise(3);
    for (int y = 0; y < 21; ++y) {
      for (int i = 0; i < 97 * Channels(GetParam()); ++i) {
        history.Set(0, y, i, scale * history.Get(0, y, i));
      }
    }
    TestMotion motion(97, 21);
    motion.Randomise(4, 3);
    for (const WarpOptions& options : KindsOfFilters()) {
      const TestHistory read(history, options);
      TestImage reference(97, 21, GetParam());
      read.ReferenceTo(motion.view(), options, reference);
      TestImage fast(97, 21, GetParam());
      read.WarpTo(motion.view(), options, fast);
      CountDifferent(fast, reference, read.Largest());
    }
  }
}

TEST_P(WarpAccuracy, RowsInPartsAndTilesGivenAreTheSameBits) {
  constexpr int kWidth = 150;
  constexpr int kHeight = 3 * kTileHeight + 5;
  TestImage history(kWidth, kHeight, GetParam());
  history.Randomise(3);
  TestMotion motion(kWidth, kHeight, 0.3f, 0.7f);
  for (int y = kTileHeight; y < kTileHeight + 20; ++y) motion.Set(70, y, 1.5f, 0.1f * y);
  for (const WarpOptions& options : KindsOfFilters()) {
    const TestHistory read(history, options);
    TestImage whole(kWidth, kHeight, GetParam());
    read.WarpTo(motion.view(), options, whole);
    TestImage parts(kWidth, kHeight, GetParam());
    read.WarpRowsTo(motion.view(), options, 2 * kTileHeight, kHeight, parts);
    read.WarpRowsTo(motion.view(), options, 0, 2 * kTileHeight, parts);
    EXPECT_EQ(whole, parts);
  }
  const WarpOptions options;
  TestImage whole(kWidth, kHeight, GetParam());
  Warp(history.history(), motion.view(), options, whole.view());
  TestImage tiled(kWidth, kHeight, GetParam());
  Warp(history.history(), motion.view(), MotionTiles(motion.view()), options, tiled.view());
  EXPECT_EQ(whole, tiled);
}

INSTANTIATE_TEST_SUITE_P(Formats, WarpAccuracy, testing::ValuesIn(kPixelFormats),
                         [](const auto& test) { return std::string(Name(test.param)); });

TEST(WarpAccuracyRgba8, NearestLookupIsExact) {
  TestImage history(200, 120, PixelFormat::kRgba8);
  history.Randomise(1);
  TestMotion motion(200, 120);
  motion.Randomise(2, 6);
  for (const TableFormat format : kTableFormats) {
    const TestTable stored = MakeKeysTable(format, -0.7);
    const Table table(stored.view());
    for (const TestFilter& filter : TestFilters(&table)) {
      SCOPED_TRACE(std::string(Name(format)) + " " + filter.name);
      const TestHistory read(history, filter.options);
      TestImage reference(200, 120, PixelFormat::kRgba8);
      read.ReferenceTo(motion.view(), filter.options, reference);
      const bool exact = filter.options.filter == Filter::kLut &&
                         filter.options.lookup == Lookup::kNearest &&
                         !HasPrefilter(PrefilterOf(filter.options)) && format != TableFormat::kF32;
      TestImage fast(200, 120, PixelFormat::kRgba8);
      read.WarpTo(motion.view(), filter.options, fast);
      const int different = CountDifferent(fast, reference, read.Largest());
      EXPECT_LE(different, exact ? 0 : 200 * 120 * 4 / 1000);
    }
  }
}

}  // namespace
}  // namespace warplut
