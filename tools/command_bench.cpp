// warplut bench: what a warp costs here.
#include <algorithm>
#include <memory>

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

}  // namespace

void AddBenchCommand(CLI::App& app, CommandRun* run) {
  CLI::App* bench = app.add_subcommand("bench", "Measure run time on this machine");
  bench->require_subcommand(0, 1);
  const auto arguments = std::make_shared<BenchArguments>();
  WarpBenchmarkOptions& options = arguments->options;
  CLI::App* command = bench->add_subcommand(
      "warp",
      "Time the warp kernels against OpenCV's remap, on one thread; each result is checked first");
  command->add_option("--width", options.width, "Pixels")->capture_default_str();
  command->add_option("--height", options.height, "Pixels")->capture_default_str();
  command->add_option("--repeats", options.repeats, "Timed runs of each call")
      ->capture_default_str();
  std::vector<std::string> formats;
  for (const PixelFormat format : kPixelFormats) formats.emplace_back(Name(format));
  command
      ->add_option("--formats", arguments->formats,
                   "Pixel formats, separated by commas (default: all)")
      ->delimiter(',')
      ->check(CLI::IsMember(formats));
  AddJsonOption(*command, &arguments->json);
  command->callback([arguments, run] { *run = [arguments] { return RunBenchWarp(*arguments); }; });

  const auto ssim = std::make_shared<BenchSsimArguments>();
  command = bench->add_subcommand(
      "ssim", "Time the training's SSIM with gradient, on one thread; the result is checked first");
  command->add_option("--width", ssim->width, "Pixels")
      ->check(CLI::Range(64, 1 << 14))
      ->capture_default_str();
  command->add_option("--height", ssim->height, "Pixels")
      ->check(CLI::Range(64, 1 << 14))
      ->capture_default_str();
  command->add_option("--repeats", ssim->repeats, "Timed runs")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  AddJsonOption(*command, &ssim->json);
  command->callback([ssim, run] { *run = [ssim] { return RunBenchSsim(*ssim); }; });
}

}  // namespace warplut
