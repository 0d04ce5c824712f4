#include "tools/bench/warp_benchmark.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "datasets/error.h"
#include "runtime/core/pixel.h"
#include "runtime/executor.h"
#include "runtime/image_buffer.h"
#include "runtime/motion_tiles.h"
#include "runtime/prefilter.h"
#include "tools/bench/warp_content.h"

namespace warplut {
namespace {

// Ratios that the project asks for, for RGBA8 and RGBA32F, without prefilter: nearest and bilinear
// lookup on smooth motion, uniform motion, static motion.
constexpr double kNearestTarget = 4;
constexpr double kBilinearTarget = 2.5;
constexpr double kUniformTarget = 8;
constexpr double kStaticTarget = 0.9;
// What subnormal texels cost: at most 1.1 of what ordinary ones do.
constexpr double kSubnormalTarget = 1 / 1.1;
constexpr float kSubnormal = 1e-40f;
// The prefilter takes at most 0.6 of a warp with bilinear lookup, for RGBA16F and RGBA32F.
constexpr double kPrefilterTarget = 1 / 0.6;

struct Difference {
  double worst = 0;
  bool exact = true;
};

// `codes` code values are one unit of the images.
Difference Compare(const ImageView& a, const ImageView& b, double codes) {
  Difference error;
  for (int y = 0; y < a.height; ++y) {
    for (int i = 0; i < a.width * Channels(a.format); ++i) {
      const double difference =
          LoadChannel(a.format, a.At(0, y), i) - LoadChannel(b.format, b.At(0, y), i);
      error.worst = std::max(error.worst, codes * std::abs(difference));
    }
  }
  error.exact = error.worst == 0;
  return error;
}

struct Competitor {
  std::string name;
  std::function<void()> call;
  double target;
};

// Times `warp` and each competitor in turn, so that a change of clock or load meets all of them.
std::vector<WarpBenchmarkRow> Race(const WarpBenchmarkRow& row, int repeats,
                                   const std::function<void()>& warp,
                                   const std::vector<Competitor>& competitors) {
  std::vector<WarpBenchmarkRow> rows;
  std::vector<double> own;
  std::vector<std::vector<double>> others(competitors.size());
  for (int repeat = -1; repeat < repeats; ++repeat) {  // the first run warms up
    const double time = Milliseconds(warp);
    if (repeat >= 0) own.push_back(time);
    for (std::size_t i = 0; i < competitors.size(); ++i) {
      const double other = Milliseconds(competitors[i].call);
      if (repeat >= 0) others[i].push_back(other);
    }
  }
  for (std::size_t i = 0; i < competitors.size(); ++i) {
    std::vector<double> ratios(own.size());
    for (std::size_t r = 0; r < own.size(); ++r) ratios[r] = others[i][r] / own[r];
    WarpBenchmarkRow result = row;
    result.competitor = competitors[i].name;
    result.warp = Summarise(own);
    result.other = Summarise(others[i]);
    result.ratio = Summarise(ratios);
    result.target = competitors[i].target;
    rows.push_back(std::move(result));
  }
  return rows;
}

int MatType(PixelFormat format) {
  return format == PixelFormat::kRgba8  ? CV_8UC4
         : format == PixelFormat::kR32F ? CV_32FC1
                                        : CV_32FC4;
}

struct WarpVariant {
  std::string name;
  WarpOptions options = {};
  double smooth_target = 0;
  double uniform_target = 0;
};

bool HasWarpTarget(PixelFormat format) {
  return format == PixelFormat::kRgba8 || format == PixelFormat::kRgba32F;
}

bool HasPrefilterTarget(PixelFormat format) {
  return format == PixelFormat::kRgba16F || format == PixelFormat::kRgba32F;
}

// The first two are the lookups in a table of 16 taps.
std::vector<WarpVariant> MakeVariants(const std::vector<Table>& tables) {
  std::vector<WarpVariant> variants;
  for (const Table& table : tables) {
    const bool wide = table.footprint() != Footprint::k16;
    const std::string name =
        wide ? "lut " + std::to_string(TapCount(table.footprint())) : std::string("lut");
    for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear}) {
      WarpVariant& variant = variants.emplace_back();
      variant.name = name + " " + Name(lookup);
      variant.options = {.filter = Filter::kLut, .table = &table, .lookup = lookup};
      // The targets are those of 16 taps.
      const double target = lookup == Lookup::kNearest ? kNearestTarget : kBilinearTarget;
      variant.smooth_target = wide ? 0 : target;
      variant.uniform_target = wide ? 0 : kUniformTarget;
    }
  }
  variants.push_back({.name = Info(Filter::kCatmullRom).name, .uniform_target = kUniformTarget});
  variants.push_back({.name = Info(Filter::kSpline).name,
                      .options = {.filter = Filter::kSpline},
                      .uniform_target = kUniformTarget});
  return variants;
}

