// What accumulation does over frames.
#include <vector>

#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

// A detailed picture that moves as one: value at output position (u, v).
float Picture(double u, double v) {
  return static_cast<float>(0.5 + 0.2 * std::sin(1.9 * u + 0.3 * v) + 0.2 * std::cos(1.3 * v));
}

constexpr int kWidth = 48, kHeight = 32;  // of the render grid
constexpr double kScale = 2;
// The 2 x 2 texels of an output pixel at x2.
constexpr float kJitterX[4] = {-0.25f, 0.25f, 0.25f, -0.25f};
constexpr float kJitterY[4] = {-0.25f, 0.25f, -0.25f, 0.25f};

void Render(int index, double pan, TestFrame& frame) {
  frame.jitter_x = kJitterX[index % 4];
  frame.jitter_y = kJitterY[index % 4];
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float v = Picture((x + 0.5 + frame.jitter_x) * kScale - pan * index,
                              (y + 0.5 + frame.jitter_y) * kScale);
      frame.SetColor(x, y, v, v, v);
    }
  }
  frame.SetMotion(static_cast<float>(pan / kScale), 0);
}

double MeanError(const ImageBuffer& out, double shift) {
  double sum = 0;
  int count = 0;
  for (int y = 12; y < 2 * kHeight - 12; ++y) {
    for (int x = 12; x < 2 * kWidth - 12; ++x, ++count) {
      sum += std::abs(At(out, x, y, 0) - Picture(x + 0.5 - shift, y + 0.5));
    }
  }
  return sum / count;
}

SuperResolutionOptions Options() { return TestOptions(kWidth, kHeight, 2 * kWidth, 2 * kHeight); }

double ErrorAfter(const SuperResolutionOptions& options, int frames, double pan) {
  SerialExecutor executor;
  SuperResolution sr(options, executor);
  ImageBuffer out = OutputOf(options);
  TestFrame frame(kWidth, kHeight);
  for (int i = 0; i < frames; ++i) {
    Render(i, pan, frame);
    sr.Process(frame.View(), out.view());
  }
  return MeanError(out, pan * (frames - 1));
}

TEST(History, ResolvesWhatOneFrameCannot) {
  SuperResolutionOptions options = Options();
  options.clamp = ColorClamp::kNone;
  for (const HistoryForm form : {HistoryForm::kResidual, HistoryForm::kSample}) {
    options.form = form;
    // b > 1: a sample enters where it lies.
    options.parameters.blend_a = form == HistoryForm::kSample ? 6.0f : 0.9f;
    options.parameters.blend_b = form == HistoryForm::kSample ? 3.0f : 0.9f;
    SuperResolutionOptions alone = options;
    alone.history = false;
    for (const double pan : {0.0, 2.0}) {
      EXPECT_LT(ErrorAfter(options, 12, pan), 0.35 * ErrorAfter(alone, 12, pan))
          << static_cast<int>(form) << ", pan " << pan;
    }
  }
}

// Detail of this contrast is taken for aliasing in part until the history has it.
TEST(History, AdaptiveFormResolvesMostOfIt) {
  SuperResolutionOptions options = Options();
  options.clamp = ColorClamp::kNone;
  options.form = HistoryForm::kAdaptive;
  SuperResolutionOptions alone = options;
  alone.history = false;
  for (const double pan : {0.0, 2.0}) {
    EXPECT_LT(ErrorAfter(options, 16, pan), 0.5 * ErrorAfter(alone, 16, pan)) << pan;
  }
}

TEST(History, CutResetAndFirstFrameAreTheCurrentFrameAlone) {
  SuperResolutionOptions options = Options();
  SerialExecutor executor;
  TestFrame first(kWidth, kHeight);
  TestFrame second(kWidth, kHeight);
  first.Randomise(1);
  second.Randomise(2);
  ImageBuffer fresh = OutputOf(options);
  SuperResolution(options, executor).Process(second.View(), fresh.view());

  ImageBuffer out = OutputOf(options);
  SuperResolution sr(options, executor);
  sr.Process(first.View(), out.view());
  sr.Process(second.View(), out.view());
  EXPECT_FALSE(SameBits(out, fresh));
  sr.Process(first.View(), out.view());
  sr.Reset();
  sr.Process(second.View(), out.view());
  EXPECT_TRUE(SameBits(out, fresh));
  sr.Process(first.View(), out.view());
  second.cut = true;
  sr.Process(second.View(), out.view());
  EXPECT_TRUE(SameBits(out, fresh));
}

TEST(History, GeometryTellsFramesThatShareNothingWithOneBefore) {
  for (const bool history : {true, false}) {
    SuperResolutionOptions options = Options();
    options.history = history;
    SerialExecutor executor;
    TestFrame frame(kWidth, kHeight);
    ImageBuffer out = OutputOf(options);
    SuperResolution sr(options, executor);
    const auto is_cut = [&](bool cut) {
      frame.cut = cut;
      sr.Process(frame.View(), out.view());
      return sr.Geometry().cut;
    };
    EXPECT_TRUE(is_cut(false));
    EXPECT_FALSE(is_cut(false));
    EXPECT_TRUE(is_cut(true));
    EXPECT_FALSE(is_cut(false));
    sr.Reset();
    EXPECT_FALSE(sr.Geometry().cut) << "of the frame before";
    EXPECT_TRUE(is_cut(false));
    EXPECT_FALSE(is_cut(false));
  }
}

