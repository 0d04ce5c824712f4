// warplut dense: temporally dense rendering beside its rivals, as an eye integrates them.
#include <algorithm>
#include <cctype>
#include <memory>

#include "tools/commands/command.h"
#include "tools/dense/dense_job.h"
#include "tools/dense/dense_sweep.h"
#include "tools/tables/table_text.h"
#include "tools/thread_limit.h"

namespace warplut {
namespace {

struct DenseArguments {
  std::vector<std::string> scenes;
  bool sweep = false;
  SweepSettings sweep_settings;  // its `dense` is for scenes too
  int threads = 0;
  std::string pictures;
  bool markdown = false;
  bool json = false;
};

void PrintTable(const DenseArguments& arguments, const TextTable& table) {
  Print(arguments.markdown ? ToMarkdown(table) : ToText(table));
}

ExitCode RunSweep(const DenseArguments& arguments) {
  const SweepSettings& settings = arguments.sweep_settings;
  const DenseParameters& parameters = settings.dense.dense.parameters;
  const std::vector<SweepCell> cells = MeasureSweep(settings);
  const std::vector<RuleScore> rules = ScoreRules(cells, parameters, settings.whole);
  if (arguments.json) {
    PrintJson({{"sweep", ToJson(cells, rules)}});
    return ExitCode::kDone;
  }
  PrintTable(arguments, SweepTable(cells, parameters, settings.whole));
  Print("\n");
  PrintTable(arguments, RuleTable(rules));
  return ExitCode::kDone;
}

ExitCode RunScenes(const DenseArguments& arguments) {
  const std::vector<DenseReport> reports =
      JudgeScenes(arguments.scenes, arguments.sweep_settings.dense, arguments.pictures);
  Json json = Json::array();
  for (const DenseReport& report : reports) {
    if (arguments.json) {
      json.push_back(ToJson(report));
    } else {
      PrintTable(arguments, DenseTable(report));
      if (&report != &reports.back()) Print("\n");
    }
  }
  if (arguments.json) PrintJson({{"scenes", json}});
  return ExitCode::kDone;
}

ExitCode RunDense(const DenseArguments& arguments) {
  std::string why;
  RequireUsage(arguments.sweep != !arguments.scenes.empty(),
               "dense takes scenes or --sweep, one of them.");
  RequireUsage(arguments.sweep_settings.IsValid(&why), why);
  const ThreadLimit limit(arguments.threads);
  return arguments.sweep ? RunSweep(arguments) : RunScenes(arguments);
}

}  // namespace

void AddDenseCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<DenseArguments>();
  DenseArguments& a = *arguments;
  DenseSettings& settings = a.sweep_settings.dense;
  Command command = app.AddCommand(
      "dense", "Judge temporally dense rendering at 240 Hz against 60 Hz, as an eye sees them");
  command.Add("scenes", a.scenes, "Built-in scenes, or training, held-out or all");
  command.AddFlag("--sweep", a.sweep,
                  "Judge both orders on a pattern in motion, by direction and speed");
  command.Add("--width", settings.world.width, "Width of the displayed frame, even").ShowDefault();
  command.Add("--height", settings.world.height, "Height of the displayed frame, even")
      .ShowDefault();
  command.Add("--samples", settings.world.samples, "Samples per pixel of the ideal frames")
      .ShowDefault();
  command.Add("--warm-up", settings.warm_up, "Subframes before those that are judged")
      .ShowDefault();
  command.Add("--frames", settings.judged, "Number of judged subframes, a multiple of 4")
      .ShowDefault();
  command.Add("--speed", settings.world.speed, "Speed of the scenes' clock").ShowDefault();
  command.Add("--seed", settings.world.seed, "Seed of the scenes").ShowDefault();
  command.Add("--angles", a.sweep_settings.angles, "Number of directions of the sweep")
      .ShowDefault();
  command.Add("--fractions", a.sweep_settings.fractions, "Number of fractional speeds of the sweep")
      .ShowDefault();
  command.Add("--whole", a.sweep_settings.whole, "Whole pixels per subframe of the sweep's speeds")
      .ShowDefault();
  for (const DenseParameterInfo& info : kDenseParameters) {
    std::string option = std::string("--") + info.name;
    std::replace(option.begin(), option.end(), '_', '-');
    std::string help = info.meaning;
    help.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(help.front())));
    command.Add(option, settings.dense.parameters.*info.member, help).ShowDefault();
  }
  command
      .Add("--motion-radius", settings.dense.motion_radius,
           "Pixels around within which the longest motion counts")
      .ShowDefault();
  command.Add("--window", settings.dense.window, "Samples that a static pixel averages")
      .ShowDefault();
  command.Add("--threads", a.threads, "Number of threads (default: all cores)");
  command.Add("--pictures", a.pictures, "Folder for pictures of what was judged");
  command.AddFlag("--markdown", a.markdown, "Print Markdown tables");
  AddJsonOption(command, &a.json);
  command.OnParsed([arguments, run] { *run = [arguments] { return RunDense(*arguments); }; });
}

}  // namespace warplut
