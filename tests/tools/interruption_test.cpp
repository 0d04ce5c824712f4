// An interruption leaves whole files, and the same command goes on.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"

namespace warplut {
namespace {

TEST(Interruption, StopsARenderingBetweenFramesAndGoesOn) {
  const TemporaryFolder folder;
  const std::vector<std::string> render = {
      "dataset", "render",    "still",    "--out",     folder.path(),
      "--width", "64",        "--height", "48",        "--frames",
      "40",      "--samples", "4",        "--streams", "color,reference"};
  const std::filesystem::path scene = folder / "still";
  const ProgramResult stopped = RunWarplut(
      render, {.standard_output = {}, .signal_when = scene / "hr" / "color" / "0000.png"});
  ExpectRefused(stopped, 2, "interrupted");
  EXPECT_FALSE(std::filesystem::exists(scene / "sequence.json"));
  for (const auto& entry : std::filesystem::directory_iterator(scene / "hr" / "color")) {
    EXPECT_NE(entry.path().filename().string().front(), '.')
        << "a temporary file stayed: " << entry.path();
  }

  EXPECT_EQ(RunWarplut(render).code, 0);
  EXPECT_EQ(RunWarplut({"dataset", "inspect", scene.string()}).code, 0);
}

}  // namespace
}  // namespace warplut
