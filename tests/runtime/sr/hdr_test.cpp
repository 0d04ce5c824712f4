// Super resolution of linear HDR.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sr_fixture.h"

namespace warplut {
namespace {

constexpr int kWidth = 24, kHeight = 16, kScale = 2;

SuperResolutionOptions HdrOptions() {
  SuperResolutionOptions options = TestOptions(kWidth, kHeight, kScale * kWidth, kScale * kHeight);
  options.encoding = ColorEncoding::kLinearHdr;
  return options;
}

// A texture of 0.05 to 0.3 with lamps of one sample; all of it moves.
TestFrame LampFrame(unsigned number, float lamp, float exposure = 1,
                    PixelFormat format = PixelFormat::kRgba32F) {
  TestFrame frame(kWidth, kHeight, format);
  frame.Randomise(number);
  frame.jitter_x = number % 2 == 0 ? 0.25f : -0.25f;
  frame.jitter_y = number % 4 < 2 ? 0.25f : -0.25f;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float wave = 0.175f + 0.125f * std::sin(0.9f * static_cast<float>(x + 2 * y));
      const float value = exposure * (x % 7 == 3 && y % 5 == 2 ? lamp : wave);
      frame.SetColor(x, y, value, 0.9f * value, 0.7f * value);
      frame.Depth(x, y) = 0.5f;
      frame.SetMotion(x, y, 0.3f, -0.2f);
    }
  }
  return frame;
}

// The last of `count` frames.
ImageBuffer LastOf(const SuperResolutionOptions& options, unsigned count, float lamp,
                   float exposure = 1) {
  SerialExecutor executor;
  SuperResolution sr(options, executor);
  ImageBuffer out = OutputOf(options);
  for (unsigned i = 0; i < count; ++i) sr.Process(LampFrame(i, lamp, exposure).View(), out.view());
  return out;
}

template <class Visit>
void ForChannels(const ImageBuffer& image, const Visit& visit) {
  for (int y = 0; y < image.view().height; ++y) {
    for (int x = 0; x < image.view().width; ++x) {
      for (int c = 0; c < 3; ++c) visit(At(image, x, y, c));
    }
  }
}

TEST(SuperResolutionHdr, NothingIsBrighterThanTheBrightestSample) {
  for (const float lamp : {5.0f, 1e3f, 1e4f}) {
    for (const HistoryForm form :
         {HistoryForm::kSample, HistoryForm::kResidual, HistoryForm::kAdaptive}) {
      for (const bool reference : {false, true}) {
        SuperResolutionOptions options = HdrOptions();
        options.form = form;
        options.reference = reference;
        ForChannels(LastOf(options, 6, lamp),
                    [&](float value) { ASSERT_LE(value, 1.001f * lamp) << Name(form); });
      }
    }
  }
}

TEST(SuperResolutionHdr, IsFiniteInHalves) {
  SuperResolutionOptions options = HdrOptions();
  SerialExecutor executor;
  SuperResolution sr(options, executor);
  ImageBuffer out = OutputOf(options, PixelFormat::kRgba16F);
  for (unsigned i = 0; i < 6; ++i) {
    sr.Process(LampFrame(i, kInfinity, 1, PixelFormat::kRgba16F).View(), out.view());
  }
  float brightest = 0;
  for (int y = 0; y < out.view().height; ++y) {
    for (int x = 0; x < out.view().width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const float value =
            LoadChannel(PixelFormat::kRgba16F, std::as_const(out).view().At(x, y), c);
        ASSERT_TRUE(std::isfinite(value));
        brightest = std::max(brightest, value);
      }
    }
  }
  EXPECT_GT(brightest, 100);  // what was infinite is bright, not black
}

TEST(SuperResolutionHdr, InfinityIsBrightNanAndNegativeAreBlack) {
  for (const PixelFormat format : {PixelFormat::kRgba16F, PixelFormat::kRgba32F}) {
    for (const bool reference : {false, true}) {
      SuperResolutionOptions options = HdrOptions();
      options.reference = reference;
      SerialExecutor executor;
      SuperResolution sr(options, executor);
      TestFrame frame(kWidth, kHeight, format);
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) frame.SetColor(x, y, kInfinity, kNaN, -3.0f);
      }
      ImageBuffer out = OutputOf(options);
      sr.Process(frame.View(), out.view());
      EXPECT_FLOAT_EQ(At(out, 9, 9, 0), kLargestHdr);
      EXPECT_EQ(At(out, 9, 9, 1), 0);
      EXPECT_EQ(At(out, 9, 9, 2), 0);
    }
  }
}

TEST(SuperResolutionHdr, OnDisplaysInfinityIsBlack) {
  for (const PixelFormat format : {PixelFormat::kRgba16F, PixelFormat::kRgba32F}) {
    for (const bool reference : {false, true}) {
      SuperResolutionOptions options = HdrOptions();
      options.encoding = ColorEncoding::kDisplay;
      options.reference = reference;
      SerialExecutor executor;
      SuperResolution sr(options, executor);
      TestFrame frame(kWidth, kHeight, format);
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) frame.SetColor(x, y, kInfinity, 6e4f, -kInfinity);
      }
      ImageBuffer out = OutputOf(options);
      sr.Process(frame.View(), out.view());
      EXPECT_EQ(At(out, 9, 9, 0), 0);
      EXPECT_EQ(At(out, 9, 9, 1), 1);
      EXPECT_EQ(At(out, 9, 9, 2), 0);
    }
  }
}

TEST(SuperResolutionHdr, HighlightsSurviveTheHistory) {
  for (const float value : {0.002f, 0.3f, 40.0f, 3e3f, 6e4f}) {
    SuperResolutionOptions options = HdrOptions();
    SerialExecutor executor;
    SuperResolution sr(options, executor);
    TestFrame frame(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) frame.SetColor(x, y, value, value, value);
    }
    frame.SetMotion(0.3f, 0.7f);
    ImageBuffer out = OutputOf(options);
    for (int i = 0; i < 12; ++i) sr.Process(frame.View(), out.view());
    // A unit in the last place of a half, as codes have them.
    ForChannels(out, [&](float v) { ASSERT_NEAR(v, value, 0.0085f * (value + 1 / kHdrGain)); });
  }
}

TEST(SuperResolutionHdr, DependsLittleOnTheExposure) {
  const ImageBuffer usual = LastOf(HdrOptions(), 6, 8.0f);
  for (const float exposure : {1.0f / 16, 16.0f}) {
    const ImageBuffer other = LastOf(HdrOptions(), 6, 8.0f, exposure);
    double sum = 0;
    for (int y = 0; y < kScale * kHeight; ++y) {
      for (int x = 0; x < kScale * kWidth; ++x) {
        const float a = At(usual, x, y, 0), b = At(other, x, y, 0) / exposure;
        sum += std::abs(std::log2((b + 0.01f) / (a + 0.01f)));
      }
    }
    EXPECT_LT(sum / (kScale * kHeight * kScale * kWidth), 0.15) << exposure;
  }
}

}  // namespace
}  // namespace warplut
