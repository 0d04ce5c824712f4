#include "tools/bench/generation_benchmark.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "datasets/error.h"
#include "luts/baked/warplut_x2.h"
#include "runtime/generation/row_kernels.h"
#include "runtime/image_buffer.h"
#include "runtime/pixel.h"

namespace warplut {
namespace {

using namespace generation;

constexpr float kAlpha = 0.5f;

struct Size {
  int width, height;
};
constexpr Size kSizes[] = {{1280, 720}, {1920, 1080}};

// Waves behind a grid of discs that are nearer and move the other way.
class Scene {
 public:
  Scene(int width, int height, PixelFormat format, bool uniform)
      : color_(width, height, format),
        depth_(width, height, PixelFormat::kR32F),
        motion_(width, height) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) FillPixel(x, y, uniform);
    }
  }

  DisplayedFrame Frame() const { return {color_.view(), depth_.view(), motion_.view(), false}; }

 private:
  void FillPixel(int x, int y, bool uniform) {
    const auto fx = static_cast<float>(x);
    const auto fy = static_cast<float>(y);
    const MutableImageView color = color_.view();
    const float scale = ChannelScale(color.format);
    for (int c = 0; c < 4; ++c) {
      const float wave = std::sin(0.31f * fx + 0.17f * fy + static_cast<float>(c)) +
                         std::sin(1.3f * fx - 0.9f * fy);
      StoreChannel(color.format, scale * (0.5f + 0.2f * wave), color.At(x, y), c);
    }
    const float across = std::remainder(fx, 160.0f);
    const float down = std::remainder(fy, 160.0f);
    const bool disc = across * across + down * down < 900;
    depth_.view().Row<float>(y)[x] = disc ? 0.05f : 0.3f + 0.0005f * fy;
    const float side = disc && !uniform ? -1.0f : 1.0f;
    float* m = motion_.view().Row(y) + 2 * x;
    m[0] = side * (uniform ? 3.37f : 5.3f * std::sin(0.003f * fx + 0.002f * fy));
    m[1] = side * (uniform ? -1.61f : 4.1f * std::cos(0.002f * fx - 0.004f * fy));
  }

  ImageBuffer color_, depth_;
  MotionBuffer motion_;
};

void Generate(FrameGeneration& generation, const DisplayedFrame& frame, bool interpolates,
              const MutableImageView& out) {
  if (interpolates) {
    generation.Interpolate(frame, frame, kAlpha, out);
  } else {
    generation.Extrapolate(frame, frame, kAlpha, out);
  }
}

// The share of pixels of which a channel differs by more than a code value.
double FlippedShare(const ImageView& a, const ImageView& b) {
  const float bound = a.format == PixelFormat::kRgba8 ? 1.0f : 1.0f / 255.0f;
  std::int64_t flipped = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      float worst = 0;
      for (int c = 0; c < 4; ++c) {
        worst = std::max(worst, std::abs(LoadChannel(a.format, a.At(x, y), c) -
                                         LoadChannel(b.format, b.At(x, y), c)));
      }
      flipped += worst > bound;
    }
  }
  return static_cast<double>(flipped) / (static_cast<double>(a.width) * a.height);
}

// The passes but the warps, one after the other over the whole frame.
class Passes {
 public:
  Passes(const FrameGenerationOptions& options, const DisplayedFrame& frame, bool interpolates)
      : options_(options),
        job_{options_,    interpolates, kAlpha,       true,
             frame.depth, frame.depth,  frame.motion, frame.motion},
        color_(frame.color),
        forward_(static_cast<std::size_t>(2 * options.width) * options.height),
        keys_(static_cast<std::size_t>(options.width) * options.height),
        from0_(options.width, options.height),
        from1_(options.width, options.height) {}

  void Time(const MutableImageView& out, std::vector<double> (&times)[4]) {
    const int height = options_.height;
    const KeyView keys{keys_.data(), options_.width};
    const MutableMotionView forward{forward_.data(), options_.width, height,
                                    std::ptrdiff_t{8} * options_.width};
    const auto rows = [&](const auto& row) {
      return Milliseconds([&] {
        for (int y = 0; y < height; ++y) row(y);
      });
    };
    times[0].push_back(rows([&](int y) { kernels_.forward(job_, y, forward); }));
    std::fill(keys_.begin(), keys_.end(), kNoSplat);
    times[1].push_back(rows([&](int y) { kernels_.splat(job_, forward, y, {0, height}, keys); }));
    times[2].push_back(rows([&](int y) {
      kernels_.target_motion(job_, {forward, keys}, y, from0_.view(), from1_.view());
    }));
    const WarpedFrames warped{color_, color_, from0_.view(), from1_.view()};
    times[3].push_back(rows([&](int y) { kernels_.blend(job_, warped, y, out); }));
  }

 private:
  FrameGenerationOptions options_;
  GenerationJob job_;
  ImageView color_;
  RowKernels kernels_ = FastRowKernels();
  std::vector<float> forward_;
  std::vector<SplatKey> keys_;
  MotionBuffer from0_, from1_;
};

