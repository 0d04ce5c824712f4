#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/manual/shell_completions.h"

namespace warplut {
namespace {

// A word in single quotes.
std::string BashQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

class BashScript {
 public:
  explicit BashScript(const CommandDescription& program) { Add(program, program.name); }

  std::string Text(const std::string& name) const {
    return fmt::format(
        R"(# Completion of {0} for bash. Source it, or install it as {0} in
# share/bash-completion/completions.
_{0}_choices() {{
  local before=
  case $current in *,*) before=${{current%,*}}, ;; esac
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$1" -- "${{current##*,}}")
}}

_{0}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  local path={0} words='' word
  if [[ $current == '=' ]]; then
    current=
  elif [[ $previous == '=' ]]; then
    previous=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case "$path $word" in
      {1}) path="$path $word" ;;
    esac
  done
  case "$path $previous" in
{2}  esac
  case "$path" in
{3}  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  case "$path" in
    {4})
      if [[ $current != -* ]]; then
        compopt -o filenames 2> /dev/null
        mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -f -- "$current")
      fi
      ;;
  esac
}}
complete -F _{0} {0}
)",
        name, fmt::join(commands_, " | "), values_, words_, fmt::join(leaves_, " | "));
  }

 private:
  void Add(const CommandDescription& command, const std::string& path) {
    std::vector<std::string> words;
    for (const CommandDescription& below : command.commands) words.push_back(below.name);
    for (const OptionDescription& option : command.options) {
      if (option.positional) {
        words.insert(words.end(), option.choices.begin(), option.choices.end());
        continue;
      }
      words.insert(words.end(), option.names.begin(), option.names.end());
      if (option.takes_value) AddValues(option, path);
    }
    words_ += fmt::format("    {}) words={} ;;\n", BashQuoted(path),
                          BashQuoted(fmt::format("{}", fmt::join(words, " "))));
    if (command.commands.empty()) leaves_.push_back(BashQuoted(path));
    for (const CommandDescription& below : command.commands) {
      commands_.push_back(BashQuoted(path + " " + below.name));
      Add(below, path + " " + below.name);
    }
  }

  void AddValues(const OptionDescription& option, const std::string& path) {
    std::vector<std::string> places;
    for (const std::string& name : option.names) places.push_back(BashQuoted(path + " " + name));
    std::string action = "compopt -o filenames 2> /dev/null; ";
    action += "mapfile -t COMPREPLY < <(compgen -f -- \"$current\")";
    if (!option.choices.empty()) {
      action = fmt::format("_{}_choices {}", path.substr(0, path.find(' ')),
                           BashQuoted(fmt::format("{}", fmt::join(option.choices, " "))));
    } else if (option.number) {
      action = "COMPREPLY=()";
    }
    values_ += fmt::format("    {}) {}; return ;;\n", fmt::join(places, " | "), action);
  }

  std::vector<std::string> commands_, leaves_;
  std::string values_, words_;
};

}  // namespace

std::string BashCompletion(const CommandDescription& program) {
  return BashScript(program).Text(program.name);
}

}  // namespace warplut
