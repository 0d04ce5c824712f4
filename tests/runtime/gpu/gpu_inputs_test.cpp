// What a renderer hands over, in its own formats, and what frame generation takes of super
// resolution.
#include <gtest/gtest.h>

#include <utility>

#include "luts/half.h"
#include "runtime/gpu/gpu_super_resolution.h"
#include "runtime/gpu/image_transfer.h"
#include "tests/runtime/gpu/gpu_fixture.h"

namespace warplut {
namespace {

TEST(UnsignedFloats, AreTheNearest) {
  for (const int mantissa : {5, 6}) {
    const float unit = 1.0f / static_cast<float>(1 << mantissa);
    for (const float value : {0.0f, 1.0f, 1 + unit, 1 + 7 * unit, 0.375f, 64.0f})
      EXPECT_EQ(FromUnsignedFloat(UnsignedFloat(value, mantissa), mantissa), value);
    EXPECT_EQ(FromUnsignedFloat(UnsignedFloat(1 + 0.4f * unit, mantissa), mantissa), 1.0f);
    EXPECT_EQ(FromUnsignedFloat(UnsignedFloat(1 + 0.6f * unit, mantissa), mantissa), 1 + unit);
    EXPECT_EQ(UnsignedFloat(-1, mantissa), 0U);
    EXPECT_EQ(UnsignedFloat(kNaN, mantissa), 0U);
    EXPECT_EQ(FromUnsignedFloat(UnsignedFloat(1e9f, mantissa), mantissa), kInfinity);
  }
}

constexpr int kWidth = 48, kHeight = 36;

SuperResolutionOptions InputOptions() {
  SuperResolutionOptions options = TestOptions(kWidth, kHeight, 2 * kWidth, 2 * kHeight);
  options.warp.filter = Filter::kCatmullRom;
  options.history_format = PixelFormat::kRgba32F;
  return options;
}

class GpuInputs : public GpuTest {};

// Colour in R11G11B10F, motion in RG16F as NDC to the frame before, y up, and a reversed depth
// buffer: the processor gets what these stand for.
TEST_F(GpuInputs, AreConvertedInTheLoad) {
  const SuperResolutionOptions options = InputOptions();
  InputConventions stored = InputConventions::DepthBuffer(0.1f, 100.0f, true);
  stored.color_format = TexelFormat::kR11G11B10F;
  stored.motion_format = TexelFormat::kRg16F;
  stored.motion_scale_x = -kWidth / 2.0f;
  stored.motion_scale_y = kHeight / 2.0f;
  SerialExecutor executor;
  SuperResolution cpu(options, executor);
  GpuSuperResolution gpu(device(), options, stored);
  ImageBuffer expected = OutputOf(options), found = OutputOf(options);
  TestFrame frame(kWidth, kHeight), raw(kWidth, kHeight);
  for (int i = 0; i < 4; ++i) {
    frame.Randomise(static_cast<unsigned>(i));
    raw.jitter_x = frame.jitter_x;
    raw.jitter_y = frame.jitter_y;
    const RenderedFrame view = frame.View();
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        float color[3], motion[2];
        for (int c = 0; c < 3; ++c) {
          const int mantissa = c < 2 ? 6 : 5;
          color[c] = FromUnsignedFloat(UnsignedFloat(view.color.Row<float>(y)[4 * x + c], mantissa),
                                       mantissa);
        }
        raw.SetColor(x, y, color[0], color[1], color[2]);
        frame.SetColor(x, y, color[0], color[1], color[2]);
        const float scale[2] = {stored.motion_scale_x, stored.motion_scale_y};
        for (int c = 0; c < 2; ++c) {
          motion[c] = HalfToFloat(FloatToHalf(view.motion.Row(y)[2 * x + c] / scale[c]));
        }
        raw.SetMotion(x, y, motion[0], motion[1]);
        frame.SetMotion(x, y, motion[0] * scale[0], motion[1] * scale[1]);
        const double z = static_cast<double>(frame.Depth(x, y)) * 100;
        raw.Depth(x, y) = static_cast<float>(0.1 * (100 - z) / (z * (100 - 0.1)));
      }
    }
    cpu.Process(frame.View(), expected.view());
    gpu.Process(raw.View(), found.view());
    ExpectClose(found, expected, kGpuBound32, "frame " + std::to_string(i));
  }
}

