#include "tools/commands/command.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "datasets/json_fields.h"
#include "train/ranks/ranks.h"

namespace warplut {

CommandOption AddJsonOption(Command command, bool* json) {
  return command.AddFlag("--json", *json, "Print JSON for programs instead of text for people");
}

void Print(std::string_view text) {
  if (!Ranks::World().IsRoot()) return;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw Error(std::string("standard output could not be written: ") + std::strerror(errno) + ".");
  }
}

void PrintJson(const Json& document) { Print(JsonText(document, 2) + "\n"); }

}  // namespace warplut
