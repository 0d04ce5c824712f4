// The formulas of the plain passes.
#include "runtime/sr/reference.h"

#include <vector>

#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

// A job over one frame, with everything that the plain passes read.
class TestJob {
 public:
  TestJob(const SuperResolutionOptions& chosen, const TestFrame& frame)
      : options(chosen),
        x(options.render_width, options.output_width),
        y(options.render_height, options.output_height),
        planes(options.render_width, options.render_height),
        nearest(options.render_width, options.render_height),
        farthest(options.render_width, options.render_height) {
    const RenderedFrame view = frame.View();
    x.SetJitter(view.jitter_x);
    y.SetJitter(view.jitter_y);
    FillPlanesReference(options, view, view.motion, 0, options.render_height, planes);
    DepthRangeReference(planes.depth, 0, options.render_height, nearest, farthest);
  }

  SrJob View() const {
    return {.options = options,
            .x = x,
            .y = y,
            .planes = planes,
            .nearest_before = nearest,
            .farthest_before = farthest,
            .reactive_before = reactive,
            .x_before = x.AsBefore(),
            .y_before = y.AsBefore(),
            .has_history = true,
            .history = {},
            .coefficients = {},
            .next = {},
            .next_state = {},
            .residual = nullptr,
            .aliasing = nullptr};
  }

  SuperResolutionOptions options;
  AxisMap x, y;
  RenderPlanes planes;
  Plane nearest, farthest, reactive;
};

TEST(Planes, BrokenValuesBecomeOrdinaryOnes) {
  TestFrame frame(4, 1);
  frame.SetColor(0, 0, kNaN, kInfinity, -kInfinity);
  frame.SetColor(1, 0, -0.5f, 1.5f, 0.25f);
  frame.Depth(0, 0) = kNaN;
  frame.Depth(1, 0) = -1;
  frame.Depth(2, 0) = kInfinity;
  frame.SetMotion(0, 0, kNaN, 1);
  frame.SetMotion(1, 0, 1, -kInfinity);
  frame.SetMotion(2, 0, 3, 4);
  const TestJob job(TestOptions(4, 1, 4, 1), frame);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(job.planes.color[c].Row(0)[0], 0.0f);
  EXPECT_EQ(job.planes.color[0].Row(0)[1], 0.0f);
  EXPECT_EQ(job.planes.color[1].Row(0)[1], 1.0f);
  EXPECT_EQ(job.planes.color[2].Row(0)[1], 0.25f);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(job.planes.depth.Row(0)[i], kFarthestDepth);
  EXPECT_EQ(job.planes.depth.Row(0)[3], 0.5f);
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(std::isnan(job.planes.motion_x.Row(0)[i]));
    EXPECT_TRUE(std::isnan(job.planes.motion_y.Row(0)[i]));
  }
  EXPECT_EQ(job.planes.motion_x.Row(0)[2], 3.0f);
}

TEST(Planes, LinearHdrIsToneMappedAndComesBack) {
  for (const float value : {0.0f, 0.25f, 1.0f, 20.0f, 5000.0f}) {
    float rgb[3] = {value, 0.5f * value, 0.125f * value};
    EncodeColor(ColorEncoding::kLinearHdr, rgb);
    for (const float channel : rgb) EXPECT_LE(channel, 1.0f);
    DecodeColor(ColorEncoding::kLinearHdr, rgb);
    EXPECT_NEAR(rgb[0], value, 1e-3f * value);
    EXPECT_NEAR(rgb[1], 0.5f * value, 1e-3f * value);
  }
}

// A near surface left of column 4, moving by (1, 2); a far one that rises to the right and moves
// with it.
TestFrame TwoSurfaces() {
  TestFrame frame(8, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const auto fx = static_cast<float>(x);
      frame.Depth(x, y) = x < 4 ? 0.1f : 0.5f + 0.005f * fx;
      frame.SetMotion(x, y, x < 4 ? 1.0f : 0.1f * fx, x < 4 ? 2.0f : 0.0f);
    }
  }
  return frame;
}

