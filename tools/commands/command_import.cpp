// warplut dataset import: frames as other tools write them, described by a manifest.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "datasets/import/import_sequence.h"
#include "tools/commands/command_dataset.h"

namespace warplut {
namespace {

struct ImportArguments {
  ImportRequest request;
  std::string folder, fields;
  double near = 0, far = 0;
  bool json = false;
};

ExitCode RunImport(ImportArguments arguments) {
  AsUsage([&] { return FindImportPreset(arguments.request.preset).name; });
  RequireUsage(arguments.request.scale >= Sequence::kMinScale &&
                   arguments.request.scale <= Sequence::kMaxScale,
               fmt::format("--scale is {}; expected 1 to 4.", arguments.request.scale));
  arguments.request.folder = arguments.folder;
  arguments.request.fields = arguments.fields;
  if (arguments.near > 0) arguments.request.near = arguments.near;
  if (arguments.far > 0) arguments.request.far = arguments.far;
  const ImportResult result = ImportSequence(arguments.request);
  const std::string manifest = result.manifest.string();
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
  Print("Check it: warplut dataset inspect " + manifest + "\n");
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
  command.Add("--fields", arguments->fields,
              fmt::format("JSON file with fields of a manifest that frames do not tell: {}",
                          fmt::join(kImportFields, ", ")));
  command.Add("--capture", request.capture, "Capture to take, of several of the preset arm");
  command.Add("--reactive", request.reactive, "Files of the reactive mask, as masks/%04d.png");
  command.Add("--hud", request.hud, "Files of the HUD with its alpha, as hud/%04d.png");
  command.AddFlag("--color-alpha", request.alpha, "Take the alpha of the colour files too");
  command.AddFlag("--replace", request.replace, "Replace a manifest that is there");
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, run] { *run = [arguments] { return RunImport(*arguments); }; });
}

}  // namespace warplut
