#include "tools/bench/pass_benchmark.h"

#include <fmt/format.h>

#include <cmath>

#include "datasets/error.h"
#include "tools/bench/bench_scene.h"

#ifdef WARPLUT_HAS_GPU
#include "luts/baked/warplut_iir_x2.h"
#include "runtime/gpu/gpu_frame_generation.h"
#include "runtime/gpu/gpu_super_resolution.h"
#endif

namespace warplut {
namespace {

#ifdef WARPLUT_HAS_GPU
// The times of passes of one mode, frame after frame.
class PassTimes {
 public:
  PassTimes(const char* mode, const GpuDevice& device) : mode_(mode), device_(device) {}

  void Add(const std::vector<PassTime>& times) {
    if (times.empty()) {
      throw Error(fmt::format("the device {} has no timestamps, by which passes are timed",
                              device_.name()));
    }
    double sum = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      ColumnOf(i, times[i].pass).push_back(times[i].milliseconds);
      sum += times[i].milliseconds;
    }
    all_.push_back(sum);
  }

  void AppendTo(std::vector<PassBenchmarkRow>* rows) const {
    for (std::size_t i = 0; i < passes_.size(); ++i)
      rows->push_back({mode_, passes_[i], Summarise(times_[i])});
    rows->push_back({mode_, "all", Summarise(all_)});
  }

 private:
  std::vector<double>& ColumnOf(std::size_t i, const std::string& pass) {
    if (i == passes_.size()) {
      passes_.push_back(pass);
      times_.emplace_back();
    }
    return times_[i];
  }

  const char* mode_;
  const GpuDevice& device_;
  std::vector<std::string> passes_;
  std::vector<std::vector<double>> times_;
  std::vector<double> all_;
};

constexpr PixelFormat kFormat = PixelFormat::kRgba16F;

void TimeSuperResolution(const GpuDevice& device, const PassBenchmarkOptions& benchmark,
                         const WarpOptions& warp, std::vector<PassBenchmarkRow>* rows) {
  SuperResolutionOptions options;
  options.output_width = benchmark.width;
  options.output_height = benchmark.height;
  options.render_width = static_cast<int>(std::lround(benchmark.width / benchmark.scale));
  options.render_height = static_cast<int>(std::lround(benchmark.height / benchmark.scale));
  options.warp = warp;
  std::string why;
  if (!options.IsValid(&why)) throw Error(why);
  if (!GpuSuperResolution::IsRunnable(device, options, &why)) throw Error(why);
  const BenchScene scene({.width = options.render_width,
                          .height = options.render_height,
                          .format = kFormat,
                          .output_scale = static_cast<float>(benchmark.scale)});
  GpuSuperResolution passes(device, options);
  ImageBuffer out(benchmark.width, benchmark.height, kFormat);
  PassTimes times("sr", device);
  // The first frame has no history, and memory is touched for the first time.
  for (int i = 0; i <= benchmark.repeats; ++i) {
    passes.Process(scene.Rendered(i), out.view());
    if (i > 0) times.Add(passes.Times());
  }
  times.AppendTo(rows);
}

void TimeGeneration(const GpuDevice& device, const PassBenchmarkOptions& benchmark,
                    const WarpOptions& warp, bool interpolates,
                    std::vector<PassBenchmarkRow>* rows) {
  FrameGenerationOptions options;
  options.width = benchmark.width;
  options.height = benchmark.height;
  options.warp = warp;
  std::string why;
  if (!GpuFrameGeneration::IsRunnable(device, options, &why)) throw Error(why);
  const BenchScene scene({.width = benchmark.width,
                          .height = benchmark.height,
                          .format = kFormat,
                          .discs_part = true});
  GpuFrameGeneration passes(device, options, kFormat);
  ImageBuffer out(benchmark.width, benchmark.height, kFormat);
  PassTimes times(interpolates ? "i" : "e", device);
  // Of two frames the later one is new.
  DisplayedFrame frame0 = scene.Displayed(), frame1 = scene.Displayed();
  for (int i = 0; i <= benchmark.repeats; ++i) {
    frame0.id = static_cast<std::uint64_t>(i) + 1;
    frame1.id = frame0.id + 1;
    if (interpolates) {
      passes.Interpolate(frame0, frame1, 0.5f, out.view());
    } else {
      passes.Extrapolate(frame0, frame1, 0.5f, out.view());
    }
    if (i > 0) times.Add(passes.Times());
  }
  times.AppendTo(rows);
}
#endif

}  // namespace

bool PassBenchmarkOptions::IsValid(std::string* why) const {
  constexpr int kMostPixels = 16384;
  std::string reason;
  if (width < 2 || height < 2 || width > kMostPixels || height > kMostPixels) {
    reason = fmt::format("the output is {} x {}; expected 2 to {} pixels in each axis", width,
                         height, kMostPixels);
  }
  if (!(scale >= 1 && scale <= 4)) reason = fmt::format("scale is {}; expected 1 to 4", scale);
  if (repeats < 1) reason = fmt::format("repeats is {}; expected at least 1", repeats);
  if (!reason.empty() && why != nullptr) *why = reason;
  return reason.empty();
}

PassBenchmark RunPassBenchmark([[maybe_unused]] const GpuDevice& device,
                               [[maybe_unused]] const PassBenchmarkOptions& options) {
#ifdef WARPLUT_HAS_GPU
  const Table table(baked::kWarplutIirX2);
  const WarpOptions warp = {.filter = Filter::kLut, .table = &table};
  PassBenchmark benchmark{.device = device.name(), .rows = {}};
  TimeSuperResolution(device, options, warp, &benchmark.rows);
  for (const bool interpolates : {true, false})
    TimeGeneration(device, options, warp, interpolates, &benchmark.rows);
  return benchmark;
#else
  throw Error("this build has no passes of a GPU; expected a build with Vulkan or OpenGL ES");
#endif
}

}  // namespace warplut
