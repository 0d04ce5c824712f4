// The command line of `warplut` as data, and programs that judge what is made of it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <sstream>
#include <string>

#include "tools/commands/command.h"

namespace warplut {

inline CommandDescription ProgramDescription() {
  CommandLine line("warplut", "Trains and judges tables.", WARPLUT_VERSION);
  CommandRun run;
  for (const CommandAdder add : kCommands) add(line.program(), &run);
  return line.program().Describe();
}

// Calls `visit` with every command and its path, the program first.
inline void ForEachCommand(
    const CommandDescription& command,
    const std::function<void(const CommandDescription&, const std::string&)>& visit,
    const std::string& above = "") {
  const std::string path = above.empty() ? command.name : above + " " + command.name;
  visit(command, path);
  for (const CommandDescription& below : command.commands) ForEachCommand(below, visit, path);
}

// The path of an installed program, if it is there.
inline std::optional<std::string> ProgramPath(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path program = std::filesystem::path(folder) / name;
    if (std::filesystem::exists(program)) return program.string();
  }
  return std::nullopt;
}

}  // namespace warplut
