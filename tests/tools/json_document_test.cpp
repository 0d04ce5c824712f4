#include "tests/tools/json_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "datasets/file.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/stability/cases/stability_table.h"
#include "tests/tools/program.h"
#include "tools/bench/benchmark_tables.h"

namespace warplut {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr char kPage[] =
    "## judge\n\n| key | type | meaning |\n|---|---|---|\n"
    "| `filter` | string | its name |\n| `more` | number | if asked for |\n\n"
    "Below `rows[]`, a score:\n\n"
    "| `psnr`, `ssim` | number or null | of a frame |\n| `by.*` | number | anything |\n\n"
    "## inspect\n\nThe document of a folder:\n\n| `name` | string | of it |\n\n"
    "The document of a file:\n\n| `file` | string | its path |\n\n"
    "## list\n\n| `[].a` | boolean | one |\n";

std::vector<std::string> Faults(const std::string& command, const std::string& json) {
  return JsonFaults(nlohmann::json::parse(json), DocumentedKeys(kPage, command));
}

TEST(JsonDocument, FitsItsTables) {
  const char* rows = R"("rows": [{"psnr": null, "ssim": 0.5, "by": {"x": 1, "y": 2}}])";
  EXPECT_THAT(Faults("judge", std::string(R"({"filter": "a", )") + rows + "}"), IsEmpty());
  EXPECT_THAT(Faults("judge", std::string(R"({"filter": "a", "more": 3, )") + rows + "}"),
              IsEmpty());
  EXPECT_THAT(Faults("list", R"([{"a": true}, {"a": false}])"), IsEmpty());
}

TEST(JsonDocument, EachFaultIsNamed) {
  EXPECT_THAT(
      Faults("judge", R"({"filter": 1, "new": 2, "rows": [{"psnr": 1, "by": {"x": "y"}}]})"),
      ElementsAre("filter is of type number; documented: string", "new is not documented",
                  "rows[] has no ssim", "rows[].by.x is of type string; documented: number"));
  EXPECT_THAT(Faults("judge", R"({"rows": []})"), ElementsAre("the document has no filter"));
  EXPECT_THAT(Faults("list", R"([{}])"), ElementsAre("[] has no a"));
}

TEST(JsonDocument, IsOneOfThoseThatACommandPrints) {
  EXPECT_THAT(Faults("inspect", R"({"name": "a"})"), IsEmpty());
  EXPECT_THAT(Faults("inspect", R"({"file": "a"})"), IsEmpty());
  EXPECT_FALSE(Faults("inspect", R"({"name": "a", "file": "a"})").empty());
}

TEST(JsonDocument, TheSectionIsThatOfTheCommand) {
  EXPECT_EQ(JsonSection({"bench", "sr", "--json"}), "bench sr");
  EXPECT_EQ(JsonSection({"eval", "--sequence", "a"}), "judge");
  EXPECT_EQ(JsonSection({"eval", "--images", "a"}), "eval");
}

std::vector<DocumentedKey> KeysOf(const char* command) {
  const std::string page = ReadFile(std::filesystem::path(WARPLUT_SOURCE) / "docs/JSON.md");
  std::vector<DocumentedKey> keys = DocumentedKeys(page, command);
  EXPECT_FALSE(keys.empty()) << command;
  return keys;
}

TEST(JsonDocument, OfExpensiveCommandsIsDocumented) {
  WarpBenchmark warp;
  warp.rows.emplace_back();
  EXPECT_THAT(JsonFaults(ToJson(warp), KeysOf("bench warp")), IsEmpty());
  EXPECT_THAT(JsonFaults(ToJson(SsimBenchmark()), KeysOf("bench ssim")), IsEmpty());
  EXPECT_THAT(JsonFaults(ToJson(std::vector<SrBenchmarkRow>(1)), KeysOf("bench sr")), IsEmpty());
  EXPECT_THAT(
      JsonFaults(ToJson(std::vector<GenerationBenchmarkRow>(1)), KeysOf("bench generation")),
      IsEmpty());
  PassBenchmark passes;
  passes.rows.emplace_back();
  EXPECT_THAT(JsonFaults(ToJson(passes), KeysOf("bench passes")), IsEmpty());
  StabilityOutcome outcome = {.stability_case = StabilityCases().front(), .result = {}};
  EXPECT_THAT(JsonFaults(ToJson(std::vector{outcome}), KeysOf("stability")), IsEmpty());
  outcome.stability_case.failing = "It fails.";
  EXPECT_THAT(JsonFaults(ToJson(std::vector{outcome}), KeysOf("stability")), IsEmpty());
}

// RunWarplut compares the output with the page; other tests do so for the other commands.
TEST(JsonDocument, OfCheapCommandsIsDocumented) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "scenes").string();
  EXPECT_EQ(RunWarplut({"dataset", "render", "still", "--out", out, "--width", "64", "--height",
                        "36", "--frames", "3", "--samples", "1", "--json"})
                .code,
            0);
  EXPECT_EQ(RunWarplut({"bake", std::string(WARPLUT_SOURCE) + "/luts/fits/warplut_sr_x2.json",
                        "--out", (folder.path() / "baked").string(), "--json"})
                .code,
            0);
}

}  // namespace
}  // namespace warplut
