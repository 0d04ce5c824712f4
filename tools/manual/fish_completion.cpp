#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/manual/shell_completions.h"

namespace warplut {
namespace {

// A word in single quotes, as fish reads it.
std::string FishQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

class FishScript {
 public:
  explicit FishScript(const CommandDescription& program) : program_(program.name) {
    Add(program, "");
  }

  std::string Text() const {
    return fmt::format(
        "# Completion of {0} for fish. Install it as {0}.fish in a folder of\n"
        "# $fish_complete_path.\n{1}",
        program_, lines_);
  }

 private:
  // `seen`: the condition under which the words so far are the path of this command.
  void Add(const CommandDescription& command, const std::string& seen) {
    std::vector<std::string> names;
    for (const CommandDescription& below : command.commands) names.push_back(below.name);
    std::string here = seen;
    if (!names.empty()) {
      here += fmt::format("{}not __fish_seen_subcommand_from {}", seen.empty() ? "" : "; and ",
                          fmt::join(names, " "));
    }
    for (const CommandDescription& below : command.commands) {
      Line(here, fmt::format("-f -a {} -d {}", below.name, FishQuoted(below.help)));
    }
    for (const OptionDescription& option : command.options) Line(here, ArgumentsOf(option));
    for (const CommandDescription& below : command.commands) {
      Add(below, fmt::format("{}{}__fish_seen_subcommand_from {}", seen,
                             seen.empty() ? "" : "; and ", below.name));
    }
  }

  void Line(const std::string& condition, const std::string& arguments) {
    lines_ += fmt::format("complete -c {} -n {} {}\n", program_, FishQuoted(condition), arguments);
  }

  static std::string ArgumentsOf(const OptionDescription& option) {
    std::string text;
    if (option.positional && option.choices.empty()) text += "-F";
    if (!option.positional) {
      for (const std::string& name : option.names) {
        const bool is_long = name.starts_with("--");
        text += fmt::format("{}{} {}", text.empty() ? "" : " ", is_long ? "-l" : "-s",
                            name.substr(is_long ? 2 : 1));
      }
      if (option.takes_value) text += option.choices.empty() && !option.number ? " -r -F" : " -x";
    }
    if (!option.choices.empty()) {
      text += fmt::format("{}-a {}", text.empty() ? "-f " : " ",
                          FishQuoted(fmt::format("{}", fmt::join(option.choices, " "))));
    }
    return text + " -d " + FishQuoted(option.help);
  }

  const std::string program_;
  std::string lines_;
};

}  // namespace

std::string FishCompletion(const CommandDescription& program) { return FishScript(program).Text(); }

}  // namespace warplut
