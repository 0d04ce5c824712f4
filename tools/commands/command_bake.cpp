// warplut bake: a fit to the files that a renderer compiles, uploads or reads.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "luts/bake/bake.h"
#include "luts/bake/table_io.h"
#include "luts/table.h"
#include "tools/commands/command.h"
#include "tools/pictures/lut_picture.h"
#include "tools/table_format.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

struct BakeArguments {
  std::string fit;
  std::string out;
  std::string format = Name(TableFormat::kI16);
  double blend = kDefaultBlend;
  bool json = false;
};

// The weights of all nodes as every kernel uses them.
std::vector<Weights<float>> NodeWeights(const TableView& view) {
  const Table table(view);
  std::vector<Weights<float>> rows;
  rows.reserve(kRows);
  for (int row = 0; row < kRows; ++row) {
    const auto dx = static_cast<float>(NodeOffset(row % kNodes));
    const auto dy = static_cast<float>(NodeOffset(row / kNodes));
    rows.push_back(table.At(dx, dy, Lookup::kNearest));
  }
  return rows;
}

std::string LoopText(const char* offsets, const Loop& loop, double blend) {
  const std::string safe = loop.safe_warps ? fmt::format("{} safe warps", *loop.safe_warps)
                                           : "any number of warps is safe";
  return fmt::format("{}: gain {:.5f}, {}; closed loop with blend {:.2g}: {:.5f} ({})\n", offsets,
                     loop.gain, safe, blend, loop.closed_loop_gain,
                     loop.closed_loop_gain < 1 ? "stable" : "not stable");
}

ExitCode RunBake(const BakeArguments& arguments) {
  const BakeOptions options{.format = TableFormatOf(arguments.format), .blend = arguments.blend};
  std::string why;
  RequireUsage(options.IsValid(&why), why);

  RequireWritableFolder(arguments.out);
  const Fit fit = ReadFit(arguments.fit);
  const BakedFiles files = Bake(fit, options);
  const fs::path out = arguments.out;
  CreateFolder(out);
  WriteBaked(out, files);
  const BakedTable table = LoadTable(out / (files.name + ".json")).table;
  WriteImage(out / (files.name + ".png"),
             LutPicture(table.view().footprint, NodeWeights(table.view())), PixelType::kUint8);

  std::vector<std::string> endings;
  for (const BakedFile& file : files.All()) endings.push_back(file.ending);
  endings.emplace_back(".png");
  if (arguments.json) {
    Json written = Json::array();
    for (const std::string& ending : endings)
      written.push_back((out / (files.name + ending)).string());
    Json certificate = Json::parse(files.json)["certificate"];
    certificate.erase("node_gains");
    PrintJson({{"name", files.name},
               {"format", arguments.format},
               {"files", written},
               {"certificate", certificate}});
    return ExitCode::kDone;
  }
  for (const std::string& ending : endings) Print((out / (files.name + ending)).string() + "\n");
  const Stability stability = CertifyStability(table.view(), options.blend);
  Print(LoopText("any offset", stability.any, options.blend) +
        LoopText("half offset", stability.half, options.blend));
  return ExitCode::kDone;
}

}  // namespace

void AddBakeCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<BakeArguments>();
  Command command = app.AddCommand(
      "bake", "Write a fit as a C++ header, JSON, shader sources, textures and a picture");
  command.Add("fit", arguments->fit, "Fit to bake (JSON)").Required();
  command.Add("--out", arguments->out, "Folder for the files").Required();
  command.Add("--format", arguments->format, "Storage format of the weights")
      .OneOf(TableFormatNames())
      .ShowDefault();
  command
      .Add("--blend", arguments->blend,
           "Share of the current frame in the loop that the certificate judges")
      .ShowDefault();
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, run] { *run = [arguments] { return RunBake(*arguments); }; });
}

}  // namespace warplut
