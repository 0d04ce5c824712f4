// The runtime computes the same bits in any environment of its caller, and leaves that as it was.
#include "runtime/float_environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "runtime/frame_generation.h"
#include "runtime/motion_filter.h"
#include "runtime/super_resolution.h"
#include "tests/runtime/warp/warp_fixture.h"

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace warplut {
namespace {

constexpr int kWidth = 70, kHeight = 19;  // more than a tile
constexpr float kSubnormal = 1e-40f;

#if defined(__SSE__)
struct Control {
  static unsigned Get() { return _mm_getcsr(); }
  static void Set(unsigned value) { _mm_setcsr(value); }
  static constexpr unsigned kDefault = 0x1F80;
  // Flushed; to zero, up and down; a flag raised; divisions by zero and NaNs trap.
  static constexpr unsigned kOthers[] = {0x9FC0, 0x7F80, 0x5F80, 0x3F80, 0x1FBF, 0x1D00};
};
#elif defined(__aarch64__)
struct Control {
  static unsigned Get() {
    unsigned long value;
    asm volatile("mrs %0, fpcr" : "=r"(value));
    return static_cast<unsigned>(value);
  }
  static void Set(unsigned value) {
    asm volatile("msr fpcr, %0" : : "r"(static_cast<unsigned long>(value)) : "memory");
  }
  static constexpr unsigned kDefault = 0;
  // Flushed, halves too; to zero, up and down; NaNs made one.
  static constexpr unsigned kOthers[] = {1u << 24 | 1u << 19, 3u << 22, 1u << 22, 2u << 22,
                                         1u << 25};
};
#else
struct Control {
  static unsigned Get() { return 0; }
  static void Set(unsigned) {}
  static constexpr unsigned kDefault = 0;
  static constexpr unsigned kOthers[] = {0};
};
#endif

// Numbers of every size, subnormals and zeros too.
TestImage MakeImage(PixelFormat format, unsigned seed) {
  TestImage image(kWidth, kHeight, format);
  image.Randomise(seed);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (int c = 0; c < Channels(format); ++c) {
        const float value = std::abs(image.Get(x, y, c));
        if (x % 5 == 0) image.Set(x, y, c, kSubnormal * value);
        if (x % 5 == 1) image.Set(x, y, c, 1e-6f * value);  // a subnormal half
        if (x % 5 == 2) image.Set(x, y, c, value);
        if (x % 7 == 0) image.Set(x, y, c, 0);
      }
    }
  }
  return image;
}

TestMotion MakeMotion(unsigned seed) {
  TestMotion motion(kWidth, kHeight, 0.3f, -1.2f);
  motion.Randomise(seed, 3);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; x += 3) {
      motion.Set(x, y, x % 2 == 0 ? kSubnormal : -kSubnormal, y % 2 == 0 ? 0.25f : -kSubnormal);
    }
  }
  return motion;
}

TestImage MakeDepth(unsigned seed) {
  TestImage depth = MakeImage(PixelFormat::kR32F, seed);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) depth.Set(x, y, 0, std::abs(depth.Get(x, y, 0)));
  }
  return depth;
}

