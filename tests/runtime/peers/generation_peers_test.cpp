// The peers of frame generation: fast against plain, and where their pixels come from.
#include "runtime/method.h"
#include "tests/image_difference.h"
#include "tests/runtime/counted_allocations.h"
#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

constexpr const char* kPeers[] = {"3dwarp", "3dwarp-e", "3dwarp-e-sheet", "mesh-e", "bidir"};
constexpr int kSizes[][2] = {{1, 1}, {3, 3}, {2, 5}, {17, 9}, {64, 16}, {67, 35}, {131, 50}};

FrameGenerationOptions PeerOptions(const char* peer, const TestFrame& frame) {
  FrameGenerationOptions options = OptionsFor(frame);
  FindMethod(peer)->configure_generation(options);
  options.warp.filter = Filter::kBilinear;
  return options;
}

bool Interpolates(const char* peer) {
  return FindMethod(peer)->generation == Generation::kInterpolation;
}

TestImage Shown(const char* peer, const TestFrame& frame0, const TestFrame& frame1, float alpha,
                bool cut0 = false) {
  return Generate(PeerOptions(peer, frame1), frame0.view(cut0), frame1.view(), alpha,
                  Interpolates(peer), frame1.color.format());
}

TEST(GenerationPeers, FastPassesAgree) {
  unsigned seed = 1;
  for (const auto& [width, height] : kSizes) {
    for (const PixelFormat format : {PixelFormat::kRgba8, PixelFormat::kRgba32F}) {
      for (const bool wild : {false, true}) {
        const TestFrame frame0 = RandomFrame(width, height, format, ++seed, wild);
        const TestFrame frame1 = RandomFrame(width, height, format, ++seed, wild);
        for (const char* peer : kPeers) {
          for (const bool cut0 : {false, true}) {
            FrameGenerationOptions options = PeerOptions(peer, frame1);
            const auto run = [&](bool reference) {
              options.reference = reference;
              return Generate(options, frame0.view(cut0), frame1.view(), 0.3f, Interpolates(peer),
                              format);
            };
            const double codes =
                Compare(run(false).view(), run(true).view()).largest * 255 / ChannelScale(format);
            EXPECT_LE(codes, format == PixelFormat::kRgba8 ? 1 : 0.3)
                << peer << ", " << width << " x " << height << ", seed " << seed;
          }
        }
      }
    }
  }
}

TEST(GenerationPeers, ManyThreadsGiveTheSameBits) {
  const TestFrame frame0 = RandomFrame(131, 90, PixelFormat::kRgba32F, 5);
  const TestFrame frame1 = RandomFrame(131, 90, PixelFormat::kRgba32F, 6);
  ThreadPool pool(3);
  for (const char* peer : kPeers) {
    const TestImage threads = Generate(PeerOptions(peer, frame1), frame0.view(), frame1.view(),
                                       0.5f, Interpolates(peer), PixelFormat::kRgba32F, pool);
    const TestImage one = Shown(peer, frame0, frame1, 0.5f);
    EXPECT_EQ(Compare(threads.view(), one.view()).largest, 0) << peer;
  }
}

// A texture that moves by (4, 2) from frame to frame.
TestFrame Panned(int shift) {
  TestFrame frame(48, 32, PixelFormat::kRgba32F);
  frame.motion = TestMotion(48, 32, 4, 2, 3);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 48; ++x) {
      const int u = x - 4 * shift, v = y - 2 * shift;
      for (int c = 0; c < 3; ++c) {
        frame.color.Set(x, y, c,
                        0.5f + 0.4f * std::sin(0.7f * static_cast<float>(u + c)) *
                                   std::cos(0.5f * static_cast<float>(v)));
      }
    }
  }
  return frame;
}

TEST(GenerationPeers, APanIsExact) {
  const TestFrame frame0 = Panned(0), frame1 = Panned(2);
  TestFrame moving1 = frame1;
  moving1.motion = TestMotion(48, 32, 8, 4, 3);
  TestFrame moving0 = frame0;
  moving0.motion = TestMotion(48, 32, 8, 4, 3);
  const TestFrame between = Panned(1), after = Panned(3);
  for (const char* peer : kPeers) {
    if (FindMethod(peer)->configure_generation == FindMethod("mesh")->configure_generation) {
      continue;  // its borders are anchored: tests of its own
    }
    const TestImage shown = Shown(peer, moving0, moving1, 0.5f);
    const TestFrame& wanted = Interpolates(peer) ? between : after;
    for (int y = 8; y < 24; ++y) {
      for (int x = 12; x < 36; ++x) {
        for (int c = 0; c < 3; ++c) {
          ASSERT_NEAR(shown.Get(x, y, c), wanted.color.Get(x, y, c), 1e-5) << peer << x << y;
        }
      }
    }
  }
}

// A white square before a grey ground moves right by 8 pixels in each frame; the ground stands.
TestFrame Square(int left) {
  TestFrame frame(64, 24, PixelFormat::kRgba32F, 0.9f);
  frame.motion = TestMotion(64, 24, 0, 0, 3);
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool inside = x >= left && x < left + 16 && y >= 4 && y < 20;
      for (int c = 0; c < 3; ++c) frame.color.Set(x, y, c, inside ? 1.0f : 0.25f);
      if (!inside) continue;
      frame.depth.Set(x, y, 0, 0.2f);
      frame.motion.Set(x, y, 8, 0);
    }
  }
  return frame;
}