// The images of one format and what is measured on them.
class FormatBenchmark {
 public:
  FormatBenchmark(const WarpBenchmarkOptions& options, PixelFormat format)
      : repeats_(options.repeats),
        history_(options.width, options.height, format),
        out_(options.width, options.height, format),
        reference_(options.width, options.height, format),
        coefficients_(options.width, options.height, CoefficientFormat(format)),
        remapped_(options.width, options.height,
                  format == PixelFormat::kRgba16F ? PixelFormat::kRgba32F : format),
        source_(options.height, options.width, MatType(format), remapped_.view.data) {
    FillWarpImage(history_);
    FillWarpImage(remapped_);
  }

  // One filter, against remap.
  void AgainstRemap(const std::string& kind, const WarpMotion& motion, const WarpVariant& variant,
                    std::vector<WarpBenchmarkRow>& rows) {
    const cv::Mat map = RemapMap(motion);
    cv::Mat fixed, fraction;
    cv::convertMaps(map, cv::noArray(), fixed, fraction, CV_16SC2);
    const auto remap = [&](const cv::Mat& map1, const cv::Mat& map2) {
      cv::remap(source_, destination_, map1, map2, cv::INTER_CUBIC, cv::BORDER_REPLICATE);
    };
    const Prefilter prefilter = PrefilterOf(variant.options);
    double target = kind == "uniform" ? variant.uniform_target : variant.smooth_target;
    if (!HasWarpTarget(history_.view.format) || HasPrefilter(prefilter)) target = 0;
    const std::vector<Competitor> competitors = {
        {"remap, float maps", [&] { remap(map, cv::Mat()); }, target},
        {"remap, fixed maps", [&] { remap(fixed, fraction); }, 0}};
    if (!HasPrefilter(prefilter)) {
      MeasureWarp(
          kind, variant.name, motion, variant.options,
          [&] { Warp(history_.Const(), motion.view, variant.options, out_.view); }, competitors,
          rows);
      return;
    }
    Pass(prefilter).Apply(history_.Const(), executor_, coefficients_);
    const PrefilteredImage history = {history_.Const(), coefficients_};
    WarpReference(history, motion.view, variant.options, reference_.view);
    Measure(
        {kind, variant.name}, [&] { Warp(history, motion.view, variant.options, out_.view); },
        {out_.Const(), reference_.Const()}, competitors, rows);
  }

  // The prefilter of the options, against a warp of the same image.
  void PrefilterAgainstWarp(const std::string& kind, const WarpMotion& motion,
                            const WarpVariant& prefiltered, const WarpVariant& warped,
                            std::vector<WarpBenchmarkRow>& rows) {
    const Prefilter prefilter = PrefilterOf(prefiltered.options);
    const PixelFormat format = history_.view.format;
    ImageBuffer reference(history_.view.width, history_.view.height, CoefficientFormat(format));
    PrefilterPass::Reference(prefilter, history_.Const(), reference);
    PrefilterPass pass = Pass(prefilter);
    const auto warp = [&] { Warp(history_.Const(), motion.view, warped.options, out_.view); };
    Measure(
        {kind, prefiltered.name + " prefilter"},
        [&] { pass.Apply(history_.Const(), executor_, coefficients_); }, {coefficients_, reference},
        {{"warp, " + warped.name, warp, HasPrefilterTarget(format) ? kPrefilterTarget : 0}}, rows);
  }

