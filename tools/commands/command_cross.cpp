// warplut cross: LUTs in the loop of super resolution, at upscale factors that they were trained
// for and at others.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "luts/bake/table_io.h"
#include "luts/filters.h"
#include "tools/commands/command.h"
#include "tools/judge/images/image_set.h"
#include "tools/judge/images/sr_cross_report.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/thread_limit.h"
#include "train/fit/rivals/keys_search.h"
#include "train/fit/trainer.h"

namespace warplut {
namespace {

struct CrossArguments {
  std::vector<std::string> images;
  std::vector<std::string> luts;
  std::vector<double> scales = {1.3, 1.5, 1.7, 2, 3, 4};
  TrainOptions options;  // but for the scale
  bool markdown = false;
  bool json = false;
};

std::vector<CrossFilter> LoadFilters(const std::vector<std::string>& luts) {
  std::vector<CrossFilter> filters = {{"catmull-rom", KeysCanonicalWeights(kCatmullRomA)}};
  for (const std::string& path : luts) {
    const LoadedTable loaded = LoadTable(path);
    filters.push_back({loaded.name, TableResampler(loaded.table)});
  }
  return filters;
}

ExitCode RunCross(CrossArguments arguments) {
  TrainOptions& options = arguments.options;
  options.objective = TrainObjective::kSr;
  for (const double scale : arguments.scales) {
    options.scale = scale;
    std::string why;
    RequireUsage(options.IsValid(&why), why);
  }
  const ThreadLimit limit(options.threads);
  const std::vector<CrossFilter> filters = LoadFilters(arguments.luts);
  int tone_mapped = 0;
  const std::vector<Image> luma =
      CheckedLuma(LoadImages({arguments.images.begin(), arguments.images.end()}, &tone_mapped));
  std::vector<CrossColumn> columns;
  {
    Progress progress("judging", static_cast<double>(arguments.scales.size()), "factors");
    for (const double scale : arguments.scales) {
      ThrowIfInterrupted("cross", "nothing was printed");
      options.scale = scale;
      columns.push_back(JudgeAtScale(filters, luma, options));
      progress.Add(1);
    }
  }
  if (arguments.json) {
    Json json = ToJson(filters, columns);
    json["tone_mapped"] = tone_mapped;
    PrintJson(json);
    return ExitCode::kDone;
  }
  if (!arguments.markdown) Print(ToneMappedText(tone_mapped, luma.size()));
  const auto print = [&](const TextTable& table) {
    Print(arguments.markdown ? ToMarkdown(table) : ToText(table));
  };
  print(LossTable(filters, columns));
  for (const CrossColumn& column : columns) {
    Print("\n");
    print(SsimTable(filters, column));
  }
  return ExitCode::kDone;
}

}  // namespace

void AddCrossCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<CrossArguments>();
  CrossArguments& a = *arguments;
  Command command = app.AddCommand(
      "cross", "Judge tables in the loop of super resolution, across upscale factors");
  command.Add("--images", a.images, "Images, folders of images, or sequences (their references)")
      .Required();
  command
      .Add("--luts", a.luts,
           "Tables to judge: fits, baked tables (.json), or .exr in the released layout")
      .Required();
  command.Add("--scales", a.scales, "Upscale factors to judge at, in [1, 4]")
      .Separated()
      .ShowDefault();
  command.Add("--blend-a", a.options.blend_a,
              "Share of a sample on the pixel centre (default: that of the pipeline)");
  command.Add("--blend-b", a.options.blend_b,
              "Decrease of that share with the distance (default: that of the pipeline)");
  command.Add("--pan-share", a.options.pan_share,
              "Share of pans in the loss, in [0, 1) (default: that of the trainer)");
  command.Add("--crops", a.options.crops,
              "Number of crops to judge by (default: that of the trainer)");
  command.Add("--seed", a.options.seed, "Seed of crops and trajectories").ShowDefault();
  command.Add("--threads", a.options.threads, "Number of threads (default: all cores)");
  command.AddFlag("--markdown", a.markdown, "Print Markdown tables");
  AddJsonOption(command, &a.json);
  command.OnParsed([arguments, run] { *run = [arguments] { return RunCross(*arguments); }; });
}

}  // namespace warplut
