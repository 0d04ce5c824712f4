// The fast passes against the plain ones.
#include <string>
#include <vector>

#include "tests/image_difference.h"
#include "tests/runtime/sr/sr_fixture.h"
#include "tests/runtime/warp/warp_fixture.h"

namespace warplut {
namespace {

struct Grid {
  int render_width, render_height, output_width, output_height;
};
// Scales 1, 1.3, 1.5, 1.7, 2, 3, 4 and different ones in x and y; sizes of one pixel, odd, and
// larger than a tile.
constexpr Grid kGrids[] = {{1, 1, 1, 1},      {1, 1, 4, 3},      {3, 3, 3, 3},     {3, 3, 6, 6},
                           {17, 5, 22, 7},    {20, 30, 30, 45},  {41, 21, 70, 36}, {45, 27, 90, 54},
                           {35, 19, 105, 57}, {33, 17, 132, 68}, {40, 24, 60, 96}};

// Runs both for some frames of random surfaces. In these frames no gate is so near its threshold
// that rounding would decide it.
void ExpectEqual(SuperResolutionOptions options, float tolerance,
                 PixelFormat format = PixelFormat::kRgba32F) {
  std::string why;
  ASSERT_TRUE(options.IsValid(&why)) << why;
  SerialExecutor executor;
  SuperResolution fast(options, executor);
  options.reference = true;
  SuperResolution plain(options, executor);
  ImageBuffer fast_out = OutputOf(options);
  ImageBuffer plain_out = OutputOf(options);
  TestFrame frame(options.render_width, options.render_height, format);
  for (unsigned i = 0; i < 4; ++i) {
    frame.Randomise(i, i == 2);
    fast.Process(frame.View(), fast_out.view());
    plain.Process(frame.View(), plain_out.view());
    ASSERT_LE(Compare(fast_out.view(), plain_out.view()).largest, tolerance) << "frame " << i;
    const OutputGeometry a = fast.Geometry();
    const OutputGeometry b = plain.Geometry();
    for (int y = 0; y < options.output_height; ++y) {
      for (int x = 0; x < options.output_width; ++x) {
        const float za = a.depth.Row<float>(y)[x];
        const float zb = b.depth.Row<float>(y)[x];
        ASSERT_NEAR(za, zb, 1e-5f * std::max(za, zb)) << x << ", " << y;
        for (int c = 0; c < 2; ++c) {
          const float ma = a.motion.Row(y)[2 * x + c];
          const float mb = b.motion.Row(y)[2 * x + c];
          ASSERT_EQ(std::isnan(ma), std::isnan(mb)) << x << ", " << y;
          if (std::isnan(ma)) continue;
          ASSERT_NEAR(ma, mb, 1e-4f) << x << ", " << y;
        }
      }
    }
  }
}

constexpr float kFloatTolerance = 1e-4f;
constexpr float kHalfTolerance = 2e-3f;
constexpr float kCodeTolerance = 2.5f / 255.0f;

TEST(FastPasses, EqualTheReferenceAtEveryScaleAndSize) {
  for (const Grid& g : kGrids) {
    SCOPED_TRACE(testing::Message() << g.render_width << " x " << g.render_height << " to "
                                    << g.output_width << " x " << g.output_height);
    ExpectEqual(TestOptions(g.render_width, g.render_height, g.output_width, g.output_height),
                kHalfTolerance);
  }
}

TEST(FastPasses, EqualTheReferenceWithTablesOfMoreTaps) {
  for (const Footprint footprint : {Footprint::k24, Footprint::k36}) {
    const Table table(MakeWideTable(TableFormat::kI16, footprint).view());
    for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear}) {
      for (const Grid& g : {Grid{1, 1, 4, 3}, {3, 3, 6, 6}, {45, 27, 90, 54}}) {
        SCOPED_TRACE(testing::Message() << TapCount(footprint) << " taps, " << g.output_width
                                        << " x " << g.output_height);
        SuperResolutionOptions options =
            TestOptions(g.render_width, g.render_height, g.output_width, g.output_height);
        options.warp = {.filter = Filter::kLut, .table = &table, .lookup = lookup};
        ExpectEqual(options, kHalfTolerance);
      }
    }
  }
}

