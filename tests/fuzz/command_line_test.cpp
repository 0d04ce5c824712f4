// Command lines of tests/fuzz/command_lines.txt with arguments that are replaced, dropped, doubled
// and mixed: the program ends as its documents say, whatever it is told.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"

namespace warplut {
namespace {

using Arguments = std::vector<std::string>;

constexpr int kRuns = 40;

std::vector<Arguments> Stored(const TemporaryFolder& folder) {
  std::ifstream file(WARPLUT_COMMAND_LINES);
  std::vector<Arguments> lines;
  for (std::string line; std::getline(file, line);) {
    Arguments& arguments = lines.emplace_back();
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (word.starts_with("OUT") || word.starts_with("MISSING")) word = folder / word;
      arguments.push_back(word);
    }
  }
  return lines;
}

// Arguments that people and scripts slip in; none starts long work.
const Arguments kOdd = {"",           "-",           "--",     "-1",         "0",    "nan",
                        "inf",        "1e999",       "-0",     "0x10",       "1,",   ",",
                        "2147483648", "-2147483649", "1e-400", "\xff\xfe",   "é",    "a\nb",
                        "/dev/null",  "/",           "--help", "--threads=", "%n%s", "--json"};

// One argument or two replaced, dropped, doubled, or taken from another command.
Arguments Mutated(const std::vector<Arguments>& lines, std::mt19937& random) {
  const auto pick = [&](std::size_t count) { return static_cast<std::size_t>(random()) % count; };
  Arguments arguments = lines[pick(lines.size())];
  const std::size_t changes = 1 + pick(2);
  for (std::size_t change = 0; change < changes && arguments.size() > 1; ++change) {
    const auto at = arguments.begin() + static_cast<std::ptrdiff_t>(1 + pick(arguments.size() - 1));
    const Arguments& other = lines[pick(lines.size())];
    switch (pick(4)) {
      case 0:
        *at = kOdd[pick(kOdd.size())];
        break;
      case 1:
        arguments.erase(at);
        break;
      case 2:
        arguments.insert(at, std::string(*at));
        break;
      default:
        *at = other[pick(other.size())];
    }
  }
  return arguments;
}

std::string Text(const Arguments& arguments) {
  std::string text;
  for (const std::string& argument : arguments) text += " '" + argument + "'";
  return text;
}

TEST(CommandLineFuzz, EndsAsDocumented) {
  const TemporaryFolder folder;
  const std::vector<Arguments> lines = Stored(folder);
  ASSERT_GE(lines.size(), 10U);
  std::mt19937 random(1);
  int refused = 0;
  for (int run = 0; run < kRuns; ++run) {
    const Arguments arguments = Mutated(lines, random);
    // A report without sequences renders scenes for minutes.
    if (arguments[0] == "report" && Text(arguments).find("--sequence'") == std::string::npos) {
      continue;
    }
    SCOPED_TRACE(Text(arguments));
    const ProgramResult result = RunWarplut(arguments);
    ASSERT_TRUE(result.code == 0 || result.code == kUsage || result.code == kFailed)
        << result.code << result.err;
    if (result.code == 0) continue;
    ++refused;
    ExpectRefused(result, result.code, "");
  }
  EXPECT_GT(refused, kRuns / 2);
}

// The stored lines are of commands that there are.
TEST(CommandLineFuzz, StartsFromKnownCommands) {
  const TemporaryFolder folder;
  for (Arguments arguments : Stored(folder)) {
    arguments.emplace_back("--help");
    const ProgramResult result = RunWarplut(arguments);
    EXPECT_EQ(result.code, 0) << Text(arguments) << result.err;
    EXPECT_FALSE(result.out.empty()) << Text(arguments);
  }
}

}  // namespace
}  // namespace warplut
