// Frame generation in linear HDR.
#include <gtest/gtest.h>

#include "generation_fixture.h"
#include "runtime/generation/hdr_rows.h"
#include "runtime/generation/row_kernels.h"

namespace warplut::generation {
namespace {

constexpr int kWidth = 67, kHeight = 40;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

FrameGenerationOptions HdrOptions(const TestFrame& frame) {
  FrameGenerationOptions options = OptionsFor(frame);
  options.encoding = ColorEncoding::kLinearHdr;
  return options;
}

// A dark texture with bright discs; all of it moves by a fraction.
TestFrame LampFrame(PixelFormat format, float lamp) {
  TestFrame frame(kWidth, kHeight, format);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool bright = std::hypot(x % 16 - 8, y % 16 - 8) < 4;
      const float wave = 0.2f + 0.1f * std::sin(0.8f * static_cast<float>(x - 3 * y));
      for (int c = 0; c < 3; ++c) frame.color.Set(x, y, c, bright ? lamp : wave);
      frame.motion.Set(x, y, 1.4f, -0.7f);
    }
  }
  return frame;
}

TEST(GenerationHdr, NothingIsBrighterThanTheBrightestTexel) {
  for (const float lamp : {4.0f, 1e3f, 6e4f}) {
    for (const PixelFormat format : {PixelFormat::kRgba16F, PixelFormat::kRgba32F}) {
      const TestFrame frame = LampFrame(format, lamp);
      const float bound = 1.001f * frame.color.Get(8, 8, 0);
      for (const bool interpolates : {true, false}) {
        for (const bool reference : {true, false}) {
          FrameGenerationOptions options = HdrOptions(frame);
          options.reference = reference;
          const TestImage out =
              Generate(options, frame.view(), frame.view(), 0.5f, interpolates, format);
          for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) ASSERT_LE(out.Get(x, y, 0), bound) << lamp;
          }
        }
      }
    }
  }
}

TEST(GenerationHdr, LimitsToTheTexelsAround) {
  TestImage codes(8, 6, PixelFormat::kRgba32F), warped(8, 6, PixelFormat::kRgba32F);
  const float white = HdrCode(kUnlimitedHdr);
  codes.Fill(0.9f * white);
  codes.Set(3, 2, 0, 0.5f);
  warped.Fill(0.7f);
  const TestMotion motion(8, 6);
  LimitHdrRow(codes.history(), motion.view(), 2, warped.view());
  for (int x = 0; x < 8; ++x) {
    // Taps are x - 1 to x + 2.
    EXPECT_EQ(warped.Get(x, 2, 0), x >= 1 && x <= 4 ? 0.5f : white) << x;
    EXPECT_EQ(warped.Get(x, 2, 1), white);
  }
}

TEST(GenerationHdr, RowKernelsEqualTheReference) {
  for (const PixelFormat format :
       {PixelFormat::kRgba8, PixelFormat::kRgba16F, PixelFormat::kRgba32F}) {
    TestImage linear = RandomFrame(37, 3, format, 5).color;
    if (format != PixelFormat::kRgba8) {
      linear.Set(1, 1, 0, kInfinity);
      linear.Set(1, 1, 1, -kInfinity);
      linear.Set(2, 1, 2, std::numeric_limits<float>::quiet_NaN());
      linear.Set(3, 1, 1, 4e4f);
    }
    TestImage codes[2] = {{37, 3, PixelFormat::kRgba32F}, {37, 3, PixelFormat::kRgba32F}};
    TestImage back[2] = {{37, 3, format}, {37, 3, format}};
    const RowKernels kernels[2] = {ReferenceRowKernels(), FastRowKernels()};
    for (int k = 0; k < 2; ++k) {
      for (int y = 0; y < 3; ++y) {
        kernels[k].encode_hdr(linear.history(), y, codes[k].view());
        kernels[k].decode_hdr(codes[k].history(), y, back[k].view());
      }
    }
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 37; ++x) {
        for (int c = 0; c < 4; ++c) {
          ASSERT_NEAR(codes[0].Get(x, y, c), codes[1].Get(x, y, c), 1e-6f);
          ASSERT_NEAR(back[0].Get(x, y, c), back[1].Get(x, y, c), 1e-3f * back[0].Get(x, y, c));
        }
      }
    }
    if (format == PixelFormat::kRgba8) continue;
    EXPECT_FLOAT_EQ(back[1].Get(1, 1, 0), kLargestHdr);
    EXPECT_EQ(back[1].Get(1, 1, 1), 0);
    EXPECT_EQ(back[1].Get(2, 1, 2), 0);
  }
}

TEST(GenerationHdr, ACutShowsTheFrameToTheBit) {
  TestFrame frame = LampFrame(PixelFormat::kRgba16F, 5e4f);
  frame.color.Set(2, 2, 1, kInfinity);
  const TestImage out = Generate(HdrOptions(frame), frame.view(), frame.view(true), 0.5f, true,
                                 PixelFormat::kRgba16F);
  EXPECT_EQ(out.Get(2, 2, 1), kLargestHdr);
  EXPECT_EQ(out.Get(2, 2, 0), frame.color.Get(2, 2, 0));
  EXPECT_EQ(out.Get(8, 8, 0), frame.color.Get(8, 8, 0));
}

// T_B is a difference of displayed values: 0.05 there are about 15 % of a mid grey.
TEST(GenerationHdr, BrightnessGateIsInCodes) {
  FrameGenerationOptions options;
  options.parameters.brightness_threshold = 0.05f;
  const GenerationJob display{options, true, 0.5f, false, {}, {}, {}, {}};
  EXPECT_EQ(display.brightness_threshold(), 0.05f);
  options.encoding = ColorEncoding::kLinearHdr;
  const GenerationJob hdr{options, true, 0.5f, false, {}, {}, {}, {}};
  const float grey = HdrCode(0.18f);
  EXPECT_LT(HdrCode(0.18f * 1.08f) - grey, hdr.brightness_threshold());
  EXPECT_GT(HdrCode(0.18f * 1.35f) - grey, hdr.brightness_threshold());
}

}  // namespace
}  // namespace warplut::generation
