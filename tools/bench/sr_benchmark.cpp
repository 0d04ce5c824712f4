#include "tools/bench/sr_benchmark.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "datasets/error.h"
#include "luts/baked/warplut_x2.h"
#include "runtime/method.h"
#include "tools/bench/bench_scene.h"

namespace warplut {
namespace {

constexpr float kSuperResolutionBound = 0.5f;  // code values
constexpr double kFlippedShare = 1e-3;

struct SuperResolutionVariant {
  const char* name;
  void (*apply)(SuperResolutionOptions& options);
  PixelFormat format = PixelFormat::kRgba8;  // of the colour and the output
};
constexpr SuperResolutionVariant kVariants[] = {
    {"default", [](SuperResolutionOptions&) {}},
    {"sample form", [](SuperResolutionOptions& o) { o.form = HistoryForm::kSample; }},
    {"no clamp", [](SuperResolutionOptions& o) { o.clamp = ColorClamp::kNone; }},
    {"no history", [](SuperResolutionOptions& o) { o.history = false; }},
    {"taau", [](SuperResolutionOptions& o) { FindMethod("taau")->configure_super_resolution(o); }},
    {"sgsr2",
     [](SuperResolutionOptions& o) { FindMethod("sgsr2")->configure_super_resolution(o); }},
    {"fsr2", [](SuperResolutionOptions& o) { FindMethod("fsr2")->configure_super_resolution(o); }},
    {"rgba16f", [](SuperResolutionOptions&) {}, PixelFormat::kRgba16F},
    {"linear HDR", [](SuperResolutionOptions& o) { o.encoding = ColorEncoding::kLinearHdr; },
     PixelFormat::kRgba16F},
};

double CompareWithReference(const BenchScene& scene, SuperResolutionOptions options) {
  constexpr int kFrames = 3;
  SerialExecutor executor;
  ImageBuffer fast_out(options.output_width, options.output_height, PixelFormat::kRgba32F);
  ImageBuffer plain_out(options.output_width, options.output_height, PixelFormat::kRgba32F);
  SuperResolution fast(options, executor);
  options.reference = true;
  SuperResolution plain(options, executor);
  for (int frame = 0; frame < kFrames; ++frame) {
    fast.Process(scene.Rendered(frame), fast_out.view());
    plain.Process(scene.Rendered(frame), plain_out.view());
  }
  return FlippedShare(std::as_const(fast_out).view(), std::as_const(plain_out).view(),
                      kSuperResolutionBound);
}

SrBenchmarkRow Measure(const BenchSize& size, const std::string& motion,
                       const SuperResolutionVariant& variant, const SrBenchmarkOptions& benchmark,
                       const Table& table) {
  SuperResolutionOptions options;
  options.output_width = size.width;
  options.output_height = size.height;
  options.render_width = static_cast<int>(std::lround(size.width / benchmark.scale));
  options.render_height = static_cast<int>(std::lround(size.height / benchmark.scale));
  options.warp.filter = Filter::kLut;
  options.warp.table = &table;
  variant.apply(options);
  const BenchScene scene({.width = options.render_width,
                          .height = options.render_height,
                          .format = variant.format,
                          .uniform = motion == "uniform",
                          .output_scale = static_cast<float>(benchmark.scale)});

  SrBenchmarkRow row;
  row.width = size.width;
  row.height = size.height;
  row.motion = motion;
  row.variant = variant.name;
  row.flipped = CompareWithReference(scene, options);
  if (row.flipped > kFlippedShare) {
    throw Error(fmt::format(
        "sr benchmark, {} x {} {} {}: {:.3g} of the pixels differ from the reference, at most "
        "{:.3g} expected.",
        size.width, size.height, motion, variant.name, row.flipped, kFlippedShare));
  }

  SerialExecutor executor;
  SuperResolution sr(options, executor);
  ImageBuffer out(size.width, size.height, variant.format);
  ImageBuffer history(size.width, size.height, PixelFormat::kRgba16F);
  ImageBuffer warped(size.width, size.height, PixelFormat::kRgba16F);
  row.memory = static_cast<double>(sr.MemoryBytes()) / static_cast<double>(history.bytes());
  sr.Process(scene.Rendered(0), out.view());
  const MotionView hr_motion = sr.Geometry().motion;
  std::vector<double> process, warp, ratio;
  for (int i = 0; i <= benchmark.repeats; ++i) {
    const RenderedFrame frame = scene.Rendered(i + 1);
    const double frame_time = Milliseconds([&] { sr.Process(frame, out.view()); });
    const double warp_time = Milliseconds(
        [&] { Warp(std::as_const(history).view(), hr_motion, options.warp, warped.view()); });
    if (i == 0) continue;  // memory is touched for the first time
    process.push_back(frame_time);
    warp.push_back(warp_time);
    ratio.push_back(frame_time / warp_time);
  }
  row.process = Summarise(process);
  row.warp = Summarise(warp);
  row.ratio = Summarise(ratio);
  const bool has_target = size.height == 1080 && motion == "smooth" && &variant == kVariants;
  if (has_target && benchmark.scale == 2) row.target = kSrTarget;
  return row;
}

}  // namespace

bool SrBenchmarkOptions::IsValid(std::string* why) const {
  const char* reason = nullptr;
  if (!(scale >= 1 && scale <= 4)) reason = "the scale is outside of [1, 4]";
  if (repeats < 1) reason = "repeats is less than 1";
  if (reason != nullptr && why != nullptr) *why = reason;
  return reason == nullptr;
}

std::vector<SrBenchmarkRow> RunSrBenchmark(const SrBenchmarkOptions& options) {
  std::string why;
  if (!options.IsValid(&why)) throw Error("sr benchmark: " + why);
  const Table table(baked::kWarplutX2);
  std::vector<SrBenchmarkRow> rows;
  for (const BenchSize& size : kBenchSizes) {
    for (const std::string motion : kBenchMotions) {
      for (const SuperResolutionVariant& variant : kVariants) {
        rows.push_back(Measure(size, motion, variant, options, table));
      }
    }
  }
  return rows;
}

}  // namespace warplut
