// Super resolution on a GPU against the processor: every choice, odd sizes, broken input, cuts.
#include "runtime/gpu/gpu_super_resolution.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <utility>

#include "luts/baked/warplut_iir_x2.h"
#include "luts/baked/warplut_t24_x2.h"
#include "luts/baked/warplut_x2.h"
#include "tests/runtime/gpu/gpu_fixture.h"

namespace warplut {
namespace {

using Configure = std::function<void(SuperResolutionOptions&)>;

struct Size {
  int render_width, render_height, output_width, output_height;
};
constexpr Size kSize = {48, 36, 96, 72};

class GpuSuperResolutionTest : public GpuTest {
 protected:
  // Random frames through both, the fourth a cut.
  void Compare(const Size& size, const Configure& configure, const std::string& what,
               bool broken = false, int frames = 6) {
    for (const PixelFormat format : {PixelFormat::kRgba32F, PixelFormat::kRgba16F}) {
      SuperResolutionOptions options =
          TestOptions(size.render_width, size.render_height, size.output_width, size.output_height);
      options.warp.filter = Filter::kLut;
      options.warp.table = &table_;
      options.history_format = format;
      configure(options);
      std::string why;
      ASSERT_TRUE(options.IsValid(&why)) << why;
      ASSERT_TRUE(GpuSuperResolution::IsRunnable(device(), options, &why)) << why;
      SerialExecutor executor;
      SuperResolution cpu(options, executor);
      GpuSuperResolution gpu(device(), options);
      ImageBuffer expected = OutputOf(options), found = OutputOf(options);
      TestFrame frame(size.render_width, size.render_height);
      for (int i = 0; i < frames; ++i) {
        frame.Randomise(static_cast<unsigned>(i), broken);
        frame.cut = i == 3;
        cpu.Process(frame.View(), expected.view());
        gpu.Process(frame.View(), found.view());
        ExpectClose(found, expected, format == PixelFormat::kRgba32F ? kGpuBound32 : kGpuBound16,
                    what + ", " + Name(format) + ", frame " + std::to_string(i));
      }
    }
  }

  const Table table_{baked::kWarplutIirX2};
};

TEST_F(GpuSuperResolutionTest, EveryFormAgrees) {
  for (const HistoryForm form :
       {HistoryForm::kSample, HistoryForm::kResidual, HistoryForm::kAdaptive}) {
    Compare(
        kSize, [&](auto& options) { options.form = form; }, Name(form));
  }
}

TEST_F(GpuSuperResolutionTest, EveryClampAndDepthMeasureAgrees) {
  for (const ColorClamp clamp : {ColorClamp::kNone, ColorClamp::kBox, ColorClamp::kVariance})
    Compare(
        kSize, [&](auto& options) { options.clamp = clamp; }, Name(clamp));
  for (const DepthMeasure depth :
       {DepthMeasure::kNone, DepthMeasure::kAbsolute, DepthMeasure::kRelative})
    Compare(
        kSize, [&](auto& options) { options.depth = depth; }, Name(depth));
  Compare(
      kSize, [](auto& options) { options.gate_width = 0.5f; }, "wide gates");
}

TEST_F(GpuSuperResolutionTest, EveryMotionAndCurrentFrameAgrees) {
  for (const MotionUpsampling motion : {MotionUpsampling::kNearest, MotionUpsampling::kDilated,
                                        MotionUpsampling::kEdgeAware, MotionUpsampling::kStatic})
    Compare(
        kSize, [&](auto& options) { options.motion = motion; }, Name(motion));
  for (const bool history : {true, false}) {
    Compare(
        kSize,
        [&](auto& options) {
          options.current = CurrentFrame::kBicubic;
          options.history = history;
        },
        "bicubic");
  }
}

TEST_F(GpuSuperResolutionTest, FilteredMotionAgrees) {
  Compare(
      kSize, [](auto& options) { options.motion_filter = true; }, "filtered motion");
}

TEST_F(GpuSuperResolutionTest, EveryFilterAgrees) {
  for (const FilterInfo& info : kFilters)
    Compare(
        kSize, [&](auto& options) { options.warp.filter = info.filter; }, info.name);
  const Table plain(baked::kWarplutX2), wide(baked::kWarplutT24X2);
  for (const Table* table : {&table_, &plain, &wide}) {
    for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear}) {
      Compare(
          kSize,
          [&](auto& options) {
            options.warp.table = table;
            options.warp.lookup = lookup;
          },
          std::string("table, ") + Name(lookup));
    }
  }
}