TEST(FastPasses, EqualTheReferenceInEveryMode) {
  const SuperResolutionOptions base = TestOptions(41, 21, 70, 52);
  std::vector<SuperResolutionOptions> list;
  for (const HistoryForm form :
       {HistoryForm::kSample, HistoryForm::kResidual, HistoryForm::kAdaptive}) {
    for (const ColorClamp clamp : {ColorClamp::kNone, ColorClamp::kBox, ColorClamp::kVariance}) {
      for (const DepthMeasure depth :
           {DepthMeasure::kNone, DepthMeasure::kAbsolute, DepthMeasure::kRelative}) {
        for (const MotionUpsampling motion :
             {MotionUpsampling::kNearest, MotionUpsampling::kDilated, MotionUpsampling::kEdgeAware,
              MotionUpsampling::kStatic}) {
          for (const CurrentFrame current : {CurrentFrame::kBilinear, CurrentFrame::kBicubic}) {
            SuperResolutionOptions options = base;
            options.form = form;
            options.clamp = clamp;
            options.depth = depth;
            options.motion = motion;
            options.current = current;
            options.gate_width = motion == MotionUpsampling::kDilated ? 0.8f : 0.0f;
            options.history_format = PixelFormat::kRgba32F;
            list.push_back(options);
          }
        }
      }
    }
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    SCOPED_TRACE(testing::Message() << "mode " << i);
    ExpectEqual(list[i], kFloatTolerance);
  }
}

TEST(FastPasses, EqualTheReferenceWithAShareOfCoherentResiduals) {
  for (const HistoryForm form : {HistoryForm::kResidual, HistoryForm::kAdaptive}) {
    for (const Grid& g : kGrids) {
      SCOPED_TRACE(testing::Message() << g.render_width << " x " << g.render_height << " to "
                                      << g.output_width << " x " << g.output_height);
      SuperResolutionOptions options =
          TestOptions(g.render_width, g.render_height, g.output_width, g.output_height);
      options.form = form;
      options.coherent_share = 0.7f;
      options.history_format = PixelFormat::kRgba32F;
      ExpectEqual(options, kFloatTolerance);
    }
  }
}

TEST(FastPasses, EqualTheReferenceInEveryFormat) {
  struct Tolerance {
    PixelFormat format;
    float value;
  };
  for (const Tolerance& history : {Tolerance{PixelFormat::kRgba8, kCodeTolerance},
                                   Tolerance{PixelFormat::kRgba16F, kHalfTolerance},
                                   Tolerance{PixelFormat::kRgba32F, kFloatTolerance}}) {
    for (const PixelFormat color :
         {PixelFormat::kRgba8, PixelFormat::kRgba16F, PixelFormat::kRgba32F}) {
      SCOPED_TRACE(testing::Message() << Name(history.format) << ", " << Name(color));
      SuperResolutionOptions options = TestOptions(37, 23, 63, 46);
      options.history_format = history.format;
      ExpectEqual(options, history.value, color);
    }
  }
}

TEST(FastPasses, EqualTheReferenceOnLinearHdr) {
  SuperResolutionOptions options = TestOptions(37, 23, 74, 46);
  options.encoding = ColorEncoding::kLinearHdr;
  options.history_format = PixelFormat::kRgba32F;
  // At most 1.5 comes in, so that the tone map's slope is at most 6.25 on the way out.
  ExpectEqual(options, 6.25f * kFloatTolerance);
}

TEST(FastPasses, EqualTheReferenceWithoutHistory) {
  SuperResolutionOptions options = TestOptions(37, 23, 74, 46);
  options.history = false;
  ExpectEqual(options, kHalfTolerance);
}

}  // namespace
}  // namespace warplut
