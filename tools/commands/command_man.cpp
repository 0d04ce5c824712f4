// warplut man: the manual pages of the program and its commands.
#include <iterator>
#include <memory>

#include "tools/commands/command.h"
#include "tools/manual/manual_page.h"

namespace warplut {
namespace {

struct ManArguments {
  std::string folder;
  bool json = false;
};

ExitCode RunMan(const ManArguments& arguments, const CommandDescription& program) {
  const std::vector<std::string> meanings(std::begin(kExitMeanings), std::end(kExitMeanings));
  const auto paths = WriteManual(arguments.folder, ManualPages(program, WARPLUT_VERSION, meanings));
  Json files = Json::array();
  for (const std::filesystem::path& path : paths) {
    files.push_back(path.string());
    if (!arguments.json) Print(path.string() + "\n");
  }
  if (arguments.json) PrintJson({{"files", files}});
  return ExitCode::kDone;
}

}  // namespace

void AddManCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<ManArguments>();
  Command command = app.AddCommand("man", "Write manual pages of the program and its commands");
  command.Add("folder", arguments->folder, "Folder for the pages, as share/man/man1").Required();
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, app, run] {
    *run = [arguments, app] { return RunMan(*arguments, app.Describe()); };
  });
}

}  // namespace warplut
