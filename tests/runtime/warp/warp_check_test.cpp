// What IsValid and IsWarpable refuse, and with which words.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/runtime/warp/warp_fixture.h"

namespace warplut {
namespace {

TEST(WarpOptions, KeysParameterIsChecked) {
  const char* why = nullptr;
  WarpOptions options;
  options.filter = Filter::kKeys;
  EXPECT_TRUE(options.IsValid(&why));
  for (const float a : {-1.01f, 0.01f, std::numeric_limits<float>::quiet_NaN()}) {
    options.keys_a = a;
    EXPECT_FALSE(options.IsValid(&why));
    EXPECT_STREQ(why, "keys_a is outside of [-1, 0]");
    EXPECT_FALSE(options.IsValid(nullptr));
  }
  options.filter = Filter::kCatmullRom;
  EXPECT_TRUE(options.IsValid(&why));
}

TEST(WarpOptions, SplineParameterIsChecked) {
  const char* why = nullptr;
  WarpOptions options;
  options.filter = Filter::kSpline;
  for (const float k : {kLeastSplineK, 0.0f, kLargestSplineK}) {
    options.spline_k = k;
    EXPECT_TRUE(options.IsValid(&why));
    EXPECT_TRUE(IsValid(PrefilterOf(options), &why)) << why;
  }
  for (const float k : {-0.101f, 0.061f, std::numeric_limits<float>::quiet_NaN()}) {
    options.spline_k = k;
    EXPECT_FALSE(options.IsValid(&why));
    EXPECT_STREQ(why, "spline_k is outside of [-0.1, 0.06]");
  }
  options.filter = Filter::kCatmullRom;
  EXPECT_TRUE(options.IsValid(&why));
}

TEST(WarpOptions, PrefilterIsThatOfTheFilter) {
  const TestTable stored = MakeSplineTable(TableFormat::kI16, 0.01);
  const Table table(stored.view());
  WarpOptions options;
  options.table = &table;
  options.spline_k = 0.01f;
  for (const FilterInfo& info : kFilters) {
    options.filter = info.filter;
    const Prefilter prefilter = PrefilterOf(options);
    EXPECT_EQ(HasPrefilter(prefilter), MayHavePrefilter(info.filter)) << info.name;
    if (!HasPrefilter(prefilter)) continue;
    EXPECT_EQ(prefilter.kind, PrefilterKind::kRecursive);
    EXPECT_FLOAT_EQ(prefilter.side, static_cast<float>(SplineSide(0.01)));
  }
}

TEST(WarpOptions, LutNeedsATable) {
  const char* why = nullptr;
  WarpOptions options;
  options.filter = Filter::kLut;
  EXPECT_FALSE(options.IsValid(&why));
  EXPECT_STREQ(why, "the lut filter has no table");
}

struct Views {
  ImageView history;
  MotionView motion;
  MutableImageView out;
};

struct Refusal {
  const char* why;
  std::function<void(Views&)> spoil;
};

TEST(IsWarpable, SaysWhyNot) {
  const Refusal refusals[] = {
      {"history, motion or output has no data", [](Views& v) { v.history.data = nullptr; }},
      {"history, motion or output has no data", [](Views& v) { v.motion.xy = nullptr; }},
      {"history, motion or output has no data", [](Views& v) { v.out.data = nullptr; }},
      {"the history is empty", [](Views& v) { v.history.width = 0; }},
      {"the history is larger than kLargestSize",
       [](Views& v) { v.history.height = kLargestSize + 1; }},
      {"motion and history differ in size", [](Views& v) { v.motion.height = 2; }},
      {"output and history differ in size", [](Views& v) { v.out.width = 4; }},
      {"output and history differ in format", [](Views& v) { v.out.format = PixelFormat::kR32F; }},
      {"the stride of history or output is less than a row", [](Views& v) { v.out.stride = 79; }},
      {"the stride of history or output is not whole channels",
       [](Views& v) { v.history.stride = 82; }},
      {"the stride of the motion is less than a row or not whole floats",
       [](Views& v) { v.motion.stride = 42; }},
  };
  TestImage history(5, 3, PixelFormat::kRgba32F);
  TestImage out(5, 3, PixelFormat::kRgba32F);
  const TestMotion motion(5, 3);
  const Views good = {history.history(), motion.view(), out.view()};
  const char* why = nullptr;
  EXPECT_TRUE(IsWarpable(good.history, good.motion, good.out, &why));
  for (const Refusal& refusal : refusals) {
    Views views = good;
    refusal.spoil(views);
    EXPECT_FALSE(IsWarpable(views.history, views.motion, views.out, &why)) << refusal.why;
    EXPECT_STREQ(why, refusal.why);
  }
}

TEST(IsWarpable, SaysWhyNotOfCoefficients) {
  const struct {
    const char* why;
    std::function<void(PrefilteredImage&)> spoil;
  } refusals[] = {
      {"the history is empty", [](PrefilteredImage& p) { p.samples.width = 0; }},
      {"the coefficients have no data", [](PrefilteredImage& p) { p.coefficients.data = nullptr; }},
      {"coefficients and samples differ in size",
       [](PrefilteredImage& p) { p.coefficients.height = 2; }},
      {"the coefficients are not in the format of those of the samples",
       [](PrefilteredImage& p) { p.coefficients.format = PixelFormat::kRgba8; }},
      {"the stride of the coefficients is less than a row",
       [](PrefilteredImage& p) { p.coefficients.stride = 38; }},
      {"the stride of the coefficients is not whole channels",
       [](PrefilteredImage& p) { p.coefficients.stride = 41; }},
  };
  TestImage samples(5, 3, PixelFormat::kRgba8);
  TestImage coefficients(5, 3, PixelFormat::kRgba16F);
  TestImage out(5, 3, PixelFormat::kRgba8);
  const TestMotion motion(5, 3);
  const PrefilteredImage good = {samples.history(), coefficients.history()};
  const char* why = nullptr;
  EXPECT_TRUE(IsWarpable(good, motion.view(), out.view(), &why));
  for (const auto& refusal : refusals) {
    PrefilteredImage image = good;
    refusal.spoil(image);
    EXPECT_FALSE(IsWarpable(image, motion.view(), out.view(), &why)) << refusal.why;
    EXPECT_STREQ(why, refusal.why);
    EXPECT_FALSE(IsWarpable(image, motion.view(), out.view(), nullptr));
  }
}

TEST(Filters, NamesAreUnique) {
  for (const FilterInfo& a : kFilters) {
    for (const FilterInfo& b : kFilters) {
      EXPECT_EQ(std::string(a.name) == b.name, a.filter == b.filter);
    }
  }
}

}  // namespace
}  // namespace warplut
