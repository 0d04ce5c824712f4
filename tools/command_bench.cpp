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

void AddBenchGeneration(CLI::App& bench, CommandRun* run) {
  const auto options = std::make_shared<GenerationBenchmarkOptions>();
  const auto json = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand(
      "generation",
      "Time frame generation against one warp, on one thread; each result is checked first");
  command->add_option("--repeats", options->repeats, "Number of timed frames in each row")
      ->capture_default_str();
  AddJsonOption(*command, json.get());
  command->callback([options, json, run] {
    *run = [options, json] { return RunBenchGeneration(*options, *json); };
  });
}

void AddBenchSr(CLI::App& bench, CommandRun* run) {
  const auto options = std::make_shared<SrBenchmarkOptions>();
  const auto json = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand(
      "sr",
      "Time super resolution against the warp of its history, on one thread; each result is "
      "checked first");
  command->add_option("--scale", options->scale, "Upscale factor, output / render")
      ->capture_default_str();
  command->add_option("--repeats", options->repeats, "Number of timed frames in each row")
      ->capture_default_str();
  AddJsonOption(*command, json.get());
  command->callback(
      [options, json, run] { *run = [options, json] { return RunBenchSr(*options, *json); }; });
}

}  // namespace

void AddBenchCommand(CLI::App& app, CommandRun* run) {
  CLI::App* bench = app.add_subcommand("bench", "Measure run time on this machine");
  bench->require_subcommand(0, 1);
  const auto arguments = std::make_shared<BenchArguments>();
  WarpBenchmarkOptions& options = arguments->options;
  CLI::App* command = bench->add_subcommand(
      "warp",
      "Time the warp kernels against OpenCV's remap, on one thread; each result is checked first");
  command->add_option("--width", options.width, "Width of the image in pixels")
      ->capture_default_str();
  command->add_option("--height", options.height, "Height of the image in pixels")
      ->capture_default_str();
  command->add_option("--repeats", options.repeats, "Number of timed runs of each call")
      ->capture_default_str();
  std::vector<std::string> formats;
  for (const PixelFormat format : kPixelFormats) formats.emplace_back(Name(format));
  command
      ->add_option("--formats", arguments->formats,
                   "Pixel formats to time, separated by commas (default: all)")
      ->delimiter(',')
      ->check(CLI::IsMember(formats));
  AddJsonOption(*command, &arguments->json);
  command->callback([arguments, run] { *run = [arguments] { return RunBenchWarp(*arguments); }; });

  const auto ssim = std::make_shared<BenchSsimArguments>();
  command = bench->add_subcommand(
      "ssim", "Time the training's SSIM with gradient, on one thread; the result is checked first");
  command->add_option("--width", ssim->width, "Width of the image in pixels")
      ->check(CLI::Range(64, 1 << 14))
      ->capture_default_str();
  command->add_option("--height", ssim->height, "Height of the image in pixels")
      ->check(CLI::Range(64, 1 << 14))
      ->capture_default_str();
  command->add_option("--repeats", ssim->repeats, "Number of timed runs")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  AddJsonOption(*command, &ssim->json);
  command->callback([ssim, run] { *run = [ssim] { return RunBenchSsim(*ssim); }; });
  AddBenchGeneration(*bench, run);
  AddBenchSr(*bench, run);
}

}  // namespace warplut
