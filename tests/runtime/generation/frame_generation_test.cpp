#include "runtime/frame_generation.h"

#include "runtime/image_buffer.h"
#include "runtime/motion_filter.h"
#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

void Fill(TestImage& image, float r, float g, float b) {
  const float values[] = {r, g, b, 1};
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      for (int c = 0; c < 4; ++c) image.Set(x, y, c, Code(image.format(), values[c]));
    }
  }
}

void ExpectFilled(const TestImage& image, float r, float g, float b, float bound) {
  const float values[] = {r, g, b, 1};
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      for (int c = 0; c < 4; ++c) {
        ASSERT_NEAR(image.Get(x, y, c), Code(image.format(), values[c]), bound)
            << x << " " << y << " " << c;
      }
    }
  }
}

TEST(FrameGeneration, ConstantImageStaysConstant) {
  for (const ColorEncoding encoding : {ColorEncoding::kDisplay, ColorEncoding::kLinearHdr}) {
    for (const PixelFormat format : kColorFormats) {
      TestFrame frame0 = RandomFrame(70, 41, format, 1), frame1 = RandomFrame(70, 41, format, 2);
      const float r = 200 / 255.0f, g = 17 / 255.0f, b = 128 / 255.0f;
      Fill(frame0.color, r, g, b);
      Fill(frame1.color, r, g, b);
      for (const float gate_width : {0.0f, 0.3f, 1.0f}) {
        for (const bool brightness_gate : {false, true}) {
          FrameGenerationOptions options = OptionsFor(frame0);
          options.encoding = encoding;
          options.gate_width = gate_width;
          options.brightness_gate = brightness_gate;
          for (const bool interpolates : {true, false}) {
            const TestImage out =
                Generate(options, frame0.view(), frame1.view(), 0.3f, interpolates, format);
            ExpectFilled(out, r, g, b, format == PixelFormat::kRgba8 ? 0.5f : 0.5f / 255);
          }
        }
      }
    }
  }
}

TEST(FrameGeneration, StaticSceneIsTheFrameItself) {
  for (const PixelFormat format : kColorFormats) {
    TestFrame frame = RandomFrame(67, 35, format, 3, false);
    frame.motion = TestMotion(67, 35);
    for (int y = 0; y < 35; ++y) {
      for (int x = 0; x < 67; ++x) frame.color.Set(x, y, 3, Code(format, 1));
    }
    for (const bool interpolates : {true, false}) {
      for (const float alpha : {0.01f, 0.5f, 0.75f}) {
        const TestImage out =
            Generate(OptionsFor(frame), frame.view(), frame.view(), alpha, interpolates, format);
        for (int y = 0; y < 35; ++y) {
          for (int x = 0; x < 67; ++x) {
            for (int c = 0; c < 4; ++c) ASSERT_EQ(out.Get(x, y, c), frame.color.Get(x, y, c));
          }
        }
      }
    }
  }
}

TEST(FrameGeneration, StaticHdrSceneIsTheFrameItself) {
  TestFrame frame(33, 20, PixelFormat::kRgba16F);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 33; ++x) {
      for (int c = 0; c < 3; ++c)
        frame.color.Set(x, y, c, std::exp2(static_cast<float>((x + 3 * y + c) % 10)));
    }
  }
  FrameGenerationOptions options = OptionsFor(frame);
  options.encoding = ColorEncoding::kLinearHdr;
  const TestImage out =
      Generate(options, frame.view(), frame.view(), 0.5f, true, PixelFormat::kRgba16F);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 33; ++x) {
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(out.Get(x, y, c), frame.color.Get(x, y, c), 1e-3f * frame.color.Get(x, y, c));
      }
    }
  }
}

// A near square, 8 pixels wide, moves 8 pixels to the right over a grey background.
struct MovingSquare {
  MovingSquare() {
    Fill(frame0.color, 0.5f, 0.5f, 0.5f);
    Fill(frame1.color, 0.5f, 0.5f, 0.5f);
    for (int y = 8; y < 16; ++y) {
      for (int x = 0; x < 8; ++x) {
        frame0.color.Set(16 + x, y, 0, 255);
        frame1.color.Set(24 + x, y, 0, 255);
        frame0.depth.Set(16 + x, y, 0, 0.1f);
        frame1.depth.Set(24 + x, y, 0, 0.1f);
        frame0.motion.Set(16 + x, y, 8, 0);
        frame1.motion.Set(24 + x, y, 8, 0);
      }
    }
  }

  // The left edge of the square in `out`.
  void ExpectAt(const TestImage& out, int left) const {
    for (int y = 0; y < 24; ++y) {
      for (int x = 0; x < 64; ++x) {
        const bool inside = y >= 8 && y < 16 && x >= left && x < left + 8;
        EXPECT_EQ(out.Get(x, y, 0), inside ? 255 : 128) << x << " " << y;
        EXPECT_EQ(out.Get(x, y, 1), 128);
        EXPECT_EQ(out.Get(x, y, 3), 255);
      }
    }
  }

  TestFrame frame0{64, 24, PixelFormat::kRgba8}, frame1{64, 24, PixelFormat::kRgba8};
};

TEST(FrameGeneration, MovesAnObjectAndUncoversItsBackground) {
  const MovingSquare square;
  const auto run = [&](float alpha, bool interpolates, DisocclusionFill fill) {
    FrameGenerationOptions options = OptionsFor(square.frame0);
    options.fill = fill;
    return Generate(options, square.frame0.view(), square.frame1.view(), alpha, interpolates,
                    PixelFormat::kRgba8);
  };
  square.ExpectAt(run(0.25f, true, DisocclusionFill::kOwnMotion), 18);
  square.ExpectAt(run(0.5f, true, DisocclusionFill::kOwnMotion), 20);
  square.ExpectAt(run(0.5f, false, DisocclusionFill::kOwnMotion), 28);
}

