// Completions of shells: every command and option occurs, and bash completes by them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <sstream>

#include "datasets/file.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/manual/program_description.h"
#include "tests/tools/program.h"
#include "tools/manual/completion_script.h"

namespace warplut {
namespace {

using testing::Contains;
using testing::HasSubstr;

// Whether a script has the word, with nothing beside it that would make it another one.
bool HasWord(const std::string& script, const std::string& word) {
  const auto part_of_word = [](char c) { return std::isalnum(c) != 0 || c == '-'; };
  for (std::size_t at = script.find(word); at != std::string::npos;
       at = script.find(word, at + 1)) {
    const char before = at == 0 ? ' ' : script[at - 1];
    const std::size_t end = at + word.size();
    const char after = end == script.size() ? ' ' : script[end];
    if (!part_of_word(before) && !part_of_word(after)) return true;
  }
  return false;
}

// What fish has in place of "--lut": -l lut.
std::string FishName(const std::string& name) {
  return name.starts_with("--") ? "-l " + name.substr(2) : "-s " + name.substr(1);
}

TEST(Completion, HasEveryCommandAndOption) {
  const CommandDescription program = ProgramDescription();
  for (const std::string& shell : CompletionShells()) {
    const std::string script = CompletionScript(shell, program);
    int checked = 0;
    ForEachCommand(program, [&](const CommandDescription& command, const std::string& path) {
      EXPECT_TRUE(HasWord(script, command.name)) << shell << ": " << path;
      for (const OptionDescription& option : command.options) {
        for (const std::string& name : option.names) {
          if (option.positional) continue;
          const std::string word = shell == "fish" ? FishName(name) : name;
          EXPECT_TRUE(HasWord(script, word)) << shell << ": " << path << " " << name;
          ++checked;
        }
        for (const std::string& choice : option.choices) {
          EXPECT_TRUE(HasWord(script, choice)) << shell << ": " << path << " " << choice;
        }
      }
    });
    EXPECT_GT(checked, 150);
  }
}

TEST(Completion, ScriptsAreFreeOfFaults) {
  const TemporaryFolder folder;
  for (const char* shell : {"bash", "zsh", "fish"}) {
    WriteFile(folder / shell, CompletionScript(shell, ProgramDescription()));
    const auto program = ProgramPath(shell);
    if (!program) {
      std::printf("%s is not installed; its script is not parsed\n", shell);
      continue;
    }
    const ProgramResult result = RunProgram(*program, {"-n", folder / shell});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
  }
  if (const auto shellcheck = ProgramPath("shellcheck")) {
    const ProgramResult result =
        RunProgram(*shellcheck, {"--shell", "bash", "--exclude", "SC2207", folder / "bash"});
    EXPECT_EQ(result.code, 0) << result.out;
  }
}

class BashCompletion : public testing::Test {
 protected:
  void SetUp() override {
    if (!bash_) GTEST_SKIP() << "bash is not installed";
    WriteFile(folder_ / "script", CompletionScript("bash", ProgramDescription()));
    WriteFile(folder_ / "table one.json", "{}");
  }

  // What is offered for the last of the words.
  std::vector<std::string> Offered(const std::vector<std::string>& words) const {
    std::string line;
    for (const std::string& word : words) line += " '" + word + "'";
    const std::string program =
        "cd '" + folder_.path().string() + "'; source ./script; COMP_WORDS=(warplut" + line +
        "); " + "COMP_CWORD=" + std::to_string(words.size()) +
        "; _warplut; for one in \"${COMPREPLY[@]}\"; do printf '%s\\n' \"$one\"; done";
    const ProgramResult result = RunProgram(*bash_, {"--norc", "-c", program});
    EXPECT_EQ(result.code, 0) << result.err;
    std::vector<std::string> offered;
    std::istringstream lines(result.out);
    for (std::string one; std::getline(lines, one);) offered.push_back(one);
    return offered;
  }

  const std::optional<std::string> bash_ = ProgramPath("bash");
  const TemporaryFolder folder_;
};

TEST_F(BashCompletion, OffersCommandsOptionsChoicesAndFiles) {
  EXPECT_THAT(Offered({"prof"}), testing::ElementsAre("profile"));
  EXPECT_THAT(Offered({"dataset", "rend"}), testing::ElementsAre("render"));
  EXPECT_THAT(Offered({"judge", "--agai"}), testing::ElementsAre("--against"));
  EXPECT_THAT(Offered({"judge", "--lut", "x.json", "--border", "2", "--agai"}),
              testing::ElementsAre("--against"));
  EXPECT_THAT(Offered({"judge", "--lookup", ""}),
              testing::UnorderedElementsAre("nearest", "bilinear"));
  EXPECT_THAT(Offered({"judge", "--lookup", "=", "near"}), testing::ElementsAre("nearest"));
  EXPECT_THAT(Offered({"eval", "--offsets", "half,r"}), testing::ElementsAre("half,random"));
  EXPECT_THAT(Offered({"judge", "--lut", "tab"}), testing::ElementsAre("table one.json"));
  EXPECT_THAT(Offered({"bake", "tab"}), testing::ElementsAre("table one.json"));
  EXPECT_THAT(Offered({"judge", "--border", ""}), testing::IsEmpty());
  EXPECT_THAT(Offered({"completion", "zs"}), testing::ElementsAre("zsh"));
}

TEST(CompletionCommand, PrintsTheScript) {
  const ProgramResult result = RunWarplut({"completion", "bash"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out, CompletionScript("bash", ProgramDescription()));
  EXPECT_THAT(RunWarplut({"completion", "fish", "--json"}).out, HasSubstr("\"script\""));
  ExpectRefused(RunWarplut({"completion", "cmd"}), kUsage, "cmd");
  ExpectRefused(RunWarplut({"completion"}), kUsage, "shell");
  ExpectError([] { CompletionScript("cmd", {}); }, {"'cmd'", "bash, zsh, fish"});
}

}  // namespace
}  // namespace warplut