TEST_F(GpuSuperResolutionTest, OddSizesAgree) {
  for (const Size& size : {Size{1, 1, 1, 1}, Size{1, 1, 4, 4}, Size{3, 5, 3, 5}, Size{3, 5, 7, 11},
                           Size{31, 17, 40, 23}, Size{16, 16, 64, 64}})
    Compare(
        size, [](auto&) {}, std::to_string(size.output_width) + " wide");
  Compare(
      {321, 180, 641, 359}, [](auto&) {}, "641 x 359", false, 3);
}

TEST_F(GpuSuperResolutionTest, BrokenInputAgrees) {
  Compare(
      kSize, [](auto&) {}, "broken", true);
  Compare(
      kSize, [](auto& options) { options.motion = MotionUpsampling::kDilated; }, "broken, dilated",
      true);
}

// Blocks of values among some that no mask should have.
ImageBuffer RandomMask(int width, int height, unsigned seed) {
  ImageBuffer mask(width, height, PixelFormat::kR32F);
  std::mt19937 random(seed);
  const float broken[4] = {kNaN, kInfinity, -kInfinity, 2.5f};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto block = static_cast<unsigned>(x / 6 + 3 * (y / 5));
      mask.view().Row<float>(y)[x] =
          random() % 32 == 0 ? broken[random() % 4] : static_cast<float>(block * seed % 3) / 2;
    }
  }
  return mask;
}

TEST_F(GpuSuperResolutionTest, ReactiveMasksAgree) {
  for (const MotionUpsampling motion : {MotionUpsampling::kEdgeAware, MotionUpsampling::kStatic}) {
    for (const HistoryForm form : {HistoryForm::kSample, HistoryForm::kAdaptive}) {
      SuperResolutionOptions options = TestOptions(41, 23, 70, 46);
      options.warp.filter = Filter::kCatmullRom;
      options.history_format = PixelFormat::kRgba32F;
      options.motion = motion;
      options.form = form;
      options.reactive = true;
      SerialExecutor executor;
      SuperResolution cpu(options, executor);
      GpuSuperResolution gpu(device(), options);
      options.reactive = false;
      SuperResolution without(options, executor);
      ImageBuffer expected = OutputOf(options), found = OutputOf(options);
      ImageBuffer plain = OutputOf(options);
      TestFrame frame(41, 23);
      for (unsigned i = 0; i < 5; ++i) {
        frame.Randomise(i, i == 2);
        const ImageBuffer mask = RandomMask(41, 23, i + 1);
        RenderedFrame view = frame.View();
        without.Process(view, plain.view());
        if (i != 3) view.reactive = mask.view();  // a frame may come without
        cpu.Process(view, expected.view());
        gpu.Process(view, found.view());
        const std::string what =
            std::string(Name(form)) + ", " + Name(motion) + ", frame " + std::to_string(i);
        ExpectClose(found, expected, kGpuBound32, what);
        // The mask counts.
        if (i > 0) {
          EXPECT_GT(Difference(plain, expected, 0).mean, 1e-3) << what;
        }
      }
    }
  }
}

// The share of pixels whose depths differ: a place between two samples may fall to either.
double DifferingDepths(const OutputGeometry& a, const OutputGeometry& b) {
  int differing = 0;
  for (int y = 0; y < a.depth.height; ++y) {
    for (int x = 0; x < a.depth.width; ++x)
      differing += std::abs(a.depth.Row<float>(y)[x] - b.depth.Row<float>(y)[x]) > 1e-5f ? 1 : 0;
  }
  return static_cast<double>(differing) / (a.depth.width * a.depth.height);
}

