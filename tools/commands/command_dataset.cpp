// warplut dataset: the built-in scenes, rendered; sequences on disk, imported and inspected.
#include "tools/commands/command_dataset.h"

#include <fmt/format.h>

#include <memory>

#include "datasets/file.h"
#include "datasets/sequence/sequence.h"
#include "tools/commands/command.h"
#include "tools/scene_rendering.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"

namespace warplut {
namespace {

struct RenderArguments {
  RenderOptions options;
  std::string selection;
  std::vector<std::string> streams = StreamNames(Streams::kAll);
  std::string out;
  bool json = false;
};

ExitCode RunRender(RenderArguments arguments) {
  RenderOptions& options = arguments.options;
  const Streams streams = AsUsage([&] { return ParseStreams(arguments.streams); });
  const std::vector<std::string> scenes =
      AsUsage([&] { return SelectScenes(arguments.selection); });
  RequireUsage(Contains(streams, Streams::kColor),
               "the streams to render lack color, which every sequence has.");
  options.reference = (streams & Streams::kOutputGrid) != Streams::kNone;
  std::string why;
  RequireUsage(options.IsValid(&why), why);

  const std::filesystem::path out = arguments.out;
  RequireWritableFolder(out);
  Json rendered = Json::array();
  for (const std::string& scene : scenes) {
    Progress progress("rendering " + scene, options.frames, "frames");
    int begun = 0;
    RenderScene(scene, options, streams, out / scene, [&] {
      ThrowIfInterrupted("render", "the same command goes on with the frames that are missing");
      progress.Update(begun++);
    });
    rendered.push_back(
        {{"scene", scene}, {"sequence", (out / scene / Sequence::kManifest).string()}});
    if (!arguments.json) Print(fmt::format("{}\n", (out / scene / Sequence::kManifest).string()));
  }
  if (arguments.json) PrintJson({{"sequences", rendered}});
  return ExitCode::kDone;
}

ExitCode RunScenes(bool json) {
  if (json) {
    Json scenes = Json::array();
    for (const SceneInfo& scene : Scenes()) {
      scenes.push_back({{"name", scene.name},
                        {"training", scene.use == SceneUse::kTraining},
                        {"use", Name(scene.use)},
                        {"purpose", scene.purpose}});
    }
    PrintJson({{"scenes", scenes}});
    return ExitCode::kDone;
  }
  for (const SceneInfo& scene : Scenes()) {
    Print(fmt::format("{:<12} {:<9} {}\n", scene.name, Name(scene.use), scene.purpose));
  }
  return ExitCode::kDone;
}

void AddRender(Command dataset, CommandRun* run) {
  const auto arguments = std::make_shared<RenderArguments>();
  RenderOptions& options = arguments->options;
  Command command =
      dataset.AddCommand("render", "Render built-in scenes into sequences, OUT/SCENE");
  command
      .Add("scene", arguments->selection,
           "Scenes to render: a name, or training, held-out, fault, all")
      .Required();
  command.Add("--out", arguments->out, "Folder for the sequences").Required();
  command.Add("--width", options.width, "Width of the output grid in pixels").ShowDefault();
  command.Add("--height", options.height, "Height of the output grid in pixels").ShowDefault();
  command.Add("--scale", options.scale, "Upscale factor, output / render").ShowDefault();
  command.Add("--frames", options.frames, "Number of frames to render").ShowDefault();
  command.Add("--samples", options.samples, "Samples per pixel of the reference").ShowDefault();
  command.Add("--seed", options.seed, "Seed of placement, textures and sample positions")
      .ShowDefault();
  command.AddFlag("--linear", options.linear,
                  "Write linear HDR colour (.exr) instead of sRGB (.png)");
  command.Add("--exposure", options.exposure, "Factor on the light, before the tone curve")
      .ShowDefault();
  command.Add("--threads", options.threads, "Number of threads (default: all cores)");
  command
      .Add("--streams", arguments->streams, "Streams to write, separated by commas (default: all)")
      .Separated();
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, run] { *run = [arguments] { return RunRender(*arguments); }; });
}

}  // namespace

void AddDatasetCommand(Command app, CommandRun* run) {
  Command dataset = app.AddCommand("dataset", "Make, import and inspect sequences of frames");
  AddRender(dataset, run);

  const auto json = std::make_shared<bool>(false);
  Command scenes = dataset.AddCommand("scenes", "List the built-in scenes");
  AddJsonOption(scenes, json.get());
  scenes.OnParsed([json, run] { *run = [json] { return RunScenes(*json); }; });

  AddInspectCommand(dataset, run);
  AddImportCommand(dataset, run);
}

}  // namespace warplut
