// Frame generation on a GPU against the processor: every choice, odd sizes, broken input, cuts.
#include "runtime/gpu/gpu_frame_generation.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "luts/baked/warplut_iir_x2.h"
#include "luts/baked/warplut_t24_x2.h"
#include "luts/baked/warplut_x2.h"
#include "tests/runtime/generation/camera_travel.h"
#include "tests/runtime/gpu/gpu_fixture.h"

namespace warplut {
namespace {

using GeneratedTestFrame = generation::TestFrame;

const Table& IirTable() {
  static const Table table(baked::kWarplutIirX2);
  return table;
}
const Table& PlainTable() {
  static const Table table(baked::kWarplutX2);
  return table;
}
const Table& WideTable() {
  static const Table table(baked::kWarplutT24X2);
  return table;
}

// One way to generate frames. Lavapipe compiles the passes of each for a second.
struct Case {
  const char* name;
  std::function<void(FrameGenerationOptions&)> configure = [](auto&) {};
  int width = 80, height = 60;
  PixelFormat format = PixelFormat::kRgba32F;
  // Numbers that are none, and colours up to `largest`: what a prefilter leaves out is relative to
  // the largest sample.
  bool broken = false;
  float largest = std::numeric_limits<float>::infinity();
  bool cut0 = false, cut1 = false;
};

template <class Value>
Case With(const char* name, Value FrameGenerationOptions::*option, Value value) {
  return {.name = name, .configure = [=](auto& options) { options.*option = value; }};
}
Case Warped(const char* name, const WarpOptions& warp) {
  return With(name, &FrameGenerationOptions::warp, warp);
}
Case Sized(const char* name, int width, int height) {
  return {.name = name, .width = width, .height = height};
}

std::vector<Case> Cases() {
  using Options = FrameGenerationOptions;
  std::vector<Case> cases = {
      {.name = "Default"},
      {.name = "DefaultInHalves", .format = PixelFormat::kRgba16F},
      With("LinearMotion", &Options::motion_model, MotionModel::kLinear),
      With("QuadraticMotion", &Options::motion_model, MotionModel::kQuadratic),
      With("FillBackground", &Options::fill, DisocclusionFill::kBackground),
      With("FillNone", &Options::fill, DisocclusionFill::kNone),
      With("NoRefinement", &Options::refine, false),
      With("NoSplatting", &Options::splat, false),
      With("BrightnessGate", &Options::brightness_gate, true),
      With("FilteredMotion", &Options::motion_filter, true),
      With("NoDepth", &Options::depth, DepthMeasure::kNone),
      With("AbsoluteDepth", &Options::depth, DepthMeasure::kAbsolute),
      {.name = "WideGates",
       .configure =
           [](auto& options) {
             options.gate_width = 0.5f;
             options.brightness_gate = true;
           }},
      Warped("Bilinear", {.filter = Filter::kBilinear}),
      Warped("CatmullRom", {.filter = Filter::kCatmullRom}),
      Warped("Keys", {.filter = Filter::kKeys}),
      Warped("Spline", {.filter = Filter::kSpline}),
      Warped("PlainTable", {.filter = Filter::kLut, .table = &PlainTable()}),
      Warped("NearestLookup",
             {.filter = Filter::kLut, .table = &PlainTable(), .lookup = Lookup::kNearest}),
      Warped("WideTable", {.filter = Filter::kLut, .table = &WideTable()}),
      Sized("OnePixel", 1, 1),
      Sized("ThreeByFive", 3, 5),
      Sized("OneColumn", 1, 40),
      Sized("OneRow", 40, 1),
      Sized("OddSize", 161, 91),
      {.name = "Broken", .broken = true, .largest = 4},
      {.name = "BrokenInHalves", .format = PixelFormat::kRgba16F, .broken = true, .largest = 4},
      {.name = "BrokenWithoutPrefilter",
       .configure = [](auto& options) { options.warp.table = &PlainTable(); },
       .broken = true},
      {.name = "BrokenWithoutSplatting",
       .configure = [](auto& options) { options.splat = false; },
       .broken = true,
       .largest = 4},
      {.name = "BrokenWithQuadraticMotion",
       .configure = [](auto& options) { options.motion_model = MotionModel::kQuadratic; },
       .broken = true,
       .largest = 4},
      {.name = "CutBefore", .cut0 = true},
      {.name = "Cut", .cut1 = true},
  };
  for (const bool half : {false, true}) {
    Case hdr = With(half ? "HdrInHalves" : "Hdr", &Options::encoding, ColorEncoding::kLinearHdr);
    hdr.format = half ? PixelFormat::kRgba16F : PixelFormat::kRgba32F;
    hdr.broken = true;
    cases.push_back(hdr);
  }
  return cases;
}

class GpuFrameGenerationTest : public GpuTest {
 protected:
  static FrameGenerationOptions OptionsOf(const GeneratedTestFrame& frame) {
    FrameGenerationOptions options = generation::OptionsFor(frame);
    options.motion_model = FrameGenerationOptions{}.motion_model;
    options.warp = {.filter = Filter::kLut, .table = &IirTable()};
    return options;
  }
};
class GpuFrameGenerationCase : public GpuFrameGenerationTest,
                               public testing::WithParamInterface<Case> {
 protected:
  static GeneratedTestFrame Frame(unsigned seed) {
    const Case& c = GetParam();
    GeneratedTestFrame frame = generation::RandomFrame(c.width, c.height, c.format, seed, c.broken);
    for (int y = 0; y < c.height; ++y) {
      for (int x = 0; x < 3 * c.width; ++x) {
        const float value = frame.color.Get(x / 3, y, x % 3);
        if (std::isfinite(value) && value > c.largest) frame.color.Set(x / 3, y, x % 3, c.largest);
      }
    }
    return frame;
  }

  // Linear HDR is compared as codes: values are far apart where they are large.
  static const ImageBuffer& Displayed(ImageBuffer& image, ColorEncoding encoding) {
    if (encoding == ColorEncoding::kDisplay) return image;
    const MutableImageView view = image.view();
    for (int y = 0; y < view.height; ++y) {
      float* row = view.Row<float>(y);
      for (int c = 0; c < 4 * view.width; ++c) row[c] = HdrCode(row[c]);
    }
    return image;
  }
};
INSTANTIATE_TEST_SUITE_P(Choices, GpuFrameGenerationCase, testing::ValuesIn(Cases()),
                         [](const auto& test) { return test.param.name; });

// Random frames through both, interpolated and extrapolated.
TEST_P(GpuFrameGenerationCase, Agrees) {
  const Case& c = GetParam();
  const GeneratedTestFrame frame0 = Frame(1), frame1 = Frame(2);
  FrameGenerationOptions options = OptionsOf(frame0);
  c.configure(options);
  std::string why;
  ASSERT_TRUE(options.IsValid(&why)) << why;
  ASSERT_TRUE(GpuFrameGeneration::IsRunnable(device(), options, &why)) << why;
  SerialExecutor executor;
  FrameGeneration cpu(options, executor);
  GpuFrameGeneration gpu(device(), options, c.format);
  const DisplayedFrame before = frame0.view(c.cut0), now = frame1.view(c.cut1);
  ImageBuffer expected(c.width, c.height, PixelFormat::kRgba32F);
  ImageBuffer found(c.width, c.height, PixelFormat::kRgba32F);
  const GpuBound& bound = c.format == PixelFormat::kRgba32F ? kGpuBound32 : kGpuBound16;
  for (const float alpha : {0.5f, 0.3f}) {
    cpu.Interpolate(before, now, alpha, expected.view());
    gpu.Interpolate(before, now, alpha, found.view());
    ExpectClose(Displayed(found, options.encoding), Displayed(expected, options.encoding), bound,
                "interpolated at " + std::to_string(alpha));
    cpu.Extrapolate(before, now, alpha, expected.view());
    gpu.Extrapolate(before, now, alpha, found.view());
    ExpectClose(Displayed(found, options.encoding), Displayed(expected, options.encoding), bound,
                "extrapolated by " + std::to_string(alpha));
  }
}

class GpuFrameGenerationFormat : public GpuFrameGenerationTest,
                                 public testing::WithParamInterface<PixelFormat> {};
INSTANTIATE_TEST_SUITE_P(Formats, GpuFrameGenerationFormat,
                         testing::Values(PixelFormat::kRgba32F, PixelFormat::kRgba16F),
                         [](const auto& test) { return std::string(Name(test.param)); });

// A camera that travels over a ground: depth bends the paths, and ground leaves the image.
TEST_P(GpuFrameGenerationFormat, FollowsACamera) {
  const PixelFormat format = GetParam();
  GeneratedTestFrame frame0 = generation::Travel{}.Frame(0, format);
  GeneratedTestFrame frame1 = generation::Travel{}.Frame(1, format);
  const int width = frame0.color.width(), height = frame0.color.height();
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int i = 0; i < 3 * width * height; ++i) {
    frame0.color.Set(i / 3 % width, i / 3 / width, i % 3, uniform(random));
    frame1.color.Set(i / 3 % width, i / 3 / width, i % 3, uniform(random));
  }
  FrameGenerationOptions options = OptionsOf(frame0);
  ASSERT_EQ(options.motion_model, MotionModel::kPerspective);
  SerialExecutor executor;
  FrameGeneration cpu(options, executor);
  GpuFrameGeneration gpu(device(), options, format);
  options.motion_model = MotionModel::kQuadratic;
  FrameGeneration quadratic(options, executor);
  ImageBuffer expected(width, height, PixelFormat::kRgba32F);
  ImageBuffer found(width, height, PixelFormat::kRgba32F);
  ImageBuffer other(width, height, PixelFormat::kRgba32F);
  const GpuBound& bound = format == PixelFormat::kRgba32F ? kGpuBound32 : kGpuBound16;
  const auto generate = [&](auto& passes, bool interpolates, ImageBuffer& out) {
    if (interpolates) {
      passes.Interpolate(frame0.view(), frame1.view(), 0.5f, out.view());
    } else {
      passes.Extrapolate(frame0.view(), frame1.view(), 0.5f, out.view());
    }
  };
  for (const bool interpolates : {true, false}) {
    generate(cpu, interpolates, expected);
    generate(gpu, interpolates, found);
    generate(quadratic, interpolates, other);
    ExpectClose(found, expected, bound, interpolates ? "interpolated" : "extrapolated");
    // The frames tell the models apart.
    EXPECT_GT(Difference(other, expected, bound.worst).mean, 10 * bound.mean);
  }
}

// Frames with an id are uploaded once, in whatever order they come.
TEST_F(GpuFrameGenerationTest, FramesAreFoundById) {
  std::vector<GeneratedTestFrame> frames;
  for (unsigned i = 0; i < 3; ++i)
    frames.push_back(generation::RandomFrame(32, 24, PixelFormat::kRgba32F, i, false));
  const FrameGenerationOptions options = OptionsOf(frames[0]);
  GpuFrameGeneration fresh(device(), options, PixelFormat::kRgba32F);
  GpuFrameGeneration reused(device(), options, PixelFormat::kRgba32F);
  ImageBuffer expected(32, 24, PixelFormat::kRgba32F), found(32, 24, PixelFormat::kRgba32F);
  const std::size_t order[][2] = {{0, 1}, {0, 1}, {1, 2}, {2, 0}, {1, 0}};
  for (const auto& [before, now] : order) {
    DisplayedFrame frame0 = frames[before].view(), frame1 = frames[now].view();
    fresh.Interpolate(frame0, frame1, 0.5f, expected.view());
    frame0.id = before + 1;
    frame1.id = now + 1;
    reused.Interpolate(frame0, frame1, 0.5f, found.view());
    EXPECT_TRUE(SameBits(found, expected)) << before << " to " << now;
  }
  // An extrapolation needs no colour of frame 0; an interpolation behind it does.
  GpuFrameGeneration both(device(), options, PixelFormat::kRgba32F);
  DisplayedFrame frame0 = frames[0].view(), frame1 = frames[1].view();
  frame0.id = 1;
  frame1.id = 2;
  const ImageView color = frame0.color;
  frame0.color = {};
  both.Extrapolate(frame0, frame1, 0.5f, found.view());
  frame0.color = color;
  both.Interpolate(frame0, frame1, 0.5f, found.view());
  fresh.Interpolate(frames[0].view(), frames[1].view(), 0.5f, expected.view());
  EXPECT_TRUE(SameBits(found, expected));
}

TEST_F(GpuFrameGenerationTest, TimesEveryPass) {
  const GeneratedTestFrame frame0 =
      generation::RandomFrame(20, 12, PixelFormat::kRgba32F, 1, false);
  const GeneratedTestFrame frame1 =
      generation::RandomFrame(20, 12, PixelFormat::kRgba32F, 2, false);
  FrameGenerationOptions options = OptionsOf(frame0);
  options.encoding = ColorEncoding::kLinearHdr;
  options.motion_filter = true;
  GpuFrameGeneration gpu(device(), options, PixelFormat::kRgba16F);
  EXPECT_GT(gpu.MemoryBytes(), std::size_t{20 * 12 * 8 * 6});
  ImageBuffer out(20, 12, PixelFormat::kRgba8);
  gpu.Extrapolate(frame0.view(), frame1.view(), 0.5f, out.view());
  if (!device().has_times()) GTEST_SKIP() << device().name() << " has no timestamps";
  std::vector<std::string> names;
  for (const PassTime& time : gpu.Times()) {
    names.push_back(time.pass);
    EXPECT_GE(time.milliseconds, 0);
  }
  const std::vector<std::string> of_frame = {"camera", "motion filter", "encode",
                                             "prefilter columns", "prefilter rows"};
  std::vector<std::string> expected;
  for (int i = 0; i < 2; ++i) expected.insert(expected.end(), of_frame.begin(), of_frame.end());
  expected.insert(expected.end(), {"splat depth", "splat source", "extrapolate"});
  EXPECT_EQ(names, expected);
}

TEST_F(GpuFrameGenerationTest, RefusesWhatItLacks) {
  FrameGenerationOptions options;
  options.width = options.height = 8;
  std::string why;
  options.motion_model = static_cast<MotionModel>(99);
  EXPECT_FALSE(GpuFrameGeneration::IsRunnable(device(), options, &why));
  EXPECT_EQ(why, "the motion model is 99; the GPU has linear, quadratic and perspective");
  options.motion_model = MotionModel::kLinear;
  options.width = 1 << 15;
  EXPECT_FALSE(GpuFrameGeneration::IsRunnable(device(), options, &why));
  EXPECT_NE(why.find("takes sides of at most"), std::string::npos) << why;
}

}  // namespace
}  // namespace warplut