TEST(Surface, EdgeAwareIsBilinearInsideAndTheNearestSurfaceAtEdges) {
  const TestJob job(TestOptions(8, 8, 16, 16), TwoSurfaces());
  // Output pixel 11 lies at 5.25 among the samples.
  const Surface inside = SurfaceAt(job.View(), 11, 6);
  EXPECT_NEAR(inside.depth, 0.5f + 0.005f * 5.25f, 1e-6f);
  EXPECT_NEAR(inside.motion_x, 0.525f, 1e-6f);
  // Output pixels 7 and 8 lie between the samples 3 and 4.
  for (const int x : {7, 8}) {
    const Surface edge = SurfaceAt(job.View(), x, 6);
    EXPECT_EQ(edge.depth, 0.1f);
    EXPECT_EQ(edge.motion_x, 1.0f);
    EXPECT_EQ(edge.motion_y, 2.0f);
  }
}

TEST(Surface, NearestTakesTheSampleAndDilatedTheNearestOfNine) {
  SuperResolutionOptions options = TestOptions(8, 8, 16, 16);
  options.motion = MotionUpsampling::kNearest;
  EXPECT_EQ(SurfaceAt(TestJob(options, TwoSurfaces()).View(), 8, 6).motion_x, 0.4f);
  options.motion = MotionUpsampling::kDilated;
  EXPECT_EQ(SurfaceAt(TestJob(options, TwoSurfaces()).View(), 8, 6).motion_x, 1.0f);
  EXPECT_EQ(SurfaceAt(TestJob(options, TwoSurfaces()).View(), 11, 6).motion_x, 0.4f);
}

TEST(Surface, MotionThatIsMissingIsNotMixed) {
  TestFrame frame(4, 4);
  frame.SetMotion(0.5f, 0.5f);
  frame.SetMotion(2, 1, kNaN, 0);
  const TestJob job(TestOptions(4, 4, 8, 8), frame);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const float m = SurfaceAt(job.View(), x, y).motion_x;
      EXPECT_TRUE(std::isnan(m) || m == 0.5f) << x << ", " << y;
      EXPECT_EQ(std::isnan(m), x / 2 == 2 && y / 2 == 1) << x << ", " << y;
    }
  }
}

TEST(Validity, NeedsAPositionInTheImageAndADepthThatWasSeen) {
  const TestJob job(TestOptions(8, 8, 16, 16), TwoSurfaces());
  const SrJob view = job.View();
  EXPECT_EQ(ValidityReference(view, 2, 2, 0.1f, 0, 0), 1.0f);
  EXPECT_EQ(ValidityReference(view, 2, 2, 0.1f, 3, 0), 0.0f);    // left of the image
  EXPECT_EQ(ValidityReference(view, 2, 2, 0.1f, 0, -14), 0.0f);  // below it
  EXPECT_EQ(ValidityReference(view, 2, 2, 0.1f, kNaN, 0), 0.0f);
  EXPECT_EQ(ValidityReference(view, 2, 2, 0.5f, 0, 0), 0.0f);   // something nearer was there
  EXPECT_EQ(ValidityReference(view, 8, 2, 0.53f, 0, 0), 1.0f);  // both surfaces are near by
}

TEST(Validity, MeasuresAreThoseOfTheGates) {
  SuperResolutionOptions options = TestOptions(8, 8, 8, 8);
  TestFrame frame(8, 8);  // at depth 0.5
  options.parameters.sr_depth_threshold = 0.1f;
  const TestJob relative(options, frame);
  EXPECT_EQ(ValidityReference(relative.View(), 3, 3, 0.549f, 0, 0), 1.0f);
  EXPECT_EQ(ValidityReference(relative.View(), 3, 3, 0.551f, 0, 0), 0.0f);
  EXPECT_EQ(ValidityReference(relative.View(), 3, 3, 0.1f, 0, 0), 1.0f);  // nothing hid it
  options.depth = DepthMeasure::kAbsolute;
  const TestJob absolute(options, frame);
  EXPECT_EQ(ValidityReference(absolute.View(), 3, 3, 0.59f, 0, 0), 1.0f);
  EXPECT_EQ(ValidityReference(absolute.View(), 3, 3, 0.61f, 0, 0), 0.0f);
  EXPECT_EQ(ValidityReference(absolute.View(), 3, 3, 0.39f, 0, 0), 0.0f);
  options.gate_width = 0.5f;
  const TestJob soft(options, frame);
  EXPECT_NEAR(ValidityReference(soft.View(), 3, 3, 0.6f, 0, 0), 0.5f, 1e-5f);
  options.depth = DepthMeasure::kNone;
  const TestJob none(options, frame);
  EXPECT_EQ(ValidityReference(none.View(), 3, 3, 0.9f, 0, 0), 1.0f);
}

