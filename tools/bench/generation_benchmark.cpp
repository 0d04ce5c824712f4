#include "tools/bench/generation_benchmark.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "datasets/error.h"
#include "luts/baked/warplut_x2.h"
#include "runtime/generation/row_kernels.h"
#include "tools/bench/bench_scene.h"

namespace warplut {
namespace {

using namespace generation;

// What the sources hold.
struct Content {
  const char* name;
  PixelFormat format;
  ColorEncoding encoding = ColorEncoding::kDisplay;
};
constexpr Content kContents[] = {
    {"rgba8", PixelFormat::kRgba8},
    {"rgba16f", PixelFormat::kRgba16F},
    {"HDR16f", PixelFormat::kRgba16F, ColorEncoding::kLinearHdr},
};

constexpr float kAlpha = 0.5f;
constexpr float kGenerationBound = 1;  // code values

void Generate(FrameGeneration& generation, const DisplayedFrame& frame, bool interpolates,
              const MutableImageView& out) {
  if (interpolates) {
    generation.Interpolate(frame, frame, kAlpha, out);
  } else {
    generation.Extrapolate(frame, frame, kAlpha, out);
  }
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
        from1_(options.width, options.height),
        disoccluded_(static_cast<std::size_t>(TileCount(options.width, kTileWidth))) {}

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
      kernels_.target_motion(job_, {forward, keys}, y, from0_.view(), from1_.view(),
                             disoccluded_.data());
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
  std::vector<std::uint8_t> disoccluded_;
};

GenerationBenchmarkRow Measure(const BenchSize& size, const Content& content,
                               const std::string& motion, bool interpolates, int repeats,
                               const Table& table) {
  FrameGenerationOptions options;
  options.width = size.width;
  options.height = size.height;
  options.warp.filter = Filter::kLut;
  options.warp.table = &table;
  options.encoding = content.encoding;
  const PixelFormat format = content.format;
  const BenchScene scene({.width = size.width,
                          .height = size.height,
                          .format = format,
                          .uniform = motion == "uniform",
                          .discs_part = true});
  const DisplayedFrame frame = scene.Displayed();

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
  row.content = content.name;
  row.motion = motion;
  row.interpolates = interpolates;
  row.flipped =
      FlippedShare(std::as_const(out).view(), std::as_const(other).view(), kGenerationBound);
  row.memory = static_cast<double>(generation.MemoryBytes()) / (8.0 * size.width * size.height);
  if (row.flipped > 0) {
    throw Error(fmt::format(
        "generation benchmark, {} x {} {} {}: {:.3g} of the pixels differ from the reference.",
        size.width, size.height, content.name, motion, row.flipped));
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
  if (size.height == 1080 && motion == "smooth" && interpolates &&
      content.encoding == ColorEncoding::kDisplay) {
    row.target = kGenerationTarget;
  }
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
  for (const BenchSize& size : kBenchSizes) {
    for (const Content& content : kContents) {
      for (const std::string motion : kBenchMotions) {
        for (const bool interpolates : {true, false}) {
          rows.push_back(Measure(size, content, motion, interpolates, options.repeats, table));
        }
      }
    }
  }
  return rows;
}

}  // namespace warplut
