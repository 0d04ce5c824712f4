#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/tools/program.h"

namespace warplut {
namespace {

ProgramResult Reflections(const std::vector<std::string>& more) {
  return RunWarplut(WithDefaults({"reflections"},
                                 {{"--width", "96"}, {"--height", "54"}, {"--step", "5"}}, more));
}

TEST(ReflectionsCommand, JudgesScenes) {
  const ProgramResult result = Reflections({"street", "gallery", "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto scenes = nlohmann::json::parse(result.out)["scenes"];
  ASSERT_EQ(scenes.size(), 3U);
  EXPECT_EQ(scenes[2]["scene"], "mean");
  ASSERT_EQ(scenes[0]["methods"].size(), 15U);
  for (const auto& scene : scenes) {
    EXPECT_GT(scene["findable"], 0.1);
    const auto& pixels = scene["methods"][0];
    const auto& maps = scene["methods"][3];
    EXPECT_EQ(maps["method"], "mip-maps");
    // Mip-maps find what pixels do.
    EXPECT_NEAR(maps["found"], pixels["found"], 0.01);
    EXPECT_NEAR(maps["false_hits"], pixels["false_hits"], 0.01);
    EXPECT_EQ(maps["triangles"], 0);
  }
}

TEST(ReflectionsCommand, PrintsATableOfEachTileAndThickness) {
  const ProgramResult result =
      Reflections({"gallery", "--tiles", "4,32", "--thickness", "0.5", "--markdown"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, testing::HasSubstr("| gallery, "));
  EXPECT_THAT(result.out, testing::HasSubstr("| mesh 32 | 0.50 |"));
  EXPECT_EQ(Reflections({"gallery", "--threads", "1", "--json"}).out,
            Reflections({"gallery", "--threads", "2", "--json"}).out);
}

TEST(ReflectionsCommand, RefusesWhatItCannotJudge) {
  ExpectRefused(Reflections({}), kUsage, "at least one scene");
  ExpectRefused(Reflections({"nowhere"}), kUsage, "nowhere");
  ExpectRefused(Reflections({"street", "--width", "4"}), kUsage, "width is 4");
  ExpectRefused(Reflections({"street", "--frame", "-1"}), kUsage, "frame is -1");
  ExpectRefused(Reflections({"street", "--step", "0"}), kUsage, "step is 0");
  ExpectRefused(Reflections({"street", "--within", "0"}), kUsage, "distance is 0");
  ExpectRefused(Reflections({"street", "--tiles", "2"}), kUsage, "tile is 2");
  ExpectRefused(Reflections({"street", "--tear", "0"}), kUsage, "tear is 0");
  ExpectRefused(Reflections({"street", "--thickness", "-1"}), kUsage, "thickness is -1");
}

}  // namespace
}  // namespace warplut
