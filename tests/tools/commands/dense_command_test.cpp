#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"

namespace warplut {
namespace {

ProgramResult Dense(const std::vector<std::string>& more) {
  return RunWarplut(WithDefaults({"dense"},
                                 {{"--width", "48"},
                                  {"--height", "32"},
                                  {"--samples", "1"},
                                  {"--warm-up", "4"},
                                  {"--frames", "4"}},
                                 more));
}

TEST(DenseCommand, JudgesScenesAndWritesPictures) {
  const TemporaryFolder folder;
  const std::string pictures = folder / "pictures";
  const ProgramResult result = Dense({"street", "gallery", "--json", "--pictures", pictures});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto scenes = nlohmann::json::parse(result.out)["scenes"];
  ASSERT_EQ(scenes.size(), 3U);
  EXPECT_EQ(scenes[2]["scene"], "mean");
  EXPECT_EQ(scenes[0]["displays"].size(), 7U);
  EXPECT_EQ(scenes[0]["displays"][4]["display"], "240 Hz, dense, adaptive");
  for (const char* kind : {"fixed", "tracking", "shown"}) {
    const std::string name = std::string("street-240-hz-dense-adaptive-") + kind + ".png";
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(pictures) / name)) << name;
  }
}

TEST(DenseCommand, SweepsDirectionAndSpeed) {
  const ProgramResult json = Dense({"--sweep", "--angles", "2", "--fractions", "1", "--json"});
  ASSERT_EQ(json.code, 0) << json.err;
  const auto sweep = nlohmann::json::parse(json.out)["sweep"];
  EXPECT_EQ(sweep["cells"].size(), 2U);
  EXPECT_EQ(sweep["rules"].size(), 7U);
  const ProgramResult text = Dense({"--sweep", "--angles", "2", "--fractions", "1", "--markdown"});
  EXPECT_THAT(text.out, testing::HasSubstr("| mixed |"));
}

TEST(DenseCommand, RefusesWhatItCannotJudge) {
  ExpectRefused(Dense({}), kUsage, "scenes or --sweep");
  ExpectRefused(Dense({"street", "--sweep"}), kUsage, "scenes or --sweep");
  ExpectRefused(Dense({"nowhere"}), kUsage, "nowhere");
  ExpectRefused(Dense({"street", "--width", "47"}), kUsage, "47 x 32");
  ExpectRefused(Dense({"street", "--gamma", "-1"}), kUsage, "gamma");
}

}  // namespace
}  // namespace warplut
