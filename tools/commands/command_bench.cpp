// warplut bench: run times on this machine.
#include <algorithm>
#include <memory>

#include "tools/bench/benchmark_tables.h"
#include "tools/commands/command.h"
#include "tools/device.h"

namespace warplut {
namespace {

struct BenchArguments {
  WarpBenchmarkOptions options;
  std::vector<std::string> formats;
  bool json = false;
};

template <class Benchmark>
void PrintBenchmark(const Benchmark& benchmark, bool json) {
  if (json) {
    PrintJson(ToJson(benchmark));
  } else {
    Print(ToText(benchmark));
  }
}

template <class Row>
ExitCode AllMet(const std::vector<Row>& rows) {
  const bool met = std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.met(); });
  return met ? ExitCode::kDone : ExitCode::kMissed;
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
  PrintBenchmark(benchmark, arguments.json);
  return AllMet(benchmark.rows);
}

struct BenchSsimArguments {
  int width = 1920;
  int height = 1080;
  int repeats = 15;
  bool json = false;
};

ExitCode RunBenchSsim(const BenchSsimArguments& arguments) {
  const SsimBenchmark b = RunSsimBenchmark(arguments.width, arguments.height, arguments.repeats);
  PrintBenchmark(b, arguments.json);
  return b.mpixels >= kSsimTargetMpixels ? ExitCode::kDone : ExitCode::kMissed;
}

ExitCode RunBenchSr(const SrBenchmarkOptions& options, bool json) {
  std::string why;
  RequireUsage(options.IsValid(&why), why);
  const std::vector<SrBenchmarkRow> rows = RunSrBenchmark(options);
  PrintBenchmark(rows, json);
  return AllMet(rows);
}

ExitCode RunBenchGeneration(const GenerationBenchmarkOptions& options, bool json) {
  std::string why;
  RequireUsage(options.IsValid(&why), why);
  const std::vector<GenerationBenchmarkRow> rows = RunGenerationBenchmark(options);
  PrintBenchmark(rows, json);
  return AllMet(rows);
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

ExitCode RunBenchPasses(const std::string& device, const PassBenchmarkOptions& options, bool json) {
  std::string why;
  RequireUsage(options.IsValid(&why), why);
  AsUsage([&] {
    CheckDevice(device);
    return true;
  });
  PrintBenchmark(RunPassBenchmark(*OpenGpu(device), options), json);
  return ExitCode::kDone;
}

void AddBenchPasses(Command bench, CommandRun* run) {
  const auto options = std::make_shared<PassBenchmarkOptions>();
  const auto json = std::make_shared<bool>(false);
  const auto device = std::make_shared<std::string>(GpuDeviceNames().front());
  Command command = bench.AddCommand(
      "passes", "Time each pass of super resolution and frame generation on a GPU");
  command.Add("--device", *device, "Device that runs the passes")
      .OneOf(GpuDeviceNames())
      .ShowDefault();
  command.Add("--width", options->width, "Width of the output in pixels").ShowDefault();
  command.Add("--height", options->height, "Height of the output in pixels").ShowDefault();
  command.Add("--scale", options->scale, "Upscale factor, output / render").ShowDefault();
  command.Add("--repeats", options->repeats, "Number of timed frames of each mode").ShowDefault();
  AddJsonOption(command, json.get());
  command.OnParsed([options, json, device, run] {
    *run = [options, json, device] { return RunBenchPasses(*device, *options, *json); };
  });
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
  AddBenchPasses(bench, run);
}

}  // namespace warplut
