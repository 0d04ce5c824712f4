// What must not change: constant images, settled histories, bits for any number of threads, and the
// heap.
#include <vector>

#include "tests/kernel_main.h"
#include "tests/runtime/counted_allocations.h"
#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

std::vector<SuperResolutionOptions> SomeOfEveryOption(const SuperResolutionOptions& base) {
  std::vector<SuperResolutionOptions> list;
  for (const HistoryForm form :
       {HistoryForm::kSample, HistoryForm::kResidual, HistoryForm::kAdaptive}) {
    for (const ColorClamp clamp : {ColorClamp::kNone, ColorClamp::kBox, ColorClamp::kVariance}) {
      for (const PixelFormat format :
           {PixelFormat::kRgba8, PixelFormat::kRgba16F, PixelFormat::kRgba32F}) {
        SuperResolutionOptions options = base;
        options.form = form;
        options.clamp = clamp;
        options.history_format = format;
        options.gate_width = clamp == ColorClamp::kBox ? 0.7f : 0.0f;
        options.warp.filter = Filter::kKeys;
        options.warp.keys_a = -0.7f;  // gain above 1
        list.push_back(options);
      }
    }
  }
  return list;
}

TEST(Stability, AConstantImageStaysConstant) {
  constexpr float kColor[3] = {0.2f, 0.6f, 1.0f};  // codes: an 8-bit history holds no others
  for (const SuperResolutionOptions& options : SomeOfEveryOption(TestOptions(19, 11, 33, 19))) {
    SerialExecutor executor;
    SuperResolution sr(options, executor);
    ImageBuffer out = OutputOf(options);
    TestFrame frame(19, 11);
    for (unsigned i = 0; i < 300; ++i) {
      frame.Randomise(i % 5, i % 5 == 3);  // jitter, depth and motion of it
      for (int y = 0; y < 11; ++y) {
        for (int x = 0; x < 19; ++x) frame.SetColor(x, y, kColor[0], kColor[1], kColor[2]);
      }
      sr.Process(frame.View(), out.view());
    }
    for (int y = 0; y < options.output_height; ++y) {
      for (int x = 0; x < options.output_width; ++x) {
        for (int c = 0; c < 3; ++c) {
          ASSERT_NEAR(At(out, x, y, c), kColor[c], 0.5f / 255.0f + 1e-6f)
              << Name(options.history_format) << " form " << static_cast<int>(options.form)
              << " clamp " << static_cast<int>(options.clamp);
        }
        ASSERT_EQ(At(out, x, y, 3), 1.0f);
      }
    }
  }
}

// A float history goes on settling in its last places for thousands of frames.
TEST(Stability, AStillImageSettlesToTheSameBits) {
  for (const SuperResolutionOptions& options :
       SomeOf(SomeOfEveryOption(TestOptions(13, 9, 26, 15)))) {
    if (options.history_format == PixelFormat::kRgba32F) continue;
    SerialExecutor executor;
    SuperResolution sr(options, executor);
    ImageBuffer out = OutputOf(options);
    ImageBuffer settled = OutputOf(options);
    TestFrame frame(13, 9);
    frame.Randomise(3);
    frame.jitter_x = frame.jitter_y = 0;
    frame.SetMotion(0, 0);
    for (int i = 0; i < 6000; ++i) sr.Process(frame.View(), settled.view());
    for (int i = 0; i < 100; ++i) {
      sr.Process(frame.View(), out.view());
      EXPECT_TRUE(SameBits(out, settled))
          << Name(options.history_format) << " form " << static_cast<int>(options.form) << " clamp "
          << static_cast<int>(options.clamp);
    }
  }
}

TEST(Stability, ALongJitterCycleSettlesToACycle) {
  constexpr int kCycle = 8;
  const SuperResolutionOptions options = TestOptions(12, 8, 24, 16);
  SerialExecutor executor;
  SuperResolution sr(options, executor);
  std::vector<TestFrame> frames;
  for (unsigned i = 0; i < kCycle; ++i) {
    TestFrame& frame = frames.emplace_back(12, 8);
    TestFrame jitter(1, 1);
    jitter.Randomise(i);
    frame.jitter_x = 0.5f * jitter.jitter_x;
    frame.jitter_y = 0.5f * jitter.jitter_y;
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 12; ++x) {
        const float u = static_cast<float>(x) + frame.jitter_x;
        const float v = static_cast<float>(y) + frame.jitter_y;
        frame.SetColor(x, y, 0.5f + 0.3f * std::sin(2.5f * u), 0.5f + 0.3f * std::cos(u - 1.7f * v),
                       u < 6 ? 0.0f : 1.0f);
      }
    }
  }
  ImageBuffer out = OutputOf(options);
  ImageBuffer early = OutputOf(options);  // one cycle before the end
  for (int i = 0; i < 10000; ++i) {
    ImageBuffer& target = i == 9999 - kCycle ? early : out;
    sr.Process(frames[static_cast<std::size_t>(i % kCycle)].View(), target.view());
  }
  // The rounding of the history keeps it moving within half a code value.
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 24; ++x) {
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(At(out, x, y, c), At(early, x, y, c), 0.5f / 255.0f);
    }
  }
}

TEST(Stability, TheSameBitsForAnyNumberOfThreads) {
  const SuperResolutionOptions options = TestOptions(71, 53, 142, 106);
  std::vector<std::vector<ImageBuffer>> runs;
  for (const int threads : {1, 2, 5}) {
    ThreadPool executor(threads);
    SuperResolution sr(options, executor);
    TestFrame frame(71, 53);
    std::vector<ImageBuffer>& outs = runs.emplace_back();
    for (unsigned i = 0; i < 4; ++i) {
      frame.Randomise(i);
      sr.Process(frame.View(), outs.emplace_back(OutputOf(options)).view());
    }
  }
  for (std::size_t i = 0; i < runs[0].size(); ++i) {
    EXPECT_TRUE(SameBits(runs[0][i], runs[1][i]));
    EXPECT_TRUE(SameBits(runs[0][i], runs[2][i]));
  }
}

TEST(Stability, ProcessDoesNotAllocate) {
  for (const SuperResolutionOptions& options : SomeOfEveryOption(TestOptions(31, 17, 62, 34))) {
    SerialExecutor executor;
    SuperResolution sr(options, executor);
    ImageBuffer out = OutputOf(options);
    TestFrame frame(31, 17);
    frame.Randomise(1);
    const int before = CountedAllocations();
    for (int i = 0; i < 3; ++i) sr.Process(frame.View(), out.view());
    EXPECT_EQ(CountedAllocations(), before);
  }
}

TEST(Stability, BrokenValuesNeverReachTheOutput) {
  for (const ColorEncoding encoding : {ColorEncoding::kDisplay, ColorEncoding::kLinearHdr}) {
    SuperResolutionOptions options = TestOptions(31, 17, 53, 34);
    options.encoding = encoding;
    SerialExecutor executor;
    SuperResolution sr(options, executor);
    ImageBuffer out = OutputOf(options);
    TestFrame frame(31, 17);
    for (unsigned i = 0; i < 20; ++i) {
      frame.Randomise(i, true);
      sr.Process(frame.View(), out.view());
      for (int y = 0; y < 34; ++y) {
        for (int x = 0; x < 53; ++x) {
          for (int c = 0; c < 3; ++c) {
            ASSERT_GE(At(out, x, y, c), 0.0f);
            ASSERT_LE(At(out, x, y, c), encoding == ColorEncoding::kDisplay ? 1.0f : kLargestHdr);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace warplut
