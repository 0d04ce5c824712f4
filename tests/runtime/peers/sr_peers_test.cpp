// The peers of super resolution: fast against plain, and what each of them promises.
#include <cmath>
#include <numbers>
#include <string>

#include "runtime/method.h"
#include "runtime/peers.h"
#include "tests/image_difference.h"
#include "tests/runtime/counted_allocations.h"
#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

constexpr const char* kPeers[] = {"taau", "sgsr2", "fsr2"};

SuperResolutionOptions PeerOptions(const char* peer, int render_width, int render_height,
                                   int output_width, int output_height) {
  SuperResolutionOptions options =
      TestOptions(render_width, render_height, output_width, output_height);
  FindMethod(peer)->configure_super_resolution(options);
  return options;
}

struct Grid {
  int render_width, render_height, output_width, output_height;
};
constexpr Grid kGrids[] = {{1, 1, 1, 1},     {1, 1, 4, 3},     {3, 3, 3, 3},      {17, 5, 22, 7},
                           {41, 21, 70, 36}, {45, 27, 90, 54}, {33, 17, 132, 68}, {40, 24, 60, 96}};

// Pixels for which rounding decides whether the history left the range of its samples.
constexpr double kFlippedShare = 1e-3, kFlipped = 0.1;

// Runs both for some frames of random surfaces with broken values.
void ExpectEqual(SuperResolutionOptions options, float tolerance,
                 PixelFormat format = PixelFormat::kRgba32F) {
  std::string why;
  ASSERT_TRUE(options.IsValid(&why)) << why;
  SerialExecutor executor;
  SuperResolution fast(options, executor);
  options.reference = true;
  SuperResolution plain(options, executor);
  ImageBuffer fast_out = OutputOf(options), plain_out = OutputOf(options);
  TestFrame frame(options.render_width, options.render_height, format);
  for (unsigned i = 0; i < 4; ++i) {
    frame.Randomise(i, i == 2);
    fast.Process(frame.View(), fast_out.view());
    plain.Process(frame.View(), plain_out.view());
    const Difference difference = Compare(fast_out.view(), plain_out.view(), tolerance);
    ASSERT_LE(difference.share, kFlippedShare) << "frame " << i;
    ASSERT_LE(difference.largest, kFlipped) << "frame " << i;
  }
}

TEST(SrPeers, FastEqualsPlainAtEveryScaleAndSize) {
  for (const char* peer : kPeers) {
    for (const Grid& g : kGrids) {
      SCOPED_TRACE(testing::Message() << peer << ", " << g.render_width << " x " << g.render_height
                                      << " to " << g.output_width << " x " << g.output_height);
      SuperResolutionOptions options =
          PeerOptions(peer, g.render_width, g.render_height, g.output_width, g.output_height);
      options.history_format = PixelFormat::kRgba32F;
      ExpectEqual(options, 1e-4f);
    }
  }
}

TEST(SrPeers, FastEqualsPlainInEveryFormatAndEncoding) {
  for (const char* peer : kPeers) {
    for (const PixelFormat format :
         {PixelFormat::kRgba8, PixelFormat::kRgba16F, PixelFormat::kRgba32F}) {
      SCOPED_TRACE(testing::Message() << peer << ", " << Name(format));
      SuperResolutionOptions options = PeerOptions(peer, 37, 23, 63, 46);
      options.history_format = format;
      ExpectEqual(options, format == PixelFormat::kRgba8 ? 2.5f / 255 : 2e-3f, format);
      options.encoding = ColorEncoding::kLinearHdr;
      // The tone map's slope is at most 6.25 on the way out.
      ExpectEqual(options, format == PixelFormat::kRgba8 ? 6.25f * 2.5f / 255 : 6.25f * 2e-3f,
                  PixelFormat::kRgba32F);
    }
  }
}

TEST(SrPeers, AConstantImageStays) {
  SerialExecutor executor;
  for (const char* peer : kPeers) {
    const SuperResolutionOptions options = PeerOptions(peer, 20, 12, 40, 24);
    SuperResolution sr(options, executor);
    ImageBuffer out = OutputOf(options);
    TestFrame frame(20, 12);
    frame.SetMotion(0.3f, -0.2f);
    for (int i = 0; i < 8; ++i) {
      frame.jitter_x = 0.125f * static_cast<float>(i) - 0.5f;
      sr.Process(frame.View(), out.view());
      for (int y = 0; y < 24; ++y) {
        for (int x = 0; x < 40; ++x) ASSERT_NEAR(At(out, x, y, 0), 0.5f, 1e-3f) << peer;
      }
    }
  }
}

// A wave that still samples with jitter show: what the output pixel (x, y) should be.
float Wave(float x, float y) {
  constexpr float kPi = std::numbers::pi_v<float>;
  return 0.5f + 0.4f * std::sin(2 * kPi * x / 5) * std::sin(2 * kPi * y / 6);
}

