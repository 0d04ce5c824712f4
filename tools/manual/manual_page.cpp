#include "tools/manual/manual_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "datasets/file.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

// Text of one line as roff shows it.
std::string Roff(const std::string& text) {
  std::string roff;
  for (const char c : text) {
    if (c == '\\') {
      roff += "\\e";
    } else if (c == '-') {
      roff += "\\-";
    } else if (c == '\n') {
      roff += ' ';
    } else {
      roff += c;
    }
  }
  if (roff.starts_with('.') || roff.starts_with('\'')) roff.insert(0, "\\&");
  return roff;
}

std::string Upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string Sentence(const std::string& text) { return text.ends_with('.') ? text : text + "."; }

// The word that stands for a value: the name of its option.
std::string ValueName(const OptionDescription& option) {
  std::string name = option.names.back();
  name.erase(0, name.find_first_not_of('-'));
  return Upper(name);
}

std::string Values(const OptionDescription& option) {
  const std::string value = "\\fI" + Roff(ValueName(option)) + "\\fR";
  if (!option.several) return value;
  return option.separated ? value + "[," + value + "...]" : value + " ...";
}

std::string OptionText(const OptionDescription& option) {
  std::string names;
  for (const std::string& name : option.names) {
    if (option.positional) continue;
    names += (names.empty() ? "\\fB" : ", \\fB") + Roff(name) + "\\fR";
  }
  if (option.positional) {
    names = Values(option);
  } else if (option.takes_value) {
    names += " " + Values(option);
  }
  std::string text = ".TP\n" + names + "\n" + Roff(Sentence(option.help)) + "\n";
  if (!option.choices.empty()) {
    text += Roff(fmt::format("Values: {}.", fmt::join(option.choices, ", "))) + "\n";
  }
  if (!option.default_value.empty()) {
    text += Roff(fmt::format("Default: {}.", option.default_value)) + "\n";
  }
  if (option.required) text += "Required.\n";
  return text;
}

class PageMaker {
 public:
  PageMaker(std::string version, const std::vector<std::string>& exit_meanings,
            std::vector<ManualPage>& pages)
      : version_(std::move(version)), exit_meanings_(exit_meanings), pages_(pages) {}

  // `path`: the names of the commands down to this one, with spaces; `above`: the page of the one
  // above.
  void Add(const CommandDescription& command, const std::string& path, const std::string& above) {
    const std::string page = PageName(path);
    std::string text =
        fmt::format(".TH {} 1 \"\" \"{}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n",
                    Roff(Upper(page)), Roff(version_), Roff(page), Roff(command.help));
    text += Synopsis(command, path);
    text += Section("ARGUMENTS", command, true) + Section("OPTIONS", command, false);
    if (!command.commands.empty()) {
      text += ".SH COMMANDS\n";
      for (const CommandDescription& below : command.commands) {
        text += fmt::format(".TP\n\\fB{}\\fR(1)\n{}\n", Roff(PageName(path + " " + below.name)),
                            Roff(Sentence(below.help)));
      }
    }
    if (above.empty()) {
      text += ".SH EXIT STATUS\n";
      for (std::size_t code = 0; code < exit_meanings_.size(); ++code) {
        text += fmt::format(".TP\n{}\n{}\n", code, Roff(exit_meanings_[code]));
      }
    } else {
      text += fmt::format(".SH SEE ALSO\n\\fB{}\\fR(1)\n", Roff(above));
    }
    pages_.push_back({.name = page + ".1", .text = text});
    for (const CommandDescription& below : command.commands) {
      Add(below, path + " " + below.name, page);
    }
  }

 private:
  static std::string PageName(std::string path) {
    std::replace(path.begin(), path.end(), ' ', '-');
    return path;
  }

  static std::string Synopsis(const CommandDescription& command, const std::string& path) {
    std::string text = "\\fB" + Roff(path) + "\\fR";
    if (!command.commands.empty()) text += " \\fICOMMAND\\fR";
    for (const OptionDescription& option : command.options) {
      if (option.positional || !option.required) continue;
      text += " \\fB" + Roff(option.names.back()) + "\\fR " + Values(option);
    }
    text += " [\\fIOPTIONS\\fR]";
    for (const OptionDescription& option : command.options) {
      if (option.positional) text += " " + Values(option);
    }
    return text + "\n";
  }

  static std::string Section(const char* title, const CommandDescription& command,
                             bool positional) {
    std::string text;
    for (const OptionDescription& option : command.options) {
      if (option.positional == positional) text += OptionText(option);
    }
    return text.empty() ? "" : fmt::format(".SH {}\n{}", title, text);
  }

  const std::string version_;
  const std::vector<std::string>& exit_meanings_;
  std::vector<ManualPage>& pages_;
};

}  // namespace

std::vector<ManualPage> ManualPages(const CommandDescription& program, const std::string& version,
                                    const std::vector<std::string>& exit_meanings) {
  std::vector<ManualPage> pages;
  PageMaker(program.name + " " + version, exit_meanings, pages).Add(program, program.name, "");
  return pages;
}

std::vector<fs::path> WriteManual(const fs::path& folder, const std::vector<ManualPage>& pages) {
  CreateFolder(folder);
  std::vector<fs::path> paths;
  for (const ManualPage& page : pages) {
    paths.push_back(folder / page.name);
    WriteFile(paths.back(), page.text);
  }
  return paths;
}

}  // namespace warplut
