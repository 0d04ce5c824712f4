#include "tools/manual/completion_script.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "datasets/error.h"
#include "tools/manual/shell_completions.h"

namespace warplut {
namespace {

struct Shell {
  const char* name;
  std::string (*script)(const CommandDescription& program);
};

constexpr Shell kShells[] = {
    {"bash", BashCompletion}, {"zsh", ZshCompletion}, {"fish", FishCompletion}};

}  // namespace

std::vector<std::string> CompletionShells() {
  std::vector<std::string> names;
  for (const Shell& shell : kShells) names.emplace_back(shell.name);
  return names;
}

std::string CompletionScript(const std::string& shell, const CommandDescription& program) {
  for (const Shell& one : kShells) {
    if (shell == one.name) return one.script(program);
  }
  throw Error(
      fmt::format("the shell is '{}'; expected {}", shell, fmt::join(CompletionShells(), ", ")));
}

}  // namespace warplut
