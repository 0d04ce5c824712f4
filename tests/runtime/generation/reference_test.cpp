// The fast passes against the plain ones.
#include <algorithm>

#include "runtime/generation/row_kernels.h"
#include "tests/image_difference.h"
#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

constexpr int kSizes[][2] = {{1, 1}, {3, 3}, {2, 5}, {17, 9}, {64, 16}, {67, 35}, {131, 50}};

// The largest difference of two images, in code values.
double CodeDifference(const TestImage& a, const TestImage& b) {
  return Compare(a.view(), b.view()).largest * 255 / ChannelScale(a.format());
}

std::vector<FrameGenerationOptions> Variants(const TestFrame& frame) {
  std::vector<FrameGenerationOptions> variants(13, OptionsFor(frame));
  variants[1].motion_model = MotionModel::kLinear;
  variants[2].refine = false;
  variants[3].fill = DisocclusionFill::kBackground;
  variants[4].fill = DisocclusionFill::kNone;
  variants[5].depth = DepthMeasure::kAbsolute;
  variants[6].depth = DepthMeasure::kNone;
  variants[7].brightness_gate = true;
  variants[8].brightness_gate = true;
  variants[8].gate_width = 0.5f;
  variants[9].splat = false;
  for (std::size_t v = 10; v < variants.size(); ++v) {
    variants[v].motion_model = MotionModel::kPerspective;
  }
  variants[11].depth = DepthMeasure::kNone;
  variants[12].gate_width = 0.5f;
  return variants;
}

// Warps differ by their own bounds, which move a pixel's blend by as much, but with a hard
// brightness gate.
TEST(Reference, FastPassesAgree) {
  unsigned seed = 1;
  for (const auto& [width, height] : kSizes) {
    for (const PixelFormat format :
         {PixelFormat::kRgba8, PixelFormat::kRgba16F, PixelFormat::kRgba32F}) {
      const TestFrame frame0 = RandomFrame(width, height, format, ++seed);
      const TestFrame frame1 = RandomFrame(width, height, format, ++seed);
      const auto variants = Variants(frame0);
      for (std::size_t v = 0; v < variants.size(); ++v) {
        // Ratios of unlike depths make weights of 1e-30, which count beside texels of 1e30 alone.
        const bool unlike = variants[v].motion_model == MotionModel::kPerspective &&
                            variants[v].depth == DepthMeasure::kNone;
        if (unlike && format != PixelFormat::kRgba8) continue;
        SCOPED_TRACE(testing::Message() << width << " x " << height << " " << Name(format)
                                        << " variant " << v << " seed " << seed);
        FrameGenerationOptions fast = variants[v], plain = variants[v];
        fast.warp.filter = plain.warp.filter = Filter::kBilinear;
        plain.reference = true;
        for (const bool interpolates : {true, false}) {
          const auto run = [&](const FrameGenerationOptions& options) {
            return Generate(options, frame0.view(), frame1.view(), 0.3f, interpolates, format);
          };
          EXPECT_LE(CodeDifference(run(fast), run(plain)),
                    format == PixelFormat::kRgba8 ? 1 : 0.3f);
        }
      }
    }
  }
}

TEST(Reference, FastPassesAgreeWithTablesOfMoreTaps) {
  unsigned seed = 100;
  for (const Footprint footprint : {Footprint::k24, Footprint::k36}) {
    const Table table(MakeWideTable(TableFormat::kI16, footprint).view());
    for (const auto& [width, height] : kSizes) {
      const PixelFormat format = PixelFormat::kRgba32F;
      const TestFrame frame0 = RandomFrame(width, height, format, ++seed);
      const TestFrame frame1 = RandomFrame(width, height, format, ++seed);
      for (const bool interpolates : {true, false}) {
        const auto run = [&](bool reference) {
          FrameGenerationOptions options = OptionsFor(frame0);
          options.warp = {.filter = Filter::kLut, .table = &table};
          options.reference = reference;
          return Generate(options, frame0.view(), frame1.view(), 0.3f, interpolates, format);
        };
        EXPECT_LE(CodeDifference(run(false), run(true)), 0.3f)
            << TapCount(footprint) << " taps, " << width << " x " << height;
      }
    }
  }
}