// Everything that the runtime makes of what is given, in one row of bytes.
class Bits {
 public:
  void Add(const ImageView& image) {
    for (int y = 0; y < image.height; ++y) {
      const auto* row = image.Row<char>(y);
      bytes_.append(row, static_cast<std::size_t>(image.width) * BytesPerPixel(image.format));
    }
  }
  void Add(const MotionView& motion) {
    for (int y = 0; y < motion.height; ++y) {
      bytes_.append(reinterpret_cast<const char*>(motion.Row(y)),
                    static_cast<std::size_t>(motion.width) * 2 * sizeof(float));
    }
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

std::string WarpBits(const TestTable& stored, const TestImage& image, const TestMotion& motion,
                     bool reference) {
  const Table table(stored.view());
  Bits bits;
  for (const TestFilter& filter : TestFilters(&table)) {
    const TestHistory history(image, filter.options);
    TestImage out(kWidth, kHeight, image.format());
    if (reference) {
      history.ReferenceTo(motion.view(), filter.options, out);
    } else {
      history.WarpTo(motion.view(), filter.options, out);
    }
    bits.Add(out.history());
  }
  return bits.bytes();
}

std::string PrefilterBits(const TestImage& image, bool reference) {
  const Prefilter prefilter = PrefilterOf({.filter = Filter::kSpline, .spline_k = 0.021f});
  TestImage out(kWidth, kHeight, CoefficientFormat(image.format()));
  ThreadPool pool(2);
  if (reference) {
    PrefilterPass::Reference(prefilter, image.history(), out.view());
  } else {
    PrefilterPass(prefilter, kWidth, kHeight, pool.Threads())
        .Apply(image.history(), pool, out.view());
  }
  Bits bits;
  bits.Add(out.history());
  return bits.bytes();
}

std::string MotionFilterBits(const TestImage& depth, const TestMotion& motion, bool reference) {
  MotionBuffer out(kWidth, kHeight);
  ThreadPool pool(2);
  if (reference) {
    MotionFilter::Reference(depth.history(), motion.view(), {}, out.view());
  } else {
    MotionFilter(kWidth, kHeight, {}).Apply(depth.history(), motion.view(), pool, out.view());
  }
  Bits bits;
  bits.Add(out.view());
  return bits.bytes();
}

struct Frames {
  explicit Frames(PixelFormat format) {
    for (unsigned i = 0; i < 3; ++i) {
      color.push_back(MakeImage(format, 3 * i + 1));
      depth.push_back(MakeDepth(3 * i + 2));
      motion.push_back(MakeMotion(3 * i + 3));
    }
  }
  std::vector<TestImage> color, depth;
  std::vector<TestMotion> motion;
};

std::string SuperResolutionBits(const Frames& frames, ColorEncoding encoding, bool reference) {
  SuperResolutionOptions options;
  options.render_width = kWidth;
  options.render_height = kHeight;
  options.output_width = 2 * kWidth - 7;
  options.output_height = 2 * kHeight - 3;
  options.encoding = encoding;
  options.reference = reference;
  options.history_format = frames.color[0].format();
  ThreadPool pool(2);
  SuperResolution sr(options, pool);
  Bits bits;
  for (std::size_t i = 0; i < frames.color.size(); ++i) {
    ImageBuffer out(options.output_width, options.output_height, PixelFormat::kRgba32F);
    sr.Process({.color = frames.color[i].history(),
                .depth = frames.depth[i].history(),
                .motion = frames.motion[i].view(),
                .jitter_x = 0.21f},
               out.view());
    bits.Add(out.view());
    bits.Add(sr.Geometry().depth);
    bits.Add(sr.Geometry().motion);
  }
  return bits.bytes();
}

std::string GenerationBits(const Frames& frames, ColorEncoding encoding, bool reference) {
  FrameGenerationOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.encoding = encoding;
  options.reference = reference;
  ThreadPool pool(2);
  FrameGeneration generation(options, pool);
  const auto frame = [&](std::size_t i) {
    return DisplayedFrame{frames.color[i].history(), frames.depth[i].history(),
                          frames.motion[i].view()};
  };
  Bits bits;
  TestImage out(kWidth, kHeight, PixelFormat::kRgba32F);
  generation.Interpolate(frame(0), frame(1), 0.3f, out.view());
  bits.Add(out.history());
  generation.Extrapolate(frame(1), frame(2), 0.7f, out.view());
  bits.Add(out.history());
  return bits.bytes();
}

// Calls make() in every environment: the same bits each time, and the environment kept.
template <class Make>
void ExpectSameBits(const std::string& name, const Make& make) {
  const std::string expected = make();
  for (const unsigned other : Control::kOthers) {
    Control::Set(other);
    const std::string bits = make();
    const unsigned after = Control::Get();
    Control::Set(Control::kDefault);
    // Exception flags are those that the test itself raises.
    EXPECT_EQ(after & ~0x3Fu, other & ~0x3Fu) << name;
    EXPECT_TRUE(bits == expected) << name << ", environment " << std::hex << other;
  }
}

TEST(FloatEnvironment, IsThatOfTheCallerAfterwards) {
  for (const unsigned value : Control::kOthers) {
    Control::Set(value);
    unsigned inside, nested;
    {
      const FloatEnvironment environment;
      inside = Control::Get();
      {
        const FloatEnvironment again;
        volatile float zero = 0;
        zero = 1 / zero;  // raises a flag
      }
      nested = Control::Get();
    }
    const unsigned after = Control::Get();
    Control::Set(Control::kDefault);
    EXPECT_EQ(after, value);
    EXPECT_EQ(inside, nested);
  }
}

TEST(FloatEnvironment, IsSetWhereAnExecutorRunsPieces) {
  const auto check = [](Executor& executor) {
    std::vector<float> results(64, 1.0f);
    executor.ForEach(64, [&](int i) {
      volatile float least = std::numeric_limits<float>::min();
      results[static_cast<std::size_t>(i)] = least * 0.5f;
    });
    for (const float result : results) EXPECT_EQ(result, Control::kOthers[0] == 0 ? 0x1p-127f : 0);
  };
  SerialExecutor serial;
  check(serial);
  ThreadPool pool(3);
  check(pool);
}

class FloatEnvironmentOfPasses : public testing::TestWithParam<PixelFormat> {};

TEST_P(FloatEnvironmentOfPasses, SameBitsWhateverTheCallers) {
  const TestTable table = MakeKeysTable(TableFormat::kF32);
  const TestImage image = MakeImage(GetParam(), 1);
  const TestMotion motion = MakeMotion(2);
  const auto check = [&](bool reference) {
    SCOPED_TRACE(reference ? "reference" : "fast");
    ExpectSameBits("warp", [&] { return WarpBits(table, image, motion, reference); });
    ExpectSameBits("prefilter", [&] { return PrefilterBits(image, reference); });
    if (GetParam() == PixelFormat::kR32F) {
      ExpectSameBits("motion filter", [&] { return MotionFilterBits(image, motion, reference); });
      return;
    }
    const Frames frames(GetParam());
    for (const ColorEncoding encoding : {ColorEncoding::kDisplay, ColorEncoding::kLinearHdr}) {
      ExpectSameBits("super resolution",
                     [&] { return SuperResolutionBits(frames, encoding, reference); });
      ExpectSameBits("generation", [&] { return GenerationBits(frames, encoding, reference); });
    }
  };
  check(true);
  check(false);
}

INSTANTIATE_TEST_SUITE_P(Formats, FloatEnvironmentOfPasses, testing::ValuesIn(kPixelFormats),
                         [](const auto& test) { return std::string(Name(test.param)); });

// Plain and fast alike; whole-pixel motion copies.
TEST(FloatEnvironment, WarpsFlushSubnormalsAndCopiesKeepThem) {
  if (Control::kOthers[0] == 0) GTEST_SKIP() << "the environment is the caller's here";
  TestImage history(kWidth, kHeight, PixelFormat::kRgba32F);
  history.Fill(kSubnormal);
  const WarpOptions options;
  for (const bool reference : {false, true}) {
    const auto warp = [&](const TestMotion& motion, TestImage& out) {
      if (reference) {
        WarpReference(history.history(), motion.view(), options, out.view());
      } else {
        Warp(history.history(), motion.view(), options, out.view());
      }
    };
    TestImage flushed(kWidth, kHeight, PixelFormat::kRgba32F), copied = flushed;
    warp(TestMotion(kWidth, kHeight, 0.5f, 0.25f), flushed);
    warp(TestMotion(kWidth, kHeight, 3, -2), copied);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        for (int c = 0; c < 4; ++c) {
          ASSERT_EQ(flushed.Get(x, y, c), 0);
          ASSERT_EQ(copied.Get(x, y, c), kSubnormal);
        }
      }
    }
  }
}

