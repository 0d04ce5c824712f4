// warplut bench: run times on this machine.
#include <algorithm>
#include <memory>

#include "tools/bench/generation_benchmark.h"
#include "tools/bench/sr_benchmark.h"
#include "tools/bench/ssim_benchmark.h"
#include "tools/bench/warp_benchmark.h"
#include "tools/command.h"

namespace warplut {
namespace {

struct BenchArguments {
  WarpBenchmarkOptions options;
  std::vector<std::string> formats;
  bool json = false;
};

Json ToJson(const Timing& timing) {
  return {{"min", timing.min}, {"median", timing.median}, {"max", timing.max}};
}

Json ToJson(const WarpBenchmark& benchmark) {
  Json rows = Json::array();
  for (const WarpBenchmarkRow& row : benchmark.rows) {
    rows.push_back({{"format", Name(row.format)},
                    {"motion", row.motion},
                    {"filter", row.filter},
                    {"competitor", row.competitor},
                    {"warp_ms", ToJson(row.warp)},
                    {"competitor_ms", ToJson(row.other)},
                    {"ratio", ToJson(row.ratio)},
                    {"target", row.target},
                    {"met", row.met()},
                    {"worst_error_codes", row.worst_error}});
  }
  return {{"target", benchmark.target}, {"opencv", benchmark.opencv}, {"rows", rows}};
}

ExitCode RunBenchWarp(BenchArguments arguments) {
  WarpBenchmarkOptions& options = arguments.options;
  if (!arguments.formats.empty()) {
    options.formats.clear();
    for (const PixelFormat format : kPixelFormats) {
      if (std::find(arguments.formats.begin(), arguments.formats.end(), Name(format)) !=
          arguments.formats.end()) {
        options.formats.push_back(format);
      }
    }
  }
  std::string why;
  RequireUsage(options.IsValid(&why), why);
  const WarpBenchmark benchmark = RunWarpBenchmark(options);
  if (arguments.json) {
    PrintJson(ToJson(benchmark));
  } else {
    Print(FormatTable(benchmark));
  }
  const bool met = std::all_of(benchmark.rows.begin(), benchmark.rows.end(),
                               [](const WarpBenchmarkRow& row) { return row.met(); });
  return met ? ExitCode::kDone : ExitCode::kMissed;
}

struct BenchSsimArguments {
  int width = 1920;
  int height = 1080;
  int repeats = 15;
  bool json = false;
};

ExitCode RunBenchSsim(const BenchSsimArguments& arguments) {
  const SsimBenchmark b = RunSsimBenchmark(arguments.width, arguments.height, arguments.repeats);
  if (arguments.json) {
    PrintJson({{"mpixels", b.mpixels},
               {"prepared_mpixels", b.prepared_mpixels},
               {"opencv_ratio", b.opencv_ratio},
               {"error", b.error}});
  } else {
    Print(FormatTable(b));
  }
  return b.mpixels >= kSsimTargetMpixels ? ExitCode::kDone : ExitCode::kMissed;
}

ExitCode RunBenchSr(const SrBenchmarkOptions& options, bool json) {
  std::string why;
  RequireUsage(options.IsValid(&why), why);
  const std::vector<SrBenchmarkRow> rows = RunSrBenchmark(options);
  if (json) {
    Json list = Json::array();
    for (const SrBenchmarkRow& row : rows) {
      list.push_back({{"output", {row.width, row.height}},
                      {"motion", row.motion},
                      {"variant", row.variant},
                      {"frame_ms", ToJson(row.process)},
                      {"warp_ms", ToJson(row.warp)},
                      {"ratio", ToJson(row.ratio)},
                      {"target", row.target},
                      {"met", row.met()},
                      {"differing_share", row.flipped},
                      {"memory_images", row.memory}});
    }
    PrintJson({{"rows", list}});
  } else {
    Print(FormatTable(rows));
  }
  const bool met =
      std::all_of(rows.begin(), rows.end(), [](const SrBenchmarkRow& row) { return row.met(); });
  return met ? ExitCode::kDone : ExitCode::kMissed;
}

ExitCode RunBenchGeneration(const GenerationBenchmarkOptions& options, bool json) {
  std::string why;
  RequireUsage(options.IsValid(&why), why);
  const std::vector<GenerationBenchmarkRow> rows = RunGenerationBenchmark(options);
  if (json) {
    Json list = Json::array();
    for (const GenerationBenchmarkRow& row : rows) {
      list.push_back({{"size", {row.width, row.height}},
                      {"format", row.content},
                      {"motion", row.motion},
                      {"interpolates", row.interpolates},
                      {"frame_ms", ToJson(row.frame)},
                      {"warp_ms", ToJson(row.warp)},
                      {"ratio", ToJson(row.ratio)},
                      {"forward_ms", ToJson(row.forward)},
                      {"splat_ms", ToJson(row.splat)},
                      {"target_motion_ms", ToJson(row.target_motion)},
                      {"blend_ms", ToJson(row.blend)},
                      {"target", row.target},
                      {"met", row.met()},
                      {"memory_images", row.memory}});
    }
    PrintJson({{"rows", list}});
  } else {
    Print(FormatTable(rows));
  }
  const bool met = std::all_of(rows.begin(), rows.end(),
                               [](const GenerationBenchmarkRow& row) { return row.met(); });
  return met ? ExitCode::kDone : ExitCode::kMissed;
}

void AddBenchGeneration(Command bench, CommandRun* run) {
  const auto options = std::make_shared<GenerationBenchmarkOptions>();
  const auto json = std::make_shared<bool>(false);
  Command command = bench.AddCommand(
      "generation",
      "Time frame generation against one warp, on one thread; each result is checked first");
  command.Add("--repeats", options->repeats, "Number of timed frames in each row").ShowDefault();
  AddJsonOption(command, json.get());
  command.OnParsed([options, json, run] {
    *run = [options, json] { return RunBenchGeneration(*options, *json); };
  });
}

void AddBenchSr(Command bench, CommandRun* run) {
  const auto options = std::make_shared<SrBenchmarkOptions>();
  const auto json = std::make_shared<bool>(false);
  Command command = bench.AddCommand(
      "sr",
      "Time super resolution against the warp of its history, on one thread; each result is "
      "checked first");
  command.Add("--scale", options->scale, "Upscale factor, output / render").ShowDefault();
  command.Add("--repeats", options->repeats, "Number of timed frames in each row").ShowDefault();
  AddJsonOption(command, json.get());
  command.OnParsed(
      [options, json, run] { *run = [options, json] { return RunBenchSr(*options, *json); }; });
}

}  // namespace

void AddBenchCommand(Command app, CommandRun* run) {
  Command bench = app.AddCommand("bench", "Measure run time on this machine");
  const auto arguments = std::make_shared<BenchArguments>();
  WarpBenchmarkOptions& options = arguments->options;
  Command command = bench.AddCommand(
      "warp",
      "Time the warp kernels against OpenCV's remap, on one thread; each result is checked first");
  command.Add("--width", options.width, "Width of the image in pixels").ShowDefault();
  command.Add("--height", options.height, "Height of the image in pixels").ShowDefault();
  command.Add("--repeats", options.repeats, "Number of timed runs of each call").ShowDefault();
  std::vector<std::string> formats;
  for (const PixelFormat format : kPixelFormats) formats.emplace_back(Name(format));
  command
      .Add("--formats", arguments->formats,
           "Pixel formats to time, separated by commas (default: all)")
      .Separated()
      .OneOf(formats);
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, run] { *run = [arguments] { return RunBenchWarp(*arguments); }; });

  const auto ssim = std::make_shared<BenchSsimArguments>();
  command = bench.AddCommand(
      "ssim", "Time the training's SSIM with gradient, on one thread; the result is checked first");
  command.Add("--width", ssim->width, "Width of the image in pixels")
      .Within(64, 1 << 14)
      .ShowDefault();
  command.Add("--height", ssim->height, "Height of the image in pixels")
      .Within(64, 1 << 14)
      .ShowDefault();
  command.Add("--repeats", ssim->repeats, "Number of timed runs").Within(1, 10000).ShowDefault();
  AddJsonOption(command, &ssim->json);
  command.OnParsed([ssim, run] { *run = [ssim] { return RunBenchSsim(*ssim); }; });
  AddBenchGeneration(bench, run);
  AddBenchSr(bench, run);
}

}  // namespace warplut