// Dynamic resolution: sizes change from frame to frame, and the history is kept.
TEST_F(GpuSuperResolutionTest, RenderSizesThatChangeAgree) {
  for (const bool halves : {false, true}) {
    SuperResolutionOptions options = TestOptions(72, 48, 96, 64);
    options.warp.filter = Filter::kLut;
    options.warp.table = &table_;
    options.history_format = halves ? PixelFormat::kRgba16F : PixelFormat::kRgba32F;
    options.reactive = options.motion_filter = true;
    SerialExecutor executor;
    SuperResolution cpu(options, executor);
    GpuSuperResolution gpu(device(), options, {}, true);
    ImageBuffer expected = OutputOf(options), found = OutputOf(options);
    const int sizes[][2] = {{72, 48}, {48, 32}, {37, 29}, {37, 29}, {24, 16}, {71, 47}, {72, 48}};
    unsigned seed = 0;
    for (const auto& [width, height] : sizes) {
      ASSERT_TRUE(gpu.IsRenderSize(width, height));
      cpu.SetRenderSize(width, height);
      gpu.SetRenderSize(width, height);
      TestFrame frame(width, height);
      ++seed;
      frame.Randomise(seed, seed == 4);
      const ImageBuffer mask = RandomMask(width, height, seed);
      RenderedFrame view = frame.View();
      view.reactive = mask.view();
      cpu.Process(view, expected.view());
      gpu.Process(view, found.view());
      const std::string what = std::to_string(width) + " x " + std::to_string(height);
      ExpectClose(found, expected, halves ? kGpuBound16 : kGpuBound32, what);
      // The geometry stays that of the last frame when the next size is set.
      gpu.SetRenderSize(24, 16);
      cpu.SetRenderSize(24, 16);
      EXPECT_LE(DifferingDepths(gpu.Geometry(), cpu.Geometry()), kGpuBound32.rare) << what;
    }
  }
}

TEST_F(GpuSuperResolutionTest, RenderSizesAreBounded) {
  const GpuSuperResolution gpu(device(), TestOptions(72, 48, 96, 64));
  std::string why;
  EXPECT_TRUE(gpu.IsRenderSize(24, 16, &why)) << why;
  for (const auto& [width, height] : {std::pair{73, 48}, {72, 49}, {23, 48}, {72, 15}}) {
    EXPECT_FALSE(gpu.IsRenderSize(width, height, &why));
    EXPECT_NE(why.find("24 x 16 to 72 x 48 was expected"), std::string::npos) << why;
  }
}

// Linear HDR is compared as codes of the same bound: values are far apart where they are large.
TEST_F(GpuSuperResolutionTest, LinearHdrAgrees) {
  SuperResolutionOptions options = TestOptions(48, 36, 96, 72);
  options.warp.filter = Filter::kLut;
  options.warp.table = &table_;
  options.history_format = PixelFormat::kRgba32F;
  options.encoding = ColorEncoding::kLinearHdr;
  SerialExecutor executor;
  SuperResolution cpu(options, executor);
  GpuSuperResolution gpu(device(), options);
  ImageBuffer expected = OutputOf(options), found = OutputOf(options);
  TestFrame frame(48, 36);
  for (int i = 0; i < 6; ++i) {
    frame.Randomise(static_cast<unsigned>(i), i == 4);
    for (int k = 0; k < 30; ++k) frame.SetColor(k, k % 36, 60000.0f, 20.0f, kInfinity);
    cpu.Process(frame.View(), expected.view());
    gpu.Process(frame.View(), found.view());
    for (ImageBuffer* image : {&expected, &found}) {
      for (int y = 0; y < 72; ++y) {
        float* row = image->view().Row<float>(y);
        for (int c = 0; c < 4 * 96; ++c) row[c] = HdrCode(row[c]);
      }
    }
    ExpectClose(found, expected, kGpuBound32, "HDR, frame " + std::to_string(i));
  }
}

TEST_F(GpuSuperResolutionTest, TakesColorOfEveryFormat) {
  SuperResolutionOptions options = TestOptions(20, 12, 40, 24);
  options.warp.filter = Filter::kCatmullRom;
  options.history_format = PixelFormat::kRgba32F;
  for (const PixelFormat format : kColorFormats) {
    SerialExecutor executor;
    SuperResolution cpu(options, executor);
    GpuSuperResolution gpu(device(), options);
    TestFrame frame(20, 12, format);
    ImageBuffer expected = OutputOf(options), found = OutputOf(options);
    for (int i = 0; i < 3; ++i) {
      frame.Randomise(static_cast<unsigned>(i));
      cpu.Process(frame.View(), expected.view());
      gpu.Process(frame.View(), found.view());
      ExpectClose(found, expected, kGpuBound32, Name(format));
    }
  }
}

