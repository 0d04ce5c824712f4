#include "tools/bench/sr_benchmark.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "datasets/error.h"
#include "luts/baked/warplut_x2.h"
#include "runtime/image_buffer.h"
#include "runtime/super_resolution.h"

namespace warplut {
namespace {

constexpr double kFlippedShare = 1e-3;

struct Size {
  int width, height;
};
constexpr Size kSizes[] = {{1280, 720}, {1920, 1080}};

// Waves behind a row of discs that are nearer.
class Scene {
 public:
  Scene(int width, int height, const std::string& motion)
      : color_(width, height, PixelFormat::kRgba8),
        depth_(width, height, PixelFormat::kR32F),
        motion_(width, height) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) FillPixel(x, y, motion == "uniform");
    }
  }

  RenderedFrame Frame(int index) const {
    constexpr float kJitter[4] = {-0.25f, 0.25f, 0.0f, -0.375f};
    return {
        color_.view(), depth_.view(), motion_.view(), kJitter[index % 4], kJitter[(index + 1) % 4],
        false};
  }

 private:
  void FillPixel(int x, int y, bool uniform) {
    const auto fx = static_cast<float>(x);
    const auto fy = static_cast<float>(y);
    for (int c = 0; c < 4; ++c) {
      const float wave = std::sin(0.31f * fx + 0.17f * fy + static_cast<float>(c)) +
                         std::sin(1.3f * fx - 0.9f * fy);
      color_.view().Row<std::uint8_t>(y)[4 * x + c] =
          static_cast<std::uint8_t>(127.5f + 55.0f * wave);
    }
    const float across = std::remainder(fx, 160.0f);
    const float down = std::remainder(fy, 160.0f);
    const bool disc = across * across + down * down < 900;
    depth_.view().Row<float>(y)[x] = disc ? 0.05f : 0.3f + 0.0005f * fy;
    float* m = motion_.view().Row(y) + 2 * x;
    m[0] = uniform ? 1.685f : 2.65f * std::sin(0.006f * fx + 0.004f * fy);
    m[1] = uniform ? -0.805f : 2.05f * std::cos(0.004f * fx - 0.008f * fy);
  }

  ImageBuffer color_, depth_;
  MotionBuffer motion_;
};

struct Variant {
  const char* name;
  void (*apply)(SuperResolutionOptions& options);
};
constexpr Variant kVariants[] = {
    {"default", [](SuperResolutionOptions&) {}},
    {"sample form", [](SuperResolutionOptions& o) { o.form = HistoryForm::kSample; }},
    {"no clamp", [](SuperResolutionOptions& o) { o.clamp = ColorClamp::kNone; }},
    {"no history", [](SuperResolutionOptions& o) { o.history = false; }},
};

// The share of pixels of which a channel differs by more than half a code value.
double FlippedShare(const ImageView& a, const ImageView& b) {
  std::int64_t flipped = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      float worst = 0;
      for (int c = 0; c < 3; ++c) {
        worst = std::max(worst, std::abs(a.Row<float>(y)[4 * x + c] - b.Row<float>(y)[4 * x + c]));
      }
      flipped += worst > 0.5f / 255.0f;
    }
  }
  return static_cast<double>(flipped) / (static_cast<double>(a.width) * a.height);
}

double CompareWithReference(const Scene& scene, SuperResolutionOptions options) {
  constexpr int kFrames = 3;
  SerialExecutor executor;
  ImageBuffer fast_out(options.output_width, options.output_height, PixelFormat::kRgba32F);
  ImageBuffer plain_out(options.output_width, options.output_height, PixelFormat::kRgba32F);
  SuperResolution fast(options, executor);
  options.reference = true;
  SuperResolution plain(options, executor);
  for (int frame = 0; frame < kFrames; ++frame) {
    fast.Process(scene.Frame(frame), fast_out.view());
    plain.Process(scene.Frame(frame), plain_out.view());
  }
  return FlippedShare(std::as_const(fast_out).view(), std::as_const(plain_out).view());
}

SrBenchmarkRow Measure(const Size& size, const std::string& motion, const Variant& variant,
                       const SrBenchmarkOptions& benchmark, const Table& table) {
  SuperResolutionOptions options;
  options.output_width = size.width;
  options.output_height = size.height;
  options.render_width = static_cast<int>(std::lround(size.width / benchmark.scale));
  options.render_height = static_cast<int>(std::lround(size.height / benchmark.scale));
  options.warp.filter = Filter::kLut;
  options.warp.table = &table;
  variant.apply(options);
  const Scene scene(options.render_width, options.render_height, motion);

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
  ImageBuffer out(size.width, size.height, PixelFormat::kRgba8);
  ImageBuffer history(size.width, size.height, PixelFormat::kRgba16F);
  ImageBuffer warped(size.width, size.height, PixelFormat::kRgba16F);
  row.memory = static_cast<double>(sr.MemoryBytes()) / static_cast<double>(history.bytes());
  sr.Process(scene.Frame(0), out.view());
  const MotionView hr_motion = sr.Geometry().motion;
  std::vector<double> process, warp, ratio;
  for (int i = 0; i <= benchmark.repeats; ++i) {
    const RenderedFrame frame = scene.Frame(i + 1);
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
  for (const Size& size : kSizes) {
    for (const std::string motion : {"smooth", "uniform"}) {
      for (const Variant& variant : kVariants) {
        rows.push_back(Measure(size, motion, variant, options, table));
      }
    }
  }
  return rows;
}

std::string FormatTable(const std::vector<SrBenchmarkRow>& rows) {
  std::string text =
      "Super resolution, one thread; ratio = frame / warp of an RGBA16F history alone\n" +
      fmt::format("{:<12} {:<8} {:<12} {:>9} {:>9} {:>26} {:>7} {:>8} {:>8}\n", "output", "motion",
                  "variant", "frame ms", "warp ms", "ratio median [min, max]", "target", "differ",
                  "memory");
  for (const SrBenchmarkRow& row : rows) {
    const std::string target =
        row.target > 0 ? fmt::format("{:.1f}{}", row.target, row.met() ? "" : "!") : "";
    text += fmt::format(
        "{:<12} {:<8} {:<12} {:>9.3f} {:>9.3f} {:>10.2f} [{:>5.2f}, {:>5.2f}] {:>7} {:>8.1e} "
        "{:>8.2f}\n",
        fmt::format("{} x {}", row.width, row.height), row.motion, row.variant, row.process.median,
        row.warp.median, row.ratio.median, row.ratio.min, row.ratio.max, target, row.flipped,
        row.memory);
  }
  return text +
         "differ: share of pixels that differ from the plain version by more than half a "
         "code value; memory: in RGBA16F images of the output.\n";
}

}  // namespace warplut