  // Subnormal texels against ordinary ones, in a float format.
  void SubnormalAgainstOrdinary(const std::string& kind, const WarpMotion& motion,
                                const std::vector<WarpVariant>& variants,
                                std::vector<WarpBenchmarkRow>& rows) {
    const int width = history_.view.width, height = history_.view.height;
    const PixelFormat format = history_.view.format;
    WarpImage subnormal(width, height, format);
    for (int y = 0; y < height; ++y) {
      for (int i = 0; i < width * Channels(format); ++i) {
        const float texel = LoadChannel(format, history_.view.At(0, y), i);
        StoreChannel(format, kSubnormal * texel, subnormal.view.At(0, y), i);
      }
    }
    for (const WarpVariant& variant : variants) {
      const Prefilter prefilter = PrefilterOf(variant.options);
      const auto race = [&](const std::function<void(const WarpImage&)>& call,
                            const ImageView& result) {
        Measure(
            {kind, variant.name + " 1e-40"}, [&] { call(subnormal); }, {result, reference_.Const()},
            {{"ordinary texels", [&] { call(history_); }, kSubnormalTarget}}, rows);
      };
      if (HasPrefilter(prefilter)) {
        PrefilterPass pass = Pass(prefilter);
        PrefilterPass::Reference(prefilter, subnormal.Const(), reference_.view);
        race([&](const WarpImage& image) { pass.Apply(image.Const(), executor_, coefficients_); },
             coefficients_);
      } else {
        WarpReference(subnormal.Const(), motion.view, variant.options, reference_.view);
        race(
            [&](const WarpImage& image) {
              Warp(image.Const(), motion.view, variant.options, out_.view);
            },
            out_.Const());
      }
    }
  }

  // Motion of whole pixels, against memcpy; with the motion classified by the call, which has to
  // read it, and before.
  void AgainstCopy(const std::string& kind, const WarpMotion& motion,
                   std::vector<WarpBenchmarkRow>& rows) {
    const WarpOptions options;
    const MotionTiles tiles(motion.view);
    const bool is_target = kind == "static" && HasWarpTarget(history_.view.format);
    const auto copy = [&] {
      std::memcpy(out_.view.data, history_.view.data, history_.bytes.size());
    };
    const auto copy_and_read = [&] {
      copy();
      motion_bits_ = BitsOf(motion);
    };
    MeasureWarp(
        kind, "any", motion, options,
        [&] { Warp(history_.Const(), motion.view, options, out_.view); },
        {{"memcpy", copy, 0}, {"memcpy, read motion", copy_and_read, 0}}, rows);
    MeasureWarp(
        kind, "tiles given", motion, options,
        [&] { Warp(history_.Const(), motion.view, tiles, options, out_.view); },
        {{"memcpy", copy, is_target ? kStaticTarget : 0}}, rows);
  }

 private:
  // Reads all of the motion, and does as little with it as can be.
  static std::uint32_t BitsOf(const WarpMotion& motion) {
    std::uint32_t bits = 0;
    for (const float value : motion.xy) bits |= std::bit_cast<std::uint32_t>(value);
    return bits;
  }

  static cv::Mat RemapMap(const WarpMotion& motion) {
    cv::Mat map(motion.view.height, motion.view.width, CV_32FC2);
    for (int y = 0; y < map.rows; ++y) {
      for (int x = 0; x < map.cols; ++x) {
        const float* m = motion.view.Row(y) + 2 * x;
        map.at<cv::Vec2f>(y, x) = {static_cast<float>(x) - m[0], static_cast<float>(y) - m[1]};
      }
    }
    return map;
  }

  PrefilterPass Pass(const Prefilter& prefilter) const {
    return {prefilter, history_.view.width, history_.view.height, executor_.Threads()};
  }