// A renderer's own motion (UV, to the frame before, y up) and reversed depth buffer give what
// converted ones give.
TEST_F(GpuSuperResolutionTest, ConvertsMotionAndDepthInTheLoad) {
  SuperResolutionOptions options = TestOptions(48, 36, 96, 72);
  options.warp.filter = Filter::kLut;
  options.warp.table = &table_;
  options.history_format = PixelFormat::kRgba32F;
  InputConventions stored = InputConventions::DepthBuffer(0.1f, 100.0f, true);
  stored.motion_scale_x = -48;
  stored.motion_scale_y = 36;
  GpuSuperResolution converted(device(), options), raw(device(), options, stored);
  ImageBuffer expected = OutputOf(options), found = OutputOf(options);
  TestFrame frame(48, 36);
  for (int i = 0; i < 4; ++i) {
    frame.Randomise(static_cast<unsigned>(i));
    converted.Process(frame.View(), expected.view());
    const MotionView motion = frame.View().motion;
    for (int y = 0; y < 36; ++y) {
      for (int x = 0; x < 48; ++x) {
        frame.SetMotion(x, y, motion.Row(y)[2 * x] / -48, motion.Row(y)[2 * x + 1] / 36);
        const double z = static_cast<double>(frame.Depth(x, y)) * 100;
        frame.Depth(x, y) = static_cast<float>(0.1 * (100 - z) / (z * (100 - 0.1)));
      }
    }
    raw.Process(frame.View(), found.view());
    ExpectClose(found, expected, kGpuBound32, "frame " + std::to_string(i));
  }
}

TEST_F(GpuSuperResolutionTest, ResetForgets) {
  SuperResolutionOptions options = TestOptions(20, 12, 40, 24);
  options.warp.filter = Filter::kCatmullRom;
  GpuSuperResolution fresh(device(), options), used(device(), options);
  ImageBuffer expected = OutputOf(options), found = OutputOf(options);
  TestFrame frame(20, 12);
  frame.Randomise(1);
  used.Process(frame.View(), found.view());
  used.Reset();
  frame.Randomise(2);
  used.Process(frame.View(), found.view());
  fresh.Process(frame.View(), expected.view());
  EXPECT_TRUE(SameBits(found, expected));
}

TEST_F(GpuSuperResolutionTest, TimesEveryPass) {
  SuperResolutionOptions options = TestOptions(20, 12, 40, 24);
  options.warp.filter = Filter::kLut;
  options.warp.table = &table_;
  options.motion_filter = options.reactive = true;
  GpuSuperResolution gpu(device(), options);
  EXPECT_GT(gpu.MemoryBytes(), std::size_t{40 * 24 * 8 * 4});
  ImageBuffer out = OutputOf(options);
  TestFrame frame(20, 12);
  for (int i = 0; i < 2; ++i) gpu.Process(frame.View(), out.view());
  if (!device().has_times()) GTEST_SKIP() << device().name() << " has no timestamps";
  std::vector<std::string> names;
  for (const PassTime& time : gpu.Times()) {
    names.push_back(time.pass);
    EXPECT_GE(time.milliseconds, 0);
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"prefilter columns", "prefilter rows", "camera",
                                      "motion filter", "samples", "predict", "residual", "aliasing",
                                      "update", "depth range", "reactive reach"}));
}

TEST_F(GpuSuperResolutionTest, RefusesWhatItLacks) {
  const auto reason = [&](const Configure& configure) {
    SuperResolutionOptions options = TestOptions(20, 12, 40, 24);
    configure(options);
    std::string why;
    EXPECT_FALSE(GpuSuperResolution::IsRunnable(device(), options, &why));
    return why;
  };
  EXPECT_EQ(reason([](auto& o) { o.history_format = PixelFormat::kRgba8; }),
            "the history format is rgba8; the GPU takes rgba16f or rgba32f");
  EXPECT_EQ(
      reason([](auto& o) { o.peer = &kTaau; }),
      "the options name a peer; the GPU has the passes of super resolution and frame generation");
  EXPECT_NE(reason([](auto& o) { o.output_width = 1 << 15; }).find("takes sides of at most"),
            std::string::npos);
}

}  // namespace
}  // namespace warplut