TEST(History, IsNotUsedWhereMotionIsMissing) {
  SuperResolutionOptions options = Options();
  SerialExecutor executor;
  TestFrame first(kWidth, kHeight);
  TestFrame second(kWidth, kHeight);
  first.Randomise(1);
  second.Randomise(2);
  second.SetMotion(kNaN, 0);
  ImageBuffer fresh = OutputOf(options);
  SuperResolution(options, executor).Process(second.View(), fresh.view());
  ImageBuffer out = OutputOf(options);
  SuperResolution sr(options, executor);
  sr.Process(first.View(), out.view());
  sr.Process(second.View(), out.view());
  EXPECT_TRUE(SameBits(out, fresh));
  for (int y = 0; y < options.output_height; ++y) {
    for (int x = 0; x < 2 * options.output_width; ++x) {
      ASSERT_TRUE(std::isnan(sr.Geometry().motion.Row(y)[x - x % 2]));
    }
  }
}

// A post that samples hit in every other frame: no surface came from behind another.
TEST(History, IsKeptWhereSamplesHitAThinObjectAgain) {
  for (const bool reference : {false, true}) {
    SuperResolutionOptions options = Options();
    options.reference = reference;
    SuperResolutionOptions ungated = options;
    ungated.depth = DepthMeasure::kNone;
    SuperResolutionOptions paper = options;
    paper.depth = DepthMeasure::kAbsolute;
    SerialExecutor executor;
    SuperResolution sr(options, executor);
    SuperResolution ungated_sr(ungated, executor);
    SuperResolution paper_sr(paper, executor);
    ImageBuffer out = OutputOf(options);
    ImageBuffer ungated_out = OutputOf(options);
    TestFrame frame(kWidth, kHeight);
    for (int i = 0; i < 6; ++i) {
      Render(i, 0, frame);
      for (int y = 0; y < kHeight; ++y) frame.Depth(kWidth / 2, y) = i % 2 == 0 ? 0.5f : 0.1f;
      paper_sr.Process(frame.View(), out.view());
      sr.Process(frame.View(), out.view());
      ungated_sr.Process(frame.View(), ungated_out.view());
      EXPECT_TRUE(SameBits(out, ungated_out)) << i;
      if (i > 0) {
        EXPECT_EQ(sr.Tiles().disoccluded, 0) << i;
        EXPECT_EQ(paper_sr.Tiles().disoccluded > 0, i % 2 == 1) << i;
      }
    }
  }
}

TEST(History, SampleFormIsThePrintedEquationForBZero) {
  // One render pixel of scale 1: the sample itself and the four at distance 1 have part.
  SuperResolutionOptions options = TestOptions(3, 3, 3, 3);
  options.form = HistoryForm::kSample;
  options.clamp = ColorClamp::kNone;
  options.history_format = PixelFormat::kRgba32F;
  options.parameters.blend_a = 0.34f;
  options.parameters.blend_b = 0;
  SerialExecutor executor;
  SuperResolution sr(options, executor);
  ImageBuffer out = OutputOf(options);
  TestFrame frame(3, 3);
  sr.Process(frame.View(), out.view());
  frame.SetColor(1, 1, 1.0f, 0.0f, 0.5f);
  sr.Process(frame.View(), out.view());
  EXPECT_NEAR(At(out, 1, 1, 0), 0.34f * (1.0f + 4 * 0.5f) / 5 + 0.66f * 0.5f, 1e-5f);
  EXPECT_NEAR(At(out, 1, 1, 1), 0.34f * (0.0f + 4 * 0.5f) / 5 + 0.66f * 0.5f, 1e-5f);
  EXPECT_NEAR(At(out, 0, 0, 0), 0.5f, 1e-5f);
}

TEST(History, ResidualFormMovesTheHistoryByTheShareOfTheDifference) {
  SuperResolutionOptions options = TestOptions(3, 3, 3, 3);
  options.form = HistoryForm::kResidual;
  options.clamp = ColorClamp::kNone;
  options.history_format = PixelFormat::kRgba32F;
  options.parameters.blend_a = 0.25f;
  SerialExecutor executor;
  SuperResolution sr(options, executor);
  ImageBuffer out = OutputOf(options);
  TestFrame frame(3, 3);
  sr.Process(frame.View(), out.view());
  frame.SetColor(1, 1, 1.0f, 0.0f, 0.5f);
  sr.Process(frame.View(), out.view());
  EXPECT_NEAR(At(out, 1, 1, 0), 0.5f + 0.25f * 0.5f, 1e-5f);
  EXPECT_NEAR(At(out, 1, 1, 1), 0.5f - 0.25f * 0.5f, 1e-5f);
}

TEST(History, NewParametersCountFromTheNextFrame) {
  SuperResolutionOptions options = Options();
  SerialExecutor executor;
  SuperResolution set(options, executor);
  Parameters parameters;
  parameters.blend_a = 0.1f;
  parameters.clamp_gamma = 0.5f;
  set.SetParameters(parameters, 0.5f);
  options.parameters = parameters;
  options.gate_width = 0.5f;
  SuperResolution made(options, executor);
  ImageBuffer a = OutputOf(options);
  ImageBuffer b = OutputOf(options);
  TestFrame frame(kWidth, kHeight);
  for (unsigned i = 0; i < 3; ++i) {
    frame.Randomise(i);
    set.Process(frame.View(), a.view());
    made.Process(frame.View(), b.view());
    EXPECT_TRUE(SameBits(a, b));
  }
}

}  // namespace
}  // namespace warplut
