// warplut reflections: rays on the screen, by mip-maps and by the mesh of mesh projection.
#include <memory>

#include "tools/commands/command.h"
#include "tools/reflections/reflection_job.h"
#include "tools/tables/table_text.h"
#include "tools/thread_limit.h"

namespace warplut {
namespace {

struct ReflectionArguments {
  std::vector<std::string> scenes;
  ReflectionSettings settings;
  int threads = 0;
  bool markdown = false;
  bool json = false;
};

ExitCode RunReflections(const ReflectionArguments& arguments) {
  std::string why;
  RequireUsage(!arguments.scenes.empty(), "reflections takes at least one scene.");
  RequireUsage(arguments.settings.IsValid(&why), why);
  const ThreadLimit limit(arguments.threads);
  const std::vector<ReflectionReport> reports =
      MeasureReflections(arguments.scenes, arguments.settings);
  Json json = Json::array();
  for (const ReflectionReport& report : reports) {
    if (arguments.json) {
      json.push_back(ToJson(report));
      continue;
    }
    if (&report != &reports.front()) Print("\n");
    const TextTable table = ReflectionTable(report);
    Print(arguments.markdown ? ToMarkdown(table) : ToText(table));
  }
  if (arguments.json) PrintJson({{"scenes", json}});
  return ExitCode::kDone;
}

}  // namespace

void AddReflectionsCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<ReflectionArguments>();
  ReflectionArguments& a = *arguments;
  Command command = app.AddCommand(
      "reflections", "Judge screen-space reflections by mip-maps and by a mesh of triangles");
  command.Add("scenes", a.scenes, "Built-in scenes, or training, held-out or all");
  command.Add("--width", a.settings.width, "Width of the frame in pixels").ShowDefault();
  command.Add("--height", a.settings.height, "Height of the frame in pixels").ShowDefault();
  command.Add("--frame", a.settings.frame, "Number of the scene's frame").ShowDefault();
  command.Add("--step", a.settings.step, "Pixels between rays in each axis").ShowDefault();
  command.Add("--within", a.settings.within, "Pixels from the true hit within which it is found")
      .ShowDefault();
  command.Add("--tiles", a.settings.tiles, "Pixels of the tiles of each mesh")
      .Separated()
      .ShowDefault();
  command
      .Add("--thickness", a.settings.thicknesses,
           "Depth that surfaces fill, as shares of their own")
      .Separated()
      .ShowDefault();
  command.Add("--tear", a.settings.tear, "Share of the depth at which the mesh is torn")
      .ShowDefault();
  command.Add("--seed", a.settings.seed, "Seed of the scenes").ShowDefault();
  command.Add("--threads", a.threads, "Number of threads (default: all cores)");
  command.AddFlag("--markdown", a.markdown, "Print Markdown tables");
  AddJsonOption(command, &a.json);
  command.OnParsed([arguments, run] { *run = [arguments] { return RunReflections(*arguments); }; });
}

}  // namespace warplut
