// Every line of every --help is a phrase that makes sense by itself (docs/STYLE.md).
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "tests/tools/program.h"

namespace warplut {
namespace {

// The column at which CLI11 prints descriptions.
constexpr std::size_t kDescription = 30;

struct HelpLine {
  std::string name;         // of the option, argument or subcommand
  std::string description;  // empty: there is none
  bool subcommand = false;
};

std::vector<HelpLine> LinesOf(const std::vector<std::string>& command) {
  std::vector<std::string> arguments = command;
  arguments.emplace_back("--help");
  const ProgramResult result = RunWarplut(arguments);
  EXPECT_EQ(result.code, 0) << result.err;
  std::vector<HelpLine> lines;
  std::istringstream text(result.out);
  std::string section;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("  ") && !section.empty()) {
      const bool described = line.size() > kDescription && line[kDescription - 1] == ' ';
      if (line[2] != ' ') {
        lines.push_back({.name = line.substr(2, line.find(' ', 2) - 2),
                         .description = {},
                         .subcommand = section == "Subcommands:"});
      }
      if (described && !lines.empty()) lines.back().description = line.substr(kDescription);
    } else if (line.ends_with(":")) {
      section = line;
    }
  }
  return lines;
}

int Words(const std::string& text) {
  std::istringstream words(text);
  int count = 0;
  for (std::string word; words >> word;) ++count;
  return count;
}

// Checks the help of a command and of its subcommands; the number of lines.
int Check(const std::vector<std::string>& command) {
  int checked = 0;
  for (const HelpLine& line : LinesOf(command)) {
    ++checked;
    EXPECT_GE(Words(line.description), 3) << line.name << ": " << line.description;
    for (const char* start : {"Of ", "What ", "Whose ", "How ", "Which "}) {
      EXPECT_FALSE(line.description.starts_with(start)) << line.name << ": " << line.description;
    }
    if (!line.subcommand) continue;
    std::vector<std::string> below = command;
    below.push_back(line.name);
    checked += Check(below);
  }
  return checked;
}

TEST(Help, EveryLineIsAPhrase) { EXPECT_GT(Check({}), 150); }

}  // namespace
}  // namespace warplut