TEST(GenerationPeers, WhatAppearsBehindAnObjectIsTheGround) {
  for (const char* peer : {"3dwarp", "3dwarp-e", "bidir"}) {
    const TestImage shown = Shown(peer, Square(16), Square(24), 0.5f);
    const int left = Interpolates(peer) ? 20 : 28;
    for (int x = 2; x < 62; ++x) {
      // Edges may be off by what lies between two pixels.
      if (std::abs(x - left) <= 1 || std::abs(x - left - 15) <= 1) continue;
      const float wanted = x >= left && x < left + 16 ? 1.0f : 0.25f;
      EXPECT_NEAR(shown.Get(x, 12, 0), wanted, 1e-5) << peer << " " << x;
    }
  }
}

TEST(GenerationPeers, AStretchedMeshBlendsFromTheObjectToTheGround) {
  const TestImage shown = Shown("3dwarp-e-sheet", Square(16), Square(24), 0.5f);
  // The quad between the ground's column 23 and the object's 24 spans columns 23 to 28.
  EXPECT_NEAR(shown.Get(23, 12, 0), 0.25f, 1e-5);
  for (int x = 24; x < 28; ++x) EXPECT_GT(shown.Get(x, 12, 0), shown.Get(x - 1, 12, 0)) << x;
  EXPECT_NEAR(shown.Get(28, 12, 0), 1.0f, 1e-5);
}

TEST(MeshWarp, AZoomLeavesNoHoles) {
  TestFrame frame(64, 40, PixelFormat::kRgba32F);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 64; ++x) {
      frame.motion.Set(x, y, 1.3f * static_cast<float>(x - 32), 1.3f * static_cast<float>(y - 20));
    }
  }
  SerialExecutor executor;
  FrameGeneration generation(PeerOptions("3dwarp-e", frame), executor);
  TestImage out(64, 40, PixelFormat::kRgba32F, 16);
  generation.Extrapolate(frame.view(), frame.view(), 0.9f, out.view());
  EXPECT_EQ(generation.Tiles().disoccluded, 0);
}

TEST(MeshWarp, AQuadThatIsTooLongIsNotDrawn) {
  TestFrame frame = Square(24);
  for (int y = 0; y < 24; ++y) {
    for (int x = 32; x < 64; ++x) {
      frame.motion.Set(x, y, 400, 0);
      frame.depth.Set(x, y, 0, 0.9f);
    }
  }
  SerialExecutor executor;
  FrameGeneration generation(PeerOptions("3dwarp-e", frame), executor);
  TestImage out(64, 24, PixelFormat::kRgba32F, 16);
  generation.Extrapolate(frame.view(), frame.view(), 0.5f, out.view());
  EXPECT_GT(generation.Tiles().disoccluded, 0);
}

// The motion of a first frame leads nowhere: it is not read.
TEST(Bidirectional, ReadsNoMotionOfACut) {
  TestFrame frame0 = Panned(0), frame1 = Panned(2);
  frame1.motion = TestMotion(48, 32, 8, 4, 3);
  frame0.motion = TestMotion(48, 32, 8, 4, 3);
  const TestImage shown = Shown("bidir", frame0, frame1, 0.5f, true);
  frame0.motion = TestMotion(48, 32, -30, 7, 3);
  EXPECT_EQ(Compare(shown.view(), Shown("bidir", frame0, frame1, 0.5f, true).view()).largest, 0);
  EXPECT_GT(Compare(shown.view(), Shown("bidir", frame0, frame1, 0.5f).view()).largest, 0);
}

// Where every search misses by more than the tolerance, the one that misses by less is shown.
TEST(Bidirectional, ToleranceDecidesWhichSourcesCount) {
  const TestFrame frame0 = RandomFrame(64, 48, PixelFormat::kRgba32F, 8, false);
  const TestFrame frame1 = RandomFrame(64, 48, PixelFormat::kRgba32F, 9, false);
  FrameGenerationOptions options = PeerOptions("bidir", frame1);
  const auto run = [&](float tolerance) {
    options.parameters.bidir_tolerance = tolerance;
    return Generate(options, frame0.view(), frame1.view(), 0.5f, true, PixelFormat::kRgba32F);
  };
  EXPECT_GT(Compare(run(0.0625f).view(), run(8).view()).largest, 0);
}

TEST(GenerationPeers, NothingIsAllocatedByAFrame) {
  const TestFrame frame0 = RandomFrame(64, 48, PixelFormat::kRgba8, 3);
  const TestFrame frame1 = RandomFrame(64, 48, PixelFormat::kRgba8, 4);
  SerialExecutor executor;
  for (const char* peer : kPeers) {
    FrameGeneration generation(PeerOptions(peer, frame1), executor);
    TestImage out(64, 48, PixelFormat::kRgba8, 12);
    const int before = CountedAllocations();
    if (Interpolates(peer)) {
      generation.Interpolate(frame0.view(), frame1.view(), 0.5f, out.view());
    } else {
      generation.Extrapolate(frame0.view(), frame1.view(), 0.5f, out.view());
    }
    EXPECT_EQ(CountedAllocations(), before) << peer;
  }
}

}  // namespace
}  // namespace warplut::generation
