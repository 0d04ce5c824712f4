// Super resolution on a GPU against the processor: every choice, odd sizes, broken input, cuts.
#include "runtime/gpu/gpu_super_resolution.h"

#include <gtest/gtest.h>

#include <functional>

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
            (std::vector<std::string>{"prefilter columns", "prefilter rows", "samples", "predict",
                                      "residual", "aliasing", "update", "depth range"}));
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