// Of halves every one counts, as a float that is not subnormal.
TEST(FloatEnvironment, SubnormalHalvesCount) {
  TestImage color(kWidth, kHeight, PixelFormat::kRgba16F);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (int c = 0; c < 4; ++c) color.Set(x, y, c, static_cast<float>(x) * 0x1p-24f);
    }
  }
  const TestImage depth(kWidth, kHeight, PixelFormat::kR32F);
  const TestMotion motion(kWidth, kHeight);
  SuperResolutionOptions options;
  options.render_width = options.output_width = kWidth;
  options.render_height = options.output_height = kHeight;
  options.history_format = PixelFormat::kRgba32F;
  SerialExecutor executor;
  SuperResolution sr(options, executor);
  TestImage out(kWidth, kHeight, PixelFormat::kRgba32F);
  sr.Process({.color = color.history(), .depth = depth.history(), .motion = motion.view()},
             out.view());
  for (int x = 0; x < kWidth; ++x) {
    ASSERT_EQ(out.Get(x, kHeight / 2, 1), static_cast<float>(x) * 0x1p-24f);
  }
  TestImage warped(kWidth, kHeight, PixelFormat::kRgba16F);
  Warp(color.history(), TestMotion(kWidth, kHeight, 0, 0.5f).view(), {}, warped.view());
  for (int x = 0; x < kWidth; ++x) {
    ASSERT_EQ(warped.Get(x, kHeight / 2, 1), static_cast<float>(x) * 0x1p-24f);
  }
}

}  // namespace
}  // namespace warplut