GenerationBenchmarkRow Measure(const Size& size, PixelFormat format, const std::string& motion,
                               bool interpolates, int repeats, const Table& table) {
  FrameGenerationOptions options;
  options.width = size.width;
  options.height = size.height;
  options.warp.filter = Filter::kLut;
  options.warp.table = &table;
  const Scene scene(size.width, size.height, format, motion == "uniform");
  const DisplayedFrame frame = scene.Frame();

  SerialExecutor executor;
  ImageBuffer out(size.width, size.height, format), other(size.width, size.height, format);
  FrameGeneration generation(options, executor);
  Generate(generation, frame, interpolates, out.view());
  {
    FrameGenerationOptions plain = options;
    plain.reference = true;
    FrameGeneration reference(plain, executor);
    Generate(reference, frame, interpolates, other.view());
  }
  GenerationBenchmarkRow row;
  row.width = size.width;
  row.height = size.height;
  row.format = format;
  row.motion = motion;
  row.interpolates = interpolates;
  row.flipped = FlippedShare(std::as_const(out).view(), std::as_const(other).view());
  row.memory = static_cast<double>(generation.MemoryBytes()) / (8.0 * size.width * size.height);
  if (row.flipped > 0) {
    throw Error(fmt::format(
        "generation benchmark, {} x {} {} {}: {:.3g} of the pixels differ from the reference.",
        size.width, size.height, Name(format), motion, row.flipped));
  }

  Passes passes(options, frame, interpolates);
  std::vector<double> frames, warps, ratios, times[4];
  for (int i = 0; i <= repeats; ++i) {
    const double frame_time =
        Milliseconds([&] { Generate(generation, frame, interpolates, out.view()); });
    const double warp_time =
        Milliseconds([&] { Warp(frame.color, frame.motion, options.warp, other.view()); });
    if (i == 0) continue;  // memory is touched for the first time
    passes.Time(other.view(), times);
    frames.push_back(frame_time);
    warps.push_back(warp_time);
    ratios.push_back(frame_time / warp_time);
  }
  row.frame = Summarise(frames);
  row.warp = Summarise(warps);
  row.ratio = Summarise(ratios);
  row.forward = Summarise(times[0]);
  row.splat = Summarise(times[1]);
  row.target_motion = Summarise(times[2]);
  row.blend = Summarise(times[3]);
  if (size.height == 1080 && motion == "smooth" && interpolates) row.target = kGenerationTarget;
  return row;
}

}  // namespace

bool GenerationBenchmarkOptions::IsValid(std::string* why) const {
  if (repeats >= 1) return true;
  if (why != nullptr) *why = "repeats is less than 1";
  return false;
}

std::vector<GenerationBenchmarkRow> RunGenerationBenchmark(
    const GenerationBenchmarkOptions& options) {
  std::string why;
  if (!options.IsValid(&why)) throw Error("generation benchmark: " + why);
  const Table table(baked::kWarplutX2);
  std::vector<GenerationBenchmarkRow> rows;
  for (const Size& size : kSizes) {
    for (const PixelFormat format : {PixelFormat::kRgba8, PixelFormat::kRgba16F}) {
      for (const std::string motion : {"smooth", "uniform"}) {
        for (const bool interpolates : {true, false}) {
          rows.push_back(Measure(size, format, motion, interpolates, options.repeats, table));
        }
      }
    }
  }
  return rows;
}

std::string FormatTable(const std::vector<GenerationBenchmarkRow>& rows) {
  std::string text =
      "Frame generation, one thread; milliseconds; ratio = frame / one warp of a source\n" +
      fmt::format(
          "{:<12} {:<8} {:<8} {:<12} {:>7} {:>7} {:>20} {:>7} {:>8} {:>6} {:>7} {:>6} {:>7}\n",
          "size", "format", "motion", "frame at", "frame", "warp", "ratio [min, max]", "target",
          "forward", "splat", "motion", "blend", "memory");
  for (const GenerationBenchmarkRow& row : rows) {
    const std::string target =
        row.target > 0 ? fmt::format("{:.1f}{}", row.target, row.met() ? "" : "!") : "";
    text += fmt::format(
        "{:<12} {:<8} {:<8} {:<12} {:>7.2f} {:>7.2f} {:>6.2f} [{:>4.2f}, {:>5.2f}] {:>7} {:>8.2f} "
        "{:>6.2f} {:>7.2f} {:>6.2f} {:>7.2f}\n",
        fmt::format("{} x {}", row.width, row.height), Name(row.format), row.motion,
        row.interpolates ? "alpha" : "1 + alpha", row.frame.median, row.warp.median,
        row.ratio.median, row.ratio.min, row.ratio.max, target, row.forward.median,
        row.splat.median, row.target_motion.median, row.blend.median, row.memory);
  }
  return text + "memory: in RGBA16F images.\n";
}

}  // namespace warplut
