#include "tools/manual/manual_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "datasets/file.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/manual/program_description.h"
#include "tests/tools/program.h"

namespace warplut {
namespace {

using testing::HasSubstr;

std::string PageName(std::string path) {
  std::replace(path.begin(), path.end(), ' ', '-');
  return path;
}

std::string WithHyphens(std::string roff) {
  for (std::size_t at; (at = roff.find("\\-")) != std::string::npos;) roff.erase(at, 1);
  return roff;
}

TEST(ManualPage, EveryCommandHasOneWithAllItsOptions) {
  const CommandDescription program = ProgramDescription();
  const std::vector<ManualPage> pages = ManualPages(program, "1", {"Done."});
  std::size_t commands = 0;
  ForEachCommand(program, [&](const CommandDescription& command, const std::string& path) {
    ++commands;
    const auto page = std::find_if(pages.begin(), pages.end(), [&](const ManualPage& one) {
      return one.name == PageName(path) + ".1";
    });
    ASSERT_NE(page, pages.end()) << path;
    const std::string text = WithHyphens(page->text);
    EXPECT_THAT(text, HasSubstr(command.help));
    for (const OptionDescription& option : command.options) {
      for (const std::string& name : option.names) {
        if (!option.positional) {
          EXPECT_THAT(text, HasSubstr("\\fB" + name + "\\fR")) << path;
        }
      }
      EXPECT_THAT(text, HasSubstr(option.help)) << path;
      for (const std::string& choice : option.choices) EXPECT_THAT(text, HasSubstr(choice));
    }
    for (const CommandDescription& below : command.commands) {
      EXPECT_THAT(text, HasSubstr("\\fB" + PageName(path + " " + below.name) + "\\fR(1)")) << path;
    }
  });
  EXPECT_EQ(pages.size(), commands);
  EXPECT_GT(commands, 15U);
  EXPECT_THAT(pages.front().text, HasSubstr(".SH EXIT STATUS\n.TP\n0\nDone.\n"));
}

TEST(ManualPage, TextIsNoMacro) {
  const CommandDescription program = {.name = "p",
                                      .help = ".a \\path 'x",
                                      .options = {{.names = {"-o", "--out"},
                                                   .help = "'quoted'",
                                                   .default_value = "1",
                                                   .choices = {"a", "b"},
                                                   .takes_value = true,
                                                   .several = true,
                                                   .separated = true,
                                                   .required = true}},
                                      .commands = {}};
  const std::string text = ManualPages(program, "1", {}).front().text;
  EXPECT_THAT(text, HasSubstr("p \\- \\&.a \\epath 'x\n"));
  EXPECT_THAT(text, HasSubstr("\n\\&'quoted'.\n"));
  EXPECT_THAT(text, HasSubstr("\\fB\\-o\\fR, \\fB\\-\\-out\\fR \\fIOUT\\fR[,\\fIOUT\\fR...]\n"));
  EXPECT_THAT(text, HasSubstr("Values: a, b.\nDefault: 1.\nRequired.\n"));
}

TEST(ManualPage, GroffHasNothingToSay) {
  const auto groff = ProgramPath("groff");
  if (!groff) GTEST_SKIP() << "groff is not installed";
  const TemporaryFolder folder;
  std::vector<std::string> arguments = {"-man", "-Tutf8", "-ww", "-rLL=78n"};
  for (const auto& path :
       WriteManual(folder / "man1", ManualPages(ProgramDescription(), "1", {"Done."}))) {
    arguments.push_back(path.string());
  }
  const ProgramResult result = RunProgram(*groff, arguments);
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("WARPLUT-DATASET-RENDER(1)"));
}

TEST(ManCommand, WritesThePages) {
  const TemporaryFolder folder;
  const ProgramResult result = RunWarplut({"man", folder / "man1", "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto files = nlohmann::json::parse(result.out)["files"];
  EXPECT_EQ(files.size(), ManualPages(ProgramDescription(), "", {}).size());
  EXPECT_THAT(ReadFile(folder / "man1/warplut-judge.1"), HasSubstr("\\-\\-against"));
  WriteFile(folder / "file", "x");
  ExpectRefused(RunWarplut({"man", folder / "file"}), kFailed, "file");
  ExpectRefused(RunWarplut({"man"}), kUsage, "folder");
}

}  // namespace
}  // namespace warplut