// The mean error of a method after `frames` frames of a still wave at factor 2.
float StillError(const char* method, int frames) {
  SerialExecutor executor;
  const SuperResolutionOptions options = PeerOptions(method, 40, 24, 80, 48);
  SuperResolution sr(options, executor);
  ImageBuffer out = OutputOf(options);
  TestFrame frame(40, 24);
  for (int i = 0; i < frames; ++i) {
    frame.jitter_x = i % 2 == 0 ? -0.25f : 0.25f;
    frame.jitter_y = i / 2 % 2 == 0 ? -0.25f : 0.25f;
    for (int y = 0; y < 24; ++y) {
      for (int x = 0; x < 40; ++x) {
        const float v = Wave((static_cast<float>(x) + 0.5f + frame.jitter_x) * 2,
                             (static_cast<float>(y) + 0.5f + frame.jitter_y) * 2);
        frame.SetColor(x, y, v, v, v);
      }
    }
    sr.Process(frame.View(), out.view());
  }
  float error = 0;
  for (int y = 8; y < 40; ++y) {
    for (int x = 8; x < 72; ++x) {
      const float wanted = Wave(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      error += std::abs(At(out, x, y, 1) - wanted) / (32 * 64);
    }
  }
  return error;
}

TEST(SrPeers, HistoryResolvesWhatOneFrameDoesNot) {
  const float alone = StillError("bilinear", 64);
  for (const char* peer : kPeers) EXPECT_LT(StillError(peer, 64), 0.7f * alone) << peer;
}

TEST(SrPeers, AnImageWithoutHistoryIsTheCurrentFrame) {
  SerialExecutor executor;
  TestFrame frame(37, 23);
  frame.Randomise(3);
  const SuperResolutionOptions alone = PeerOptions("bilinear", 37, 23, 74, 46);
  ImageBuffer expected = OutputOf(alone);
  SuperResolution(alone, executor).Process(frame.View(), expected.view());
  for (const char* peer : kPeers) {
    SuperResolutionOptions options = PeerOptions(peer, 37, 23, 74, 46);
    SuperResolution sr(options, executor);
    ImageBuffer out = OutputOf(options);
    for (int i = 0; i < 2; ++i) {
      sr.Process(frame.View(), out.view());
      EXPECT_LE(Compare(out.view(), expected.view()).largest, 2e-3f) << peer;
      frame.cut = true;
    }
    frame.cut = false;
  }
}

TEST(SrPeers, NothingIsAllocatedByAFrame) {
  SerialExecutor executor;
  for (const char* peer : kPeers) {
    const SuperResolutionOptions options = PeerOptions(peer, 37, 23, 74, 46);
    SuperResolution sr(options, executor);
    ImageBuffer out = OutputOf(options);
    TestFrame frame(37, 23);
    frame.Randomise(1);
    sr.Process(frame.View(), out.view());
    const int before = CountedAllocations();
    sr.Process(frame.View(), out.view());
    EXPECT_EQ(CountedAllocations(), before) << peer;
  }
}

TEST(SrPeers, TheFilterOfTheOptionsIsNotTaken) {
  SerialExecutor executor;
  for (const char* peer : kPeers) {
    SuperResolutionOptions options = PeerOptions(peer, 37, 23, 74, 46);
    ImageBuffer out = OutputOf(options), other_out = OutputOf(options);
    SuperResolution sr(options, executor);
    options.warp = {.filter = Filter::kKeys, .keys_a = -0.8f};
    SuperResolution other(options, executor);
    TestFrame frame(37, 23);
    for (unsigned i = 0; i < 3; ++i) {
      frame.Randomise(i);
      sr.Process(frame.View(), out.view());
      other.Process(frame.View(), other_out.view());
    }
    EXPECT_TRUE(SameBits(out, other_out)) << peer;
  }
}

// At the sample of a pixel the share is that of the parameter, and the history is limited to the
// variance box.
TEST(Taau, BlendsByItsShareInsideTheBox) {
  SerialExecutor executor;
  SuperResolutionOptions options = PeerOptions("taau", 9, 9, 9, 9);
  options.parameters.taau_blend = 0.25f;
  options.parameters.taau_gamma = 16;
  options.history_format = PixelFormat::kRgba32F;
  ImageBuffer out = OutputOf(options);
  const auto shown = [&](float gamma) {
    options.parameters.taau_gamma = gamma;
    SuperResolution sr(options, executor);
    TestFrame frame(9, 9);
    for (int i = 0; i < 2; ++i) {
      for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 9; ++x) {
          const float v = i == 0 ? 0.5f : x == 4 && y == 4 ? 0.9f : 0.3f;
          frame.SetColor(x, y, v, v, v);
        }
      }
      sr.Process(frame.View(), out.view());
    }
    return At(out, 4, 4, 0);
  };
  const double side = std::exp(-2.29), corner = std::exp(-2 * 2.29);
  const double sample = (0.9 + 0.3 * (4 * side + 4 * corner)) / (1 + 4 * side + 4 * corner);
  EXPECT_NEAR(shown(16), 0.5 + 0.25 * (sample - 0.5), 1e-5);
  const double mean = (0.9 + 8 * 0.3) / 9;
  const double sigma = std::sqrt((0.81 + 8 * 0.09) / 9 - mean * mean);
  const double limited = mean + 0.25 * sigma;
  ASSERT_LT(limited, 0.5);
  EXPECT_NEAR(shown(0.25f), limited + 0.25 * (sample - limited), 1e-5);
}

}  // namespace
}  // namespace warplut
