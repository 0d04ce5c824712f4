// warplut dataset import: frames as other tools write them, described by a manifest.
#include <fmt/format.h>

#include <memory>

#include "datasets/import/import_sequence.h"
#include "tools/commands/command_dataset.h"

namespace warplut {
namespace {

struct ImportArguments {
  ImportRequest request;
  std::string folder, cameras;
  double near = 0, far = 0;
  bool json = false;
};

ExitCode RunImport(ImportArguments arguments) {
  AsUsage([&] { return FindImportPreset(arguments.request.preset).name; });
  RequireUsage(arguments.request.scale >= Sequence::kMinScale &&
                   arguments.request.scale <= Sequence::kMaxScale,
               fmt::format("--scale is {}; expected 1 to 4.", arguments.request.scale));
  arguments.request.folder = arguments.folder;
  arguments.request.cameras = arguments.cameras;
  if (arguments.near > 0) arguments.request.near = arguments.near;
  if (arguments.far > 0) arguments.request.far = arguments.far;
  const ImportResult result = ImportSequence(arguments.request);
  const std::string manifest = (result.sequence.folder / Sequence::kManifest).string();
  if (arguments.json) {
    PrintJson({{"sequence", manifest},
               {"frames", result.sequence.count},
               {"streams", StreamNames(AvailableStreams(result.sequence))},
               {"notes", result.notes}});
    return ExitCode::kDone;
  }
  std::string streams;
  for (const std::string& name : StreamNames(AvailableStreams(result.sequence))) {
    streams += (streams.empty() ? "" : ", ") + name;
  }
  Print(fmt::format("{}: {} frames with {}\n", manifest, result.sequence.count, streams));
  for (const std::string& note : result.notes) Print(note + "\n");
  Print("Check it: warplut dataset inspect " + arguments.folder + "\n");
  return ExitCode::kDone;
}

}  // namespace

void AddImportCommand(Command dataset, CommandRun* run) {
  const auto arguments = std::make_shared<ImportArguments>();
  ImportRequest& request = arguments->request;
  Command command = dataset.AddCommand(
      "import", "Write the manifest of frames that another tool wrote, FOLDER/sequence.json");
  std::string presets;
  for (const ImportPreset& preset : ImportPresets()) {
    presets += fmt::format("{}{}", presets.empty() ? "" : ", ", preset.name);
  }
  command.Add("folder", arguments->folder, "Folder with the frames of the tool").Required();
  command.Add("--preset", request.preset, "Tool that wrote the frames: " + presets).Required();
  command.Add("--name", request.name, "Name of the sequence (default: the folder's)");
  command
      .Add("--scale", request.scale,
           "Upscale factor, output / render, where no references are found")
      .ShowDefault();
  command.Add("--near", arguments->near, "Near plane, in units of the depth");
  command.Add("--far", arguments->far,
              "Far plane, in units of the depth (default: the largest depth)");
  command.Add("--cameras", arguments->cameras,
              "JSON file with the fields camera and jitter of a manifest");
  command.AddFlag("--replace", request.replace, "Replace a manifest that is there");
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, run] { *run = [arguments] { return RunImport(*arguments); }; });
}

}  // namespace warplut
