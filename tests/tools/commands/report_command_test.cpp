#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "datasets/file.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"
#include "tests/train/replay/pan_sequence.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int kUsage = 1;
constexpr int kFailed = 2;

class ReportCommand : public testing::Test {
 protected:
  std::string Out() const { return folder_ / "report"; }
  const TemporaryFolder folder_;
};

TEST_F(ReportCommand, MakesAPageOfAPersonsSequence) {
  WritePan(folder_ / "pan");
  const ProgramResult result =
      RunWarplut({"report", "--out", Out(), "--quick", "--sequence", folder_ / "pan", "--sections",
                  "pipelines,hardware", "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(fs::exists(nlohmann::json::parse(result.out)["page"].get<std::string>()));
  const std::string page = ReadFile(fs::path(Out()) / "index.html");
  EXPECT_THAT(page, HasSubstr("id=\"pipelines\""));
  EXPECT_THAT(page, HasSubstr("id=\"hardware\""));
  EXPECT_THAT(page, testing::Not(HasSubstr("id=\"kernels\"")));
  EXPECT_TRUE(fs::exists(fs::path(Out()) / "tables/pipelines-small.md"));
  EXPECT_TRUE(fs::exists(fs::path(Out()) / "plots/pipelines-small.svg"));
}

TEST_F(ReportCommand, RefusesWhatMakesNoSense) {
  ExpectRefused(RunWarplut({"report"}), kUsage, "--out");
  ExpectRefused(RunWarplut({"report", "--out", Out(), "--sections", "weather"}), kUsage,
                "'weather'");
  ExpectRefused(RunWarplut({"report", "--out", Out(), "--sections", "growth,growth"}), kUsage,
                "twice");
  ExpectRefused(RunWarplut({"report", "--out", Out(), "--threads", "-1"}), kUsage, "threads");
  EXPECT_FALSE(fs::exists(Out()));
}

TEST_F(ReportCommand, RefusesWhatCannotBeJudged) {
  WritePan(folder_ / "blind", {.streams = Streams::kRenderGrid});
  const auto report = [&](const std::string& sequence) {
    return RunWarplut({"report", "--out", Out(), "--sections", "hardware", "--sequence", sequence});
  };
  ExpectRefused(report(folder_ / "blind"), kFailed, "no reference");
  ExpectRefused(report(folder_ / "nowhere"), kFailed, "nowhere");
  ExpectRefused(
      RunWarplut({"report", "--out", Out(), "--sections", "hardware", "--lut", "none.json"}),
      kFailed, "none.json");
  EXPECT_FALSE(fs::exists(fs::path(Out()) / "index.html"));
}

}  // namespace
}  // namespace warplut
