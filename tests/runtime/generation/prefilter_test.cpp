// Frame generation by a filter with prefilter.
#include "runtime/frame_generation.h"
#include "tests/image_difference.h"
#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

constexpr int kWidth = 93, kHeight = 71;

FrameGenerationOptions SplineOptions(const TestFrame& frame) {
  FrameGenerationOptions options = OptionsFor(frame);
  options.warp.filter = Filter::kSpline;
  options.warp.spline_k = static_cast<float>(1.0 / 84);
  return options;
}

// Whether every channel of `a` is within `bound` of that of `b`; one that is not a number is not.
void ExpectAlike(const TestImage& a, const TestImage& b, float bound) {
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      for (int c = 0; c < 4; ++c) {
        const float difference = std::abs(a.Get(x, y, c) - b.Get(x, y, c));
        ASSERT_TRUE(difference <= bound) << x << " " << y << " " << c << ": " << difference;
      }
    }
  }
}

TEST(GenerationPrefilter, FastEqualsTheReference) {
  for (const ColorEncoding encoding : {ColorEncoding::kDisplay, ColorEncoding::kLinearHdr}) {
    for (const PixelFormat format : kColorFormats) {
      const TestFrame frame0 = RandomFrame(kWidth, kHeight, format, 1, false);
      const TestFrame frame1 = RandomFrame(kWidth, kHeight, format, 2, false);
      const float bound = format == PixelFormat::kRgba8     ? 1.0f
                          : format == PixelFormat::kRgba16F ? 4e-3f
                                                            : 2e-4f;
      for (const bool interpolates : {true, false}) {
        FrameGenerationOptions options = SplineOptions(frame0);
        options.encoding = encoding;
        const TestImage fast =
            Generate(options, frame0.view(), frame1.view(), 0.3f, interpolates, format);
        options.reference = true;
        const TestImage plain =
            Generate(options, frame0.view(), frame1.view(), 0.3f, interpolates, format);
        // A gate may fall on the other side by rounding, for few pixels. The tone map's slope is
        // at most 6.25.
        const float slope = encoding == ColorEncoding::kLinearHdr ? 6.25f : 1.0f;
        EXPECT_LE(Compare(fast.view(), plain.view()).largest, slope * bound) << Name(format);
      }
    }
  }
}

TEST(GenerationPrefilter, WildFramesAreFinite) {
  for (const PixelFormat format : kColorFormats) {
    const TestFrame frame0 = RandomFrame(kWidth, kHeight, format, 1);
    const TestFrame frame1 = RandomFrame(kWidth, kHeight, format, 2);
    for (const bool interpolates : {true, false}) {
      const TestImage out =
          Generate(SplineOptions(frame0), frame0.view(), frame1.view(), 0.3f, interpolates, format);
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(out.Get(x, y, c))) << x << " " << y;
        }
      }
    }
  }
}

TEST(GenerationPrefilter, AFrameThatIsKnownIsFilteredOnceAndGivesTheSameBits) {
  for (const PixelFormat format : kColorFormats) {
    TestFrame frames[] = {RandomFrame(kWidth, kHeight, format, 1),
                          RandomFrame(kWidth, kHeight, format, 2),
                          RandomFrame(kWidth, kHeight, format, 3)};
    const FrameGenerationOptions options = SplineOptions(frames[0]);
    SerialExecutor executor;
    FrameGeneration generation(options, executor);
    TestImage out(kWidth, kHeight, format, 16);
    const auto known = [&](int i) {
      DisplayedFrame frame = frames[i].view();
      frame.id = static_cast<std::uint64_t>(i) + 1;
      return frame;
    };
    for (int i = 0; i + 1 < 3; ++i) {
      for (const float alpha : {0.25f, 0.5f, 0.75f}) {
        generation.Interpolate(known(i), known(i + 1), alpha, out.view());
        ExpectAlike(
            out, Generate(options, frames[i].view(), frames[i + 1].view(), alpha, true, format), 0);
        generation.Extrapolate(known(i), known(i + 1), alpha, out.view());
        ExpectAlike(out,
                    Generate(options, frames[i].view(), frames[i + 1].view(), alpha, false, format),
                    0);
      }
    }
    // A frame with another id is another frame, in whichever buffer it lies.
    DisplayedFrame other = frames[0].view();
    other.id = 9;
    generation.Interpolate(other, known(2), 0.5f, out.view());
    ExpectAlike(out, Generate(options, frames[0].view(), frames[2].view(), 0.5f, true, format), 0);
  }
}

TEST(GenerationPrefilter, AnyExecutorGivesTheSameBits) {
  const TestFrame frame0 = RandomFrame(kWidth, kHeight, PixelFormat::kRgba16F, 5);
  const TestFrame frame1 = RandomFrame(kWidth, kHeight, PixelFormat::kRgba16F, 6);
  const FrameGenerationOptions options = SplineOptions(frame0);
  SerialExecutor serial;
  ThreadPool pool(3);
  for (const bool interpolates : {true, false}) {
    const TestImage one = Generate(options, frame0.view(), frame1.view(), 0.4f, interpolates,
                                   PixelFormat::kRgba16F, serial);
    const TestImage many = Generate(options, frame0.view(), frame1.view(), 0.4f, interpolates,
                                    PixelFormat::kRgba16F, pool);
    ExpectAlike(one, many, 0);
  }
}

TEST(GenerationPrefilter, AStaticSceneIsTheFrameItself) {
  TestFrame frame = RandomFrame(kWidth, kHeight, PixelFormat::kRgba8, 3, false);
  frame.motion = TestMotion(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) frame.color.Set(x, y, 3, 255);
  }
  for (const bool interpolates : {true, false}) {
    ExpectAlike(Generate(SplineOptions(frame), frame.view(), frame.view(), 0.5f, interpolates,
                         PixelFormat::kRgba8),
                frame.color, 0);
  }
}

}  // namespace
}  // namespace warplut::generation