struct Passes {
  std::vector<float> forward, from0, from1;
  std::vector<float> own0, own1;  // without splatting
  std::vector<RowRange> reach;
  std::vector<SplatKey> keys;
  std::vector<std::uint8_t> disoccluded;
};

Passes RunPasses(const RowKernels& kernels, const GenerationJob& job) {
  const int width = job.width(), height = job.height();
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::vector<float> vectors(2 * pixels);
  Passes p{vectors,
           vectors,
           vectors,
           vectors,
           vectors,
           std::vector<RowRange>(),
           std::vector<SplatKey>(pixels, kNoSplat),
           std::vector<std::uint8_t>(static_cast<std::size_t>(TileCount(width, kTileWidth)))};
  const auto view = [&](std::vector<float>& xy) {
    return MutableMotionView{xy.data(), width, height, std::ptrdiff_t{8} * width};
  };
  const KeyView keys{p.keys.data(), width};
  for (int y = 0; y < height; ++y) p.reach.push_back(kernels.forward(job, y, view(p.forward)));
  for (int y = 0; y < height; ++y) kernels.splat(job, view(p.forward), y, {0, height}, keys);
  for (int y = 0; y < height; ++y) {
    kernels.target_motion(job, {view(p.forward), keys}, y, view(p.from0), view(p.from1),
                          p.disoccluded.data());
    kernels.forward(job, y, view(p.own1));
    kernels.own_motion(job, y, view(p.own0), view(p.own1));
  }
  return p;
}

// The bits of every pass, a NaN being equal to any other.
void ExpectSame(const std::vector<float>& a, const std::vector<float>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_TRUE(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])))
        << i << " " << a[i] << " " << b[i];
  }
}

TEST(Reference, MotionIsTheSameToTheBit) {
  unsigned seed = 100;
  for (const auto& [width, height] : kSizes) {
    const TestFrame frame0 = RandomFrame(width, height, PixelFormat::kRgba8, ++seed);
    const TestFrame frame1 = RandomFrame(width, height, PixelFormat::kRgba8, ++seed);
    for (const FrameGenerationOptions& options : Variants(frame0)) {
      for (const bool interpolates : {true, false}) {
        SCOPED_TRACE(testing::Message() << width << " x " << height);
        const GenerationJob job{options,
                                interpolates,
                                0.3f,
                                options.motion_model != MotionModel::kLinear,
                                frame0.depth.view(),
                                frame1.depth.view(),
                                frame0.motion.view(),
                                frame1.motion.view()};
        const Passes fast = RunPasses(FastRowKernels(), job);
        const Passes plain = RunPasses(ReferenceRowKernels(), job);
        ExpectSame(fast.forward, plain.forward);
        EXPECT_EQ(fast.keys, plain.keys);
        EXPECT_EQ(fast.disoccluded, plain.disoccluded);
        ExpectSame(fast.from0, plain.from0);
        ExpectSame(fast.from1, plain.from1);
        ExpectSame(fast.own0, plain.own0);
        ExpectSame(fast.own1, plain.own1);
        for (int y = 0; y < height; ++y) {
          const RowRange f = fast.reach[static_cast<std::size_t>(y)];
          const RowRange r = plain.reach[static_cast<std::size_t>(y)];
          EXPECT_TRUE(r.first >= r.last || (f.first <= r.first && f.last >= r.last));
        }
      }
    }
  }
}

TEST(Reference, AnyThreadCountGivesTheSameBits) {
  for (const ColorEncoding encoding : {ColorEncoding::kDisplay, ColorEncoding::kLinearHdr}) {
    for (const PixelFormat format : {PixelFormat::kRgba8, PixelFormat::kRgba16F}) {
      const TestFrame frame0 = RandomFrame(131, 77, format, 7);
      const TestFrame frame1 = RandomFrame(131, 77, format, 8);
      FrameGenerationOptions options = OptionsFor(frame0);
      options.encoding = encoding;
      for (const bool interpolates : {true, false}) {
        const TestImage one =
            Generate(options, frame0.view(), frame1.view(), 0.6f, interpolates, format);
        for (const int threads : {2, 5}) {
          ThreadPool pool(threads);
          EXPECT_TRUE(one == Generate(options, frame0.view(), frame1.view(), 0.6f, interpolates,
                                      format, pool))
              << threads;
        }
      }
    }
  }
}

}  // namespace
}  // namespace warplut::generation
