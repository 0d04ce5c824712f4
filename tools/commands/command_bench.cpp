// warplut bench: run times on this machine.
#include <algorithm>
#include <memory>

#include "tools/bench/benchmark_tables.h"
#include "tools/commands/command.h"
#include "tools/device.h"

namespace warplut {
namespace {

template <class Row>
ExitCode CodeOf(const std::vector<Row>& rows) {
  const bool met = std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.met(); });
  return met ? ExitCode::kDone : ExitCode::kMissed;
}
ExitCode CodeOf(const WarpBenchmark& warp) { return CodeOf(warp.rows); }
ExitCode CodeOf(const SsimBenchmark& ssim) {
  return ssim.mpixels >= kSsimTargetMpixels ? ExitCode::kDone : ExitCode::kMissed;
}
ExitCode CodeOf(const PassBenchmark&) { return ExitCode::kDone; }

// A benchmark whose options `add` adds and `measure` takes.
template <class Options, class Add, class Measure>
void AddBenchmark(Command bench, CommandRun* run, const char* name, const char* purpose,
                  const Add& add, Measure measure) {
  const auto options = std::make_shared<Options>();
  const auto json = std::make_shared<bool>(false);
  Command command = bench.AddCommand(name, purpose);
  add(command, *options);
  AddJsonOption(command, json.get());
  command.OnParsed([options, json, measure, run] {
    *run = [options, json, measure] {
      const auto benchmark = measure(*options);
      if (*json) {
        PrintJson(ToJson(benchmark));
      } else {
        Print(ToText(benchmark));
      }
      return CodeOf(benchmark);
    };
  });
}

template <class Options>
void RequireValid(const Options& options) {
  std::string why;
  RequireUsage(options.IsValid(&why), why);
}

struct WarpArguments {
  WarpBenchmarkOptions options;
  std::vector<std::string> formats;
};

void AddWarp(Command bench, CommandRun* run) {
  AddBenchmark<WarpArguments>(
      bench, run, "warp",
      "Time the warp kernels against OpenCV's remap, on one thread; each result is checked first",
      [](Command command, WarpArguments& a) {
        command.Add("--width", a.options.width, "Width of the image in pixels").ShowDefault();
        command.Add("--height", a.options.height, "Height of the image in pixels").ShowDefault();
        command.Add("--repeats", a.options.repeats, "Number of timed runs of each call")
            .ShowDefault();
        std::vector<std::string> formats;
        for (const PixelFormat format : kPixelFormats) formats.emplace_back(Name(format));
        command
            .Add("--formats", a.formats,
                 "Pixel formats to time, separated by commas (default: all)")
            .Separated()
            .OneOf(formats);
      },
      [](WarpArguments a) {
        if (!a.formats.empty()) {
          std::erase_if(a.options.formats, [&](PixelFormat format) {
            return std::find(a.formats.begin(), a.formats.end(), Name(format)) == a.formats.end();
          });
        }
        RequireValid(a.options);
        return RunWarpBenchmark(a.options);
      });
}

struct SsimArguments {
  int width = 1920, height = 1080, repeats = 15;
};

void AddSsim(Command bench, CommandRun* run) {
  AddBenchmark<SsimArguments>(
      bench, run, "ssim",
      "Time the training's SSIM with gradient, on one thread; the result is checked first",
      [](Command command, SsimArguments& a) {
        const int largest = 1 << 14;
        command.Add("--width", a.width, "Width of the image in pixels")
            .Within(64, largest)
            .ShowDefault();
        command.Add("--height", a.height, "Height of the image in pixels")
            .Within(64, largest)
            .ShowDefault();
        command.Add("--repeats", a.repeats, "Number of timed runs").Within(1, 10000).ShowDefault();
      },
      [](const SsimArguments& a) { return RunSsimBenchmark(a.width, a.height, a.repeats); });
}

void AddGeneration(Command bench, CommandRun* run) {
  AddBenchmark<GenerationBenchmarkOptions>(
      bench, run, "generation",
      "Time frame generation against one warp, on one thread; each result is checked first",
      [](Command command, GenerationBenchmarkOptions& options) {
        command.Add("--repeats", options.repeats, "Number of timed frames in each row")
            .ShowDefault();
      },
      [](const GenerationBenchmarkOptions& options) {
        RequireValid(options);
        return RunGenerationBenchmark(options);
      });
}

void AddSr(Command bench, CommandRun* run) {
  AddBenchmark<SrBenchmarkOptions>(
      bench, run, "sr",
      "Time super resolution against the warp of its history, on one thread; each result is "
      "checked first",
      [](Command command, SrBenchmarkOptions& options) {
        command.Add("--scale", options.scale, "Upscale factor, output / render").ShowDefault();
        command.Add("--repeats", options.repeats, "Number of timed frames in each row")
            .ShowDefault();
      },
      [](const SrBenchmarkOptions& options) {
        RequireValid(options);
        return RunSrBenchmark(options);
      });
}

struct PassArguments {
  PassBenchmarkOptions options;
  std::string device = GpuDeviceNames().front();
};

void AddPasses(Command bench, CommandRun* run) {
  AddBenchmark<PassArguments>(
      bench, run, "passes", "Time each pass of super resolution and frame generation on a GPU",
      [](Command command, PassArguments& a) {
        command.Add("--device", a.device, "Device that runs the passes")
            .OneOf(GpuDeviceNames())
            .ShowDefault();
        command.Add("--width", a.options.width, "Width of the output in pixels").ShowDefault();
        command.Add("--height", a.options.height, "Height of the output in pixels").ShowDefault();
        command.Add("--scale", a.options.scale, "Upscale factor, output / render").ShowDefault();
        command.Add("--repeats", a.options.repeats, "Number of timed frames of each mode")
            .ShowDefault();
      },
      [](const PassArguments& a) {
        RequireValid(a.options);
        AsUsage([&] {
          CheckDevice(a.device);
          return true;
        });
        return RunPassBenchmark(*OpenGpu(a.device), a.options);
      });
}

}  // namespace

void AddBenchCommand(Command app, CommandRun* run) {
  Command bench = app.AddCommand("bench", "Measure run time on this machine");
  AddWarp(bench, run);
  AddSsim(bench, run);
  AddGeneration(bench, run);
  AddSr(bench, run);
  AddPasses(bench, run);
}

}  // namespace warplut
