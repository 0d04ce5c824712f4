#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"
#include "tests/train/replay/pan_sequence.h"

namespace warplut {
namespace {

TEST(ViewCommand, DrawsMethodsAndFolders) {
  const TemporaryFolder folder;
  WritePan(folder / "pan", {.frames = 3});
  const ProgramResult methods =
      RunWarplut({"view", "--sequence", folder / "pan", "--modes", "sr,bilinear", "--filter",
                  "bilinear", "--out", folder / "methods", "--json"});
  ASSERT_EQ(methods.code, 0) << methods.err;
  const auto document = nlohmann::json::parse(methods.out);
  EXPECT_EQ(document["files"].back(), (folder / "methods" / "index.html").string());
  const ProgramResult folders =
      RunWarplut({"view", folder / "methods" / "frames/sr", folder / "methods" / "frames/bilinear",
                  "--reference", folder / "methods" / "frames/reference", "--out",
                  folder / "folders", "--amplify", "8"});
  ASSERT_EQ(folders.code, 0) << folders.err;
  EXPECT_THAT(folders.out, testing::HasSubstr("worst-bilinear.png\n"));
  EXPECT_THAT(folders.out, testing::HasSubstr("Errors in pictures are x 8"));
}

TEST(ViewCommand, RefusesWhatMakesNoSense) {
  const TemporaryFolder folder;
  WritePan(folder / "pan", {.frames = 3});
  ExpectRefused(RunWarplut({"view", "--out", folder / "out"}), kUsage, "two folders");
  ExpectRefused(RunWarplut({"view", folder / "a", "--out", folder / "out"}), kUsage, "1 folder");
  ExpectRefused(RunWarplut({"view", folder / "a", folder / "b", "--out", folder / "out"}), kFailed,
                "a");
  ExpectRefused(RunWarplut({"view", "--sequence", folder / "pan", "--out", folder / "out"}), kUsage,
                "--lut");
  ExpectRefused(RunWarplut({"view", "--sequence", folder / "pan", "--filter", "bilinear", "--out",
                            "/proc/warplut"}),
                kFailed, "cannot write");
}

TEST(ViewCommand, AnInterruptionLeavesNoPage) {
  const TemporaryFolder folder;
  WritePan(folder / "pan", {.frames = 12, .render = {160, 120}, .output = {320, 240}});
  ExpectRefused(RunWarplut({"view", "--sequence", folder / "pan", "--filter", "bilinear", "--out",
                            folder / "out"},
                           {.signal_when = folder / "out" / "frames/sr/0011.png"}),
                kFailed, "interrupted");
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "index.html"));
}

}  // namespace
}  // namespace warplut