TEST(FrameGeneration, ShowsTheNearerFrameAtACut) {
  const MovingSquare square;
  const auto run = [&](float alpha, bool interpolates) {
    return Generate(OptionsFor(square.frame0), square.frame0.view(), square.frame1.view(true),
                    alpha, interpolates, PixelFormat::kRgba8);
  };
  square.ExpectAt(run(0.4f, true), 16);
  square.ExpectAt(run(0.5f, true), 24);
  square.ExpectAt(run(0.4f, false), 24);
}

TEST(FrameGeneration, DoesNotReadTheMotionOfACut) {
  MovingSquare square;
  for (int x = 0; x < 8; ++x) {
    for (int y = 8; y < 16; ++y) square.frame0.motion.Set(16 + x, y, 100, 100);
  }
  square.ExpectAt(Generate(OptionsFor(square.frame0), square.frame0.view(true),
                           square.frame1.view(), 0.5f, true, PixelFormat::kRgba8),
                  20);
}

TEST(FrameGeneration, TakesTheFrameInWhichTheSourceLiesInside) {
  // The camera pans: what is at the right border of the generated frame is only in frame 1.
  TestFrame frame0(32, 8, PixelFormat::kRgba8), frame1(32, 8, PixelFormat::kRgba8);
  Fill(frame0.color, 0, 0, 0);
  Fill(frame1.color, 1, 1, 1);
  frame0.motion = TestMotion(32, 8, -8, 0);
  frame1.motion = TestMotion(32, 8, -8, 0);
  const TestImage out =
      Generate(OptionsFor(frame0), frame0.view(), frame1.view(), 0.5f, true, PixelFormat::kRgba8);
  EXPECT_EQ(out.Get(30, 4, 0), 255);
  EXPECT_EQ(out.Get(16, 4, 0), 128);
  EXPECT_EQ(out.Get(1, 4, 0), 0);
}

TEST(FrameGeneration, BrightnessGateTakesTheNearerFrame) {
  TestFrame frame0(8, 8, PixelFormat::kRgba8), frame1(8, 8, PixelFormat::kRgba8);
  Fill(frame0.color, 0.5f, 0.5f, 0.5f);
  Fill(frame1.color, 0.52f, 0.52f, 0.52f);
  FrameGenerationOptions options = OptionsFor(frame0);
  options.brightness_gate = true;
  options.parameters.brightness_threshold = 0.05f;
  const auto red = [&](float alpha) {
    return Generate(options, frame0.view(), frame1.view(), alpha, true, PixelFormat::kRgba8)
        .Get(3, 3, 0);
  };
  EXPECT_EQ(red(0.4f), 128);
  EXPECT_EQ(red(0.6f), 133);
  options.parameters.brightness_threshold = 0.01f;
  EXPECT_EQ(red(0.4f), 130);
  options.parameters.brightness_threshold = 0.05f;
  options.brightness_gate = false;
  EXPECT_EQ(red(0.6f), 131);
}

TEST(FrameGeneration, MotionFilterComesBeforeAllElse) {
  const TestFrame frame0 = RandomFrame(70, 41, PixelFormat::kRgba8, 21);
  const TestFrame frame1 = RandomFrame(70, 41, PixelFormat::kRgba8, 22);
  FrameGenerationOptions options = OptionsFor(frame0);
  options.motion_filter = true;
  const TestImage out =
      Generate(options, frame0.view(), frame1.view(), 0.5f, true, PixelFormat::kRgba8);
  options.motion_filter = false;
  SerialExecutor executor;
  MotionFilter filter(70, 41, {options.motion_filter_limit});
  MotionBuffer motion0(70, 41), motion1(70, 41);
  DisplayedFrame view0 = frame0.view(), view1 = frame1.view();
  filter.Apply(view0.depth, view0.motion, executor, motion0.view());
  filter.Apply(view1.depth, view1.motion, executor, motion1.view());
  view0.motion = motion0.view();
  view1.motion = motion1.view();
  EXPECT_TRUE(out == Generate(options, view0, view1, 0.5f, true, PixelFormat::kRgba8));
}

TEST(FrameGeneration, NewParametersCountFromTheNextCall) {
  const TestFrame frame0 = RandomFrame(40, 30, PixelFormat::kRgba8, 11);
  const TestFrame frame1 = RandomFrame(40, 30, PixelFormat::kRgba8, 12);
  FrameGenerationOptions options = OptionsFor(frame0);
  FrameGenerationOptions other = options;
  other.parameters.generation_depth_threshold = 0.01f;
  other.gate_width = 0.5f;
  SerialExecutor executor;
  FrameGeneration generation(options, executor);
  TestImage out(40, 30, PixelFormat::kRgba8, 12);
  generation.SetParameters(other.parameters, other.gate_width);
  generation.Interpolate(frame0.view(), frame1.view(), 0.5f, out.view());
  EXPECT_TRUE(out ==
              Generate(other, frame0.view(), frame1.view(), 0.5f, true, PixelFormat::kRgba8));
}

TEST(FrameGeneration, StaysWithinItsMemory) {
  FrameGenerationOptions options;
  options.width = 1920;
  options.height = 1080;
  constexpr std::size_t kImage = 1920 * 1080 * 8;
  ThreadPool pool(2);
  for (const ColorEncoding encoding : {ColorEncoding::kDisplay, ColorEncoding::kLinearHdr}) {
    options.encoding = encoding;
    EXPECT_LE(FrameGeneration(options, pool).MemoryBytes(), 5 * kImage);
  }
}

}  // namespace
}  // namespace warplut::generation