TEST(InputConventions, RefusesFormatsThatItDoesNotList) {
  InputConventions stored;
  std::string why;
  EXPECT_TRUE(stored.IsValid(&why)) << why;
  stored.motion_format = TexelFormat::kR32F;
  EXPECT_FALSE(stored.IsValid(&why));
  EXPECT_EQ(why, "the format of motion is r32f; expected rg32f or rg16f");
  stored.color_format = TexelFormat::kRg16F;
  EXPECT_FALSE(stored.IsValid(&why));
  EXPECT_EQ(why, "the format of colour is rg16f; expected rgba32f, rgba16f, rgba8 or r11g11b10f");
  stored = {};
  stored.reactive_format = TexelFormat::kRgba8;
  EXPECT_FALSE(stored.IsValid(&why));
  EXPECT_EQ(why, "the format of the reactive mask is rgba8; expected r32f, r16f or r8");
}

// A reactive mask in every format, with values that all of them have; a frame may come without.
TEST_F(GpuInputs, TakesReactiveMasksOfEveryFormat) {
  SuperResolutionOptions options = InputOptions();
  options.reactive = true;
  ImageBuffer mask(kWidth, kHeight, PixelFormat::kR32F);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float blocks[4] = {0, 51 / 255.0f, 1, 0};
      mask.view().Row<float>(y)[x] = blocks[(x / 6 + 3 * (y / 5)) % 4];
    }
  }
  const float broken[4] = {kNaN, -kInfinity, 2.5f, kInfinity};
  for (int i = 0; i < kHeight; ++i) mask.view().Row<float>(i)[i] = broken[i % 4];
  for (const TexelFormat format : {TexelFormat::kR32F, TexelFormat::kR16F, TexelFormat::kR8}) {
    SerialExecutor executor;
    SuperResolution cpu(options, executor);
    GpuSuperResolution gpu(device(), options, {.reactive_format = format});
    ImageBuffer expected = OutputOf(options), found = OutputOf(options);
    TestFrame frame(kWidth, kHeight);
    for (int i = 0; i < 5; ++i) {
      frame.Randomise(static_cast<unsigned>(i));
      RenderedFrame view = frame.View();
      if (i != 3) view.reactive = mask.view();
      cpu.Process(view, expected.view());
      gpu.Process(view, found.view());
      // A half has 11 bits of 51 / 255.
      const GpuBound bound = format == TexelFormat::kR16F ? kGpuBound16 : kGpuBound32;
      ExpectClose(found, expected, bound,
                  std::string(Name(format)) + ", frame " + std::to_string(i));
    }
  }
}

// Depth and motion on the output grid are those of the processor, NaN where there is no motion.
TEST_F(GpuInputs, GeometryIsThatOfTheProcessor) {
  for (const MotionUpsampling motion : {MotionUpsampling::kNearest, MotionUpsampling::kDilated,
                                        MotionUpsampling::kEdgeAware, MotionUpsampling::kStatic}) {
    SuperResolutionOptions options = InputOptions();
    options.motion = motion;
    SerialExecutor executor;
    SuperResolution cpu(options, executor);
    GpuSuperResolution gpu(device(), options, {}, true);
    ImageBuffer out = OutputOf(options);
    TestFrame frame(kWidth, kHeight);
    for (int i = 0; i < 2; ++i) {
      frame.Randomise(static_cast<unsigned>(i), true);
      cpu.Process(frame.View(), out.view());
      gpu.Process(frame.View(), out.view());
      const OutputGeometry expected = cpu.Geometry(), found = gpu.Geometry();
      EXPECT_EQ(found.cut, expected.cut);
      int differing = 0;
      for (int y = 0; y < options.output_height; ++y) {
        for (int x = 0; x < options.output_width; ++x) {
          const float depth = expected.depth.Row<float>(y)[x];
          bool differs = std::abs(found.depth.Row<float>(y)[x] - depth) > 1e-6f * depth;
          for (int c = 0; c < 2; ++c) {
            const float m = expected.motion.Row(y)[2 * x + c], n = found.motion.Row(y)[2 * x + c];
            differs = differs || std::isnan(m) != std::isnan(n) || std::abs(m - n) > 1e-5f;
          }
          differing += differs ? 1 : 0;
        }
      }
      // A sample position on the middle between two samples may fall to either.
      EXPECT_LE(differing, kGpuBound32.rare * options.output_width * options.output_height)
          << Name(motion) << ", frame " << i;
    }
  }
}

}  // namespace
}  // namespace warplut
