#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tools/manual/shell_completions.h"

namespace warplut {
namespace {

// Text inside single quotes and brackets of an argument of _arguments.
std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\'') {
      escaped += "'\\''";
    } else if (c == '[' || c == ']' || c == ':' || c == '\\') {
      escaped += '\\';
      escaped += c;
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string Without(const std::string& name, char c) {
  std::string plain = name;
  std::erase(plain, c);
  return plain;
}

// "_files", "(a b)", or nothing to complete.
std::string Action(const OptionDescription& option) {
  if (!option.choices.empty() && option.separated) {
    return fmt::format("_values -s , value {}", fmt::join(option.choices, " "));
  }
  if (!option.choices.empty()) return fmt::format("({})", fmt::join(option.choices, " "));
  return option.number ? " " : "_files";
}

std::string Function(const std::string& path) {
  std::string name = "_" + path;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

class ZshScript {
 public:
  explicit ZshScript(const CommandDescription& program) { Add(program, program.name); }

  std::string Text(const std::string& name) const {
    return fmt::format(
        "#compdef {0}\n# Completion of {0} for zsh, as _{0} in a folder of $fpath.\n"
        "{1}\nif [ \"$funcstack[1]\" = _{0} ]; then\n  _{0} \"$@\"\nelse\n"
        "  compdef _{0} {0}\nfi\n",
        name, functions_);
  }

 private:
  void Add(const CommandDescription& command, const std::string& path) {
    std::vector<std::string> arguments;
    for (const OptionDescription& option : command.options) AddArguments(option, arguments);
    std::string rest;
    if (!command.commands.empty()) {
      std::string names, cases;
      for (const CommandDescription& below : command.commands) {
        std::string help = Escaped(below.help);
        std::replace(help.begin(), help.end(), '"', ' ');
        names += fmt::format(" {}\\:\"{}\"", below.name, help);
        cases += fmt::format("      {}) {} ;;\n", below.name, Function(path + " " + below.name));
      }
      arguments.push_back(fmt::format("'1:command:(({}))'", names.substr(1)));
      arguments.emplace_back("'*::argument:->arguments'");
      rest = fmt::format(
          "  if [[ $state == arguments ]]; then\n    case $line[1] in\n{}    esac\n  fi\n", cases);
    }
    functions_ +=
        fmt::format("\n{}() {{\n  local context state line\n  _arguments -C \\\n    {}\n{}}}\n",
                    Function(path), fmt::join(arguments, " \\\n    "), rest);
    for (const CommandDescription& below : command.commands) Add(below, path + " " + below.name);
  }

  static void AddArguments(const OptionDescription& option, std::vector<std::string>& arguments) {
    if (option.positional) {
      arguments.push_back(fmt::format("'{}:{}:{}'", option.several ? "*" : "", option.names.front(),
                                      Action(option)));
      return;
    }
    for (const std::string& name : option.names) {
      std::string value;
      if (option.takes_value) {
        value = fmt::format(":{}{}:{}", option.several && !option.separated ? "*-*:" : "",
                            Without(name, '-'), Action(option));
      }
      arguments.push_back(fmt::format("'{}[{}]{}'", name, Escaped(option.help), value));
    }
  }

  std::string functions_;
};

}  // namespace

std::string ZshCompletion(const CommandDescription& program) {
  return ZshScript(program).Text(program.name);
}

}  // namespace warplut
