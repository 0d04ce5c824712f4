// A history ends where its samples say, whatever its format rounds to and however small the share
// of a sample.
#include <algorithm>
#include <string>
#include <vector>

#include "tests/kernel_main.h"
#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

constexpr int kWidth = 12, kHeight = 10;

struct Case {
  HistoryForm form;
  PixelFormat format;
  ColorEncoding encoding;
  ColorClamp clamp;
  float blend_a;

  std::string Name() const {
    return std::string(warplut::Name(form)) + " " + warplut::Name(format) + " " +
           warplut::Name(encoding) + " " + warplut::Name(clamp) +
           ", a = " + std::to_string(blend_a);
  }
  SuperResolutionOptions Options(int scale, bool reference) const {
    SuperResolutionOptions options = TestOptions(kWidth, kHeight, scale * kWidth, scale * kHeight);
    options.form = form;
    options.history_format = format;
    options.encoding = encoding;
    options.clamp = clamp;
    options.parameters.blend_a = blend_a;
    options.parameters.blend_b = 1.05f;  // a sample one pixel away has no weight
    options.reference = reference;
    return options;
  }
};

// Frames after which a history that rounds nothing is within a code, and some more.
int FramesToSettle(const Case& c, int codes) {
  // In the sample form the mean weight is that of the sample on the pixel's centre and of four of
  // weight 0.
  const float share = std::min(1.0f, c.blend_a * (c.form == HistoryForm::kSample ? 0.2f : 1.0f));
  return static_cast<int>(std::log(static_cast<float>(std::abs(codes)) + 1) / share) + 12;
}

std::vector<Case> Cases() {
  std::vector<Case> cases;
  for (const HistoryForm form :
       {HistoryForm::kSample, HistoryForm::kResidual, HistoryForm::kAdaptive}) {
    for (const PixelFormat format : kColorFormats) {
      for (const ColorEncoding encoding : {ColorEncoding::kDisplay, ColorEncoding::kLinearHdr}) {
        for (const ColorClamp clamp : {ColorClamp::kNone, ColorClamp::kVariance}) {
          for (const float blend_a : {0.02f, 0.05f, 0.3f, 1.0f, 8.0f}) {
            cases.push_back({form, format, encoding, clamp, blend_a});
          }
        }
      }
    }
  }
  return cases;
}

// A checker of two codes of 8 bits, each moved by as much.
void Checker(int dark, int bright, TestFrame& frame) {
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float v = static_cast<float>((x / 4 + y / 4) % 2 == 0 ? bright : dark) / 255;
      frame.SetColor(x, y, v, v, v);
    }
  }
}

// The farthest that a channel is from the frame's, as a share of what it may be.
float Farthest(const Case& c, const ImageBuffer& out, int dark, int bright) {
  const bool linear = c.encoding == ColorEncoding::kLinearHdr;
  const auto code = [&](float v) { return linear ? HdrCode(v) : v; };
  const float unit = c.format == PixelFormat::kRgba8 ? 1.0f : CodeContrast(c.encoding);
  float farthest = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float v = static_cast<float>((x / 4 + y / 4) % 2 == 0 ? bright : dark) / 255;
      for (int i = 0; i < 3; ++i) {
        farthest = std::max(farthest, std::abs(code(At(out, x, y, i)) - code(v)) * 255 / unit);
      }
    }
  }
  // Half a code is the rounding of what is stored; in linear HDR the target is no code.
  return linear && c.format == PixelFormat::kRgba8 ? farthest - 0.5f : farthest;
}

TEST(Settling, AStillImageThatGetsBrighterIsReachedWithinACode) {
  for (const bool reference : {false, true}) {
    for (const Case& c : SomeOf(Cases())) {
      if (reference && c.blend_a != 0.05f) continue;
      const SuperResolutionOptions options = c.Options(1, reference);
      std::string why;
      ASSERT_TRUE(options.IsValid(&why)) << why;
      for (const int brighter : {8, -8, 90}) {
        SerialExecutor executor;
        SuperResolution sr(options, executor);
        ImageBuffer out = OutputOf(options);
        TestFrame frame(kWidth, kHeight);
        Checker(100, 140, frame);
        for (int i = 0; i < 3; ++i) sr.Process(frame.View(), out.view());
        Checker(100 + brighter, 140 + brighter, frame);
        for (int i = 0; i < FramesToSettle(c, brighter); ++i) sr.Process(frame.View(), out.view());
        EXPECT_LE(Farthest(c, out, 100 + brighter, 140 + brighter), 1.02f)
            << c.Name() << ", " << brighter << " codes" << (reference ? ", reference" : "");
      }
    }
  }
}

// Also where samples lie beside the pixels, so that neighbours depend on each other.
TEST(Settling, ThenItRestsToTheBit) {
  for (const Case& c : SomeOf(Cases())) {
    if (c.format == PixelFormat::kRgba32F) continue;
    const SuperResolutionOptions options = c.Options(2, false);
    SerialExecutor executor;
    SuperResolution sr(options, executor);
    ImageBuffer out = OutputOf(options), settled = OutputOf(options);
    TestFrame frame(kWidth, kHeight);
    frame.Randomise(7);
    frame.jitter_x = frame.jitter_y = 0;
    frame.SetMotion(0, 0);
    sr.Process(frame.View(), out.view());
    Checker(108, 148, frame);
    for (int i = 0; i < 1200; ++i) sr.Process(frame.View(), settled.view());
    for (int i = 0; i < 50; ++i) {
      sr.Process(frame.View(), out.view());
      ASSERT_TRUE(SameBits(out, settled)) << c.Name();
    }
  }
}

}  // namespace
}  // namespace warplut
