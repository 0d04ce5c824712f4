// An interruption leaves whole files, and the same command goes on.
#include <gtest/gtest.h>

#include <filesystem>

#include "luts/fit/fit.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"
#include "tests/tools/test_images.h"

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

TEST(Interruption, StopsATrainingAtACheckpointAndItGoesOn) {
  const TemporaryFolder folder;
  const std::string fit = folder / "fit.json";
  // Many short stages, each of which ends with a checkpoint.
  std::vector<std::string> train = {"train",
                                    "--data",
                                    WriteWavyImage(folder / "image.png", 256, 256),
                                    "--out",
                                    fit,
                                    "--horizons",
                                    "2",
                                    "--crops",
                                    "16",
                                    "--iterations",
                                    "1",
                                    "--stages",
                                    "1000"};
  ExpectRefused(RunWarplut(train, {.standard_output = {}, .signal_when = fit + ".checkpoint"}), 2,
                "--resume");
  EXPECT_FALSE(std::filesystem::exists(fit));

  train.push_back("--resume");
  const ProgramResult again =
      RunWarplut(train, {.standard_output = {}, .signal_when = {}, .signal_after = 100});
  ExpectRefused(again, 2, "--resume");
  train.insert(train.end(), {"--seed", "7"});
  ExpectRefused(RunWarplut(train), 2, "seed is 1 there and 7 here");
  EXPECT_TRUE(std::filesystem::exists(fit + ".checkpoint"));
}

TEST(Interruption, StopsATrainingInsideItsFirstStageAndItGoesOn) {
  const TemporaryFolder folder;
  const std::string image = WriteWavyImage(folder / "image.png", 256, 256);
  const auto train = [&](const std::string& name, const std::vector<std::string>& more = {}) {
    return CommandLine({"train"},
                       {{"--data", image},
                        {"--out", folder / (name + ".json")},
                        {"--name", "fit"},
                        {"--horizons", "2"},
                        {"--crops", "16"},
                        {"--iterations", "12"},
                        {"--stages", "1"},
                        {"--max-seconds", "100000"}},
                       more);
  };
  ASSERT_EQ(RunWarplut(train("whole")).code, 0);
  // The checkpoint is there after the first evaluation.
  ExpectRefused(RunWarplut(train("fit"),
                           {.standard_output = {}, .signal_when = folder / "fit.json.checkpoint"}),
                2, "--resume");
  EXPECT_FALSE(std::filesystem::exists(folder / "fit.json"));
  ASSERT_TRUE(std::filesystem::exists(folder / "fit.json.checkpoint"));
  const ProgramResult resumed = RunWarplut(train("fit", {"--resume", "--max-seconds", "200000"}));
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(ReadFit(folder / "fit.json").parameters, ReadFit(folder / "whole.json").parameters);
}

TEST(Interruption, ATimeLimitIsToldAndALargerOneGoesOn) {
  const TemporaryFolder folder;
  const std::string fit = folder / "fit.json";
  std::vector<std::string> train = {"train",
                                    "--data",
                                    WriteWavyImage(folder / "image.png", 256, 256),
                                    "--out",
                                    fit,
                                    "--horizons",
                                    "2",
                                    "--crops",
                                    "16",
                                    "--stages",
                                    "1",
                                    "--iterations",
                                    "4",
                                    "--max-seconds"};
  train.push_back("0.000001");
  const ProgramResult cut = RunWarplut(train);
  ASSERT_EQ(cut.code, 0) << cut.err;
  EXPECT_NE(cut.out.find("--max-seconds ended the training"), std::string::npos) << cut.out;
  EXPECT_TRUE(ReadFit(fit).cut);
  train.back() = "1000";
  train.push_back("--resume");
  const ProgramResult whole = RunWarplut(train);
  ASSERT_EQ(whole.code, 0) << whole.err;
  EXPECT_EQ(whole.out.find("--max-seconds"), std::string::npos) << whole.out;
  EXPECT_FALSE(ReadFit(fit).cut);
  EXPECT_FALSE(std::filesystem::exists(fit + ".checkpoint"));
}

}  // namespace
}  // namespace warplut
