#include "tools/judge/images/protocol_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "luts/quantize/quantize.h"
#include "luts/quantize/real_table.h"
#include "tests/datasets/expect_error.h"
#include "tests/tools/test_images.h"

namespace warplut {
namespace {

const ProtocolOptions kOptions{.trajectories = 2, .seed = 3, .on_warps = {}};

double Score(const std::string& filter, const Protocol& protocol,
             const std::vector<Image>& images) {
  return ProtocolScore(NamedFilter(filter), protocol, images, kOptions);
}

Image SmoothImage() {
  Image image(80, 80, 1);
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 80; ++x) {
      image.at(x, y) = static_cast<float>(0.5 + 0.3 * std::sin(0.7 * x) * std::cos(0.5 * y));
    }
  }
  return image;
}

TEST(NamedFilter, RefusesWhatIsNoFilter) {
  for (const char* name :
       {"",          "lut",        "keys",       "keys:",         "keys:x",     "keys:-0.5x",
        "keys:-1.5", "keys:nan",   "Bilinear",   "spline",        "spline:",    "spline:1",
        "spline:1/", "spline:/84", "spline:1/0", "spline:1/84/2", "spline:nan", "spline:0/0",
        "o-moms:1",  "kaiser6",    "kaiser6:",   "kaiser6:-1",    "kaiser6:33", "kaiser6:inf",
        "lanczos",   "lanczos3:1"}) {
    ExpectError([&] { NamedFilter(name); }, {std::string("'") + name + "'", "is not a filter"});
  }
}

TEST(NamedWarp, ReadsNumbersAndFractions) {
  EXPECT_EQ(NamedWarp("spline:1/84")->spline_k, 1.0f / 84);
  EXPECT_EQ(NamedWarp("spline:-0.01")->spline_k, -0.01f);
  EXPECT_EQ(NamedWarp("o-moms")->spline_k, NamedWarp("spline:1/42")->spline_k);
  EXPECT_EQ(NamedWarp("o-moms")->filter, Filter::kSpline);
  EXPECT_EQ(NamedWarp("keys:-0.58")->keys_a, -0.58f);
  EXPECT_FALSE(NamedWarp("kaiser6:4.5")) << "no warp of the runtime";
  EXPECT_FALSE(NamedWarp("lanczos3"));
}

TEST(NamedFilter, TheSharperKeepMoreOfASmoothImage) {
  const std::vector<Image> images = {SmoothImage()};
  const Protocol half{.warps = 24, .offsets = Offsets::kHalf};
  const double catmull_rom = Score("catmull-rom", half, images);
  EXPECT_GT(Score("o-moms", half, images), catmull_rom);
  EXPECT_GT(Score("spline:0", half, images), catmull_rom);
  EXPECT_GT(Score("kaiser6:4.5", half, images), catmull_rom);
  EXPECT_GT(Score("lanczos3", half, images), catmull_rom);
}

TEST(NamedFilter, KeepAConstantImage) {
  Image constant(48, 48, 1);
  std::fill(constant.data.begin(), constant.data.end(), 0.7f);
  for (const char* name : {"spline:1/84", "o-moms", "kaiser6:4.5", "lanczos3"}) {
    Image out(48, 48, 1);
    NamedFilter(name).warp(constant, {0.3, -0.8}, out);
    for (const float value : out.data) ASSERT_NEAR(value, 0.7f, 1e-5f) << name;
  }
}

TEST(NamedFilter, WholePixelsAreCopied) {
  const Image image = WavyImage(48, 48, 1);
  for (const char* name : {"spline:1/84", "kaiser6:4.5", "lanczos3"}) {
    Image out(48, 48, 1);
    NamedFilter(name).warp(image, {1, -2}, out);
    for (int x = 5; x < 43; ++x) EXPECT_EQ(out.at(x, 20), image.at(x - 1, 22)) << name;
  }
}

// The gain of the B-spline is 1: the energy about the mean never grows. The values stay near their
// range, even where nothing clamps them.
TEST(NamedFilter, TheBSplineIsBoundedAfterManyWarps) {
  Image image = WavyImage(64, 64, 1), next(64, 64, 1);
  const ProtocolFilter spline = NamedFilter("spline:0");
  for (int warp = 0; warp < 1000; ++warp) {
    spline.warp(image, {warp % 2 == 0 ? 0.5 : -0.5, warp % 2 == 0 ? 0.25 : -0.25}, next);
    std::swap(image, next);
  }
  for (const float value : image.data) {
    ASSERT_GT(value, 0.1f);
    ASSERT_LT(value, 0.9f);
  }
}

// A table of the spline's weights with the spline's prefilter is the spline, at its nodes.
TEST(RuntimeFilter, RunsThePrefilterOfATable) {
  const WarpOptions spline = *NamedWarp("spline:1/84");
  const auto k = static_cast<double>(spline.spline_k);
  RealTable real = SampleWeights("spline", kNodes,
                                 [&](double dx, double dy) { return SplineWeights(k, dx, dy); });
  real.prefilter = PrefilterOf(spline);
  const BakedTable baked = Quantize(real, TableFormat::kF32);
  const Table table(baked.view());
  const Image image = WavyImage(48, 48, 1);
  Image expected(48, 48, 1), out(48, 48, 1);
  RuntimeFilter("spline", spline).warp(image, {0.25, -0.75}, expected);
  RuntimeFilter("lut", {.filter = Filter::kLut, .table = &table}).warp(image, {0.25, -0.75}, out);
  for (std::size_t i = 0; i < out.data.size(); ++i) {
    ASSERT_NEAR(out.data[i], expected.data[i], 1e-5f);
  }
}

}  // namespace
}  // namespace warplut