TEST(ColorBox, HoldsTheNeighbourhoodOfASample) {
  SuperResolutionOptions options = TestOptions(5, 5, 10, 10);
  TestFrame frame(5, 5);
  frame.SetColor(2, 2, 0.8f, 0.1f, 0.5f);
  options.clamp = ColorClamp::kBox;
  const ColorBox box = SampleColorBox(TestJob(options, frame).View(), 1, 1);
  EXPECT_EQ(box.low.c[0], 0.5f);
  EXPECT_EQ(box.high.c[0], 0.8f);
  EXPECT_EQ(box.low.c[1], 0.1f);
  options.clamp = ColorClamp::kVariance;
  options.parameters.clamp_gamma = 2;
  const ColorBox variance = SampleColorBox(TestJob(options, frame).View(), 1, 1);
  const float weight = kBoxSide * kBoxSide;
  const float mean = 0.5f + 0.3f * weight;
  const float sigma = 0.3f * std::sqrt(weight * (1 - weight));
  EXPECT_NEAR(variance.low.c[0], mean - 2 * sigma, 1e-5f);
  EXPECT_NEAR(variance.high.c[0], mean + 2 * sigma, 1e-5f);
  options.clamp = ColorClamp::kNone;
  const ColorBox none = SampleColorBox(TestJob(options, frame).View(), 1, 1);
  EXPECT_EQ(none.low.c[0], 0.0f);
  EXPECT_EQ(none.high.c[0], 1.0f);
}

TEST(ColorBox, IsBilinearBetweenSamples) {
  TestFrame frame(5, 5);
  frame.SetColor(2, 2, 0.8f, 0.1f, 0.5f);
  for (const ColorClamp clamp : {ColorClamp::kBox, ColorClamp::kVariance}) {
    SuperResolutionOptions options = TestOptions(5, 5, 10, 10);
    options.clamp = clamp;
    const TestJob job(options, frame);
    // Output pixel 3 lies at 1.25 among the samples, 1 at 0.25.
    const auto low = [&](int i, int j) { return SampleColorBox(job.View(), i, j).low.c[1]; };
    const float upper = low(1, 0) + 0.25f * (low(2, 0) - low(1, 0));
    const float lower = low(1, 1) + 0.25f * (low(2, 1) - low(1, 1));
    EXPECT_NEAR(ColorBoxAt(job.View(), 3, 1).low.c[1], upper + 0.25f * (lower - upper), 1e-6f);
    // Beyond the outermost samples the box is theirs.
    EXPECT_NEAR(ColorBoxAt(job.View(), 9, 9).low.c[1], low(4, 4), 1e-6f);
  }
}

TEST(CurrentFrame, ReproducesALinearImageAtItsJitter) {
  for (const CurrentFrame current : {CurrentFrame::kBilinear, CurrentFrame::kBicubic}) {
    SuperResolutionOptions options = TestOptions(12, 12, 18, 24);
    options.current = current;
    TestFrame frame(12, 12);
    frame.jitter_x = 0.3f;
    frame.jitter_y = -0.4f;
    const auto value = [](float u, float v) { return 0.1f + 0.03f * u + 0.02f * v; };
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 12; ++x) {
        const float v = value(static_cast<float>(x) + 0.5f + frame.jitter_x,
                              static_cast<float>(y) + 0.5f + frame.jitter_y);
        frame.SetColor(x, y, v, v, v);
      }
    }
    const TestJob job(options, frame);
    for (int y = 5; y < 19; ++y) {
      for (int x = 4; x < 14; ++x) {
        EXPECT_NEAR(
            CurrentFrameAt(job.View(), x, y).c[1],
            value((static_cast<float>(x) + 0.5f) / 1.5f, (static_cast<float>(y) + 0.5f) / 2),
            1e-5f);
      }
    }
  }
}

}  // namespace
}  // namespace warplut