  void MeasureWarp(const std::string& kind, const std::string& name, const WarpMotion& motion,
                   const WarpOptions& options, const std::function<void()>& warp,
                   const std::vector<Competitor>& competitors,
                   std::vector<WarpBenchmarkRow>& rows) {
    WarpReference(history_.Const(), motion.view, options, reference_.view);
    Measure({kind, name}, warp, {out_.Const(), reference_.Const()}, competitors, rows);
  }

  struct Subject {
    std::string motion, filter;
  };
  struct Results {
    ImageView fast, reference;
  };

  // Checks what `call` writes against the reference, then races it.
  void Measure(const Subject& subject, const std::function<void()>& call, const Results& results,
               const std::vector<Competitor>& competitors, std::vector<WarpBenchmarkRow>& rows) {
    call();
    WarpBenchmarkRow row;
    row.format = history_.view.format;
    const Difference difference =
        Compare(results.fast, results.reference, 255.0 / ChannelScale(row.format));
    row.motion = subject.motion;
    row.filter = subject.filter;
    row.worst_error = difference.worst;
    row.exact = difference.exact;
    if (!(difference.worst <= kWarpRgba8Bound)) {
      throw Error("warp benchmark, " + std::string(Name(row.format)) + " " + row.motion + " " +
                  row.filter + ": differs from the reference by " +
                  std::to_string(difference.worst) + " code values, at most " +
                  std::to_string(kWarpRgba8Bound) + " expected");
    }
    for (WarpBenchmarkRow& result : Race(row, repeats_, call, competitors))
      rows.push_back(std::move(result));
  }

  int repeats_;
  WarpImage history_;
  WarpImage out_;
  WarpImage reference_;
  ImageBuffer coefficients_;
  WarpImage remapped_;
  cv::Mat source_;
  cv::Mat destination_;
  SerialExecutor executor_;
  volatile std::uint32_t motion_bits_ = 0;  // so that the reading is done
};

}  // namespace

bool WarpBenchmarkOptions::IsValid(std::string* why) const {
  const char* reason = nullptr;
  if (width < 4 || height < 4 || width > 16384 || height > 16384)
    reason = "the size is outside of [4, 16384]";
  if (repeats < 1) reason = "repeats is less than 1";
  if (formats.empty()) reason = "no pixel format is given";
  if (reason != nullptr && why != nullptr) *why = reason;
  return reason == nullptr;
}

WarpBenchmark RunWarpBenchmark(const WarpBenchmarkOptions& options) {
  std::string why;
  if (!options.IsValid(&why)) throw Error("warp benchmark: " + why);
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  std::vector<Table> tables;
  for (const Footprint footprint : kFootprints) {
    const std::vector<std::int16_t> weights = MakeWarpTable(footprint);
    tables.emplace_back(
        TableView{.format = TableFormat::kI16, .data = weights.data(), .footprint = footprint});
  }
  const std::vector<WarpVariant> variants = MakeVariants(tables);
  const WarpVariant& bilinear = variants[1];
  WarpBenchmark benchmark;
  benchmark.target = WarpTarget();
  benchmark.opencv = cv::getVersionString();
  WarpMotion motion(options.width, options.height);
  for (const PixelFormat format : options.formats) {
    FormatBenchmark images(options, format);
    for (const std::string kind : {"smooth", "uniform"}) {
      FillWarpMotion(kind, motion);
      for (const WarpVariant& variant : variants)
        images.AgainstRemap(kind, motion, variant, benchmark.rows);
      for (const WarpVariant& variant : variants) {
        if (kind != "smooth" || !HasPrefilter(PrefilterOf(variant.options))) continue;
        images.PrefilterAgainstWarp(kind, motion, variant, bilinear, benchmark.rows);
      }
      if (format == PixelFormat::kRgba32F) {
        images.SubnormalAgainstOrdinary(kind, motion, variants, benchmark.rows);
      }
    }
    for (const std::string kind : {"whole", "static"}) {
      FillWarpMotion(kind, motion);
      images.AgainstCopy(kind, motion, benchmark.rows);
    }
  }
  cv::setNumThreads(threads);
  return benchmark;
}

}  // namespace warplut
