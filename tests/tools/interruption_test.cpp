// An interruption leaves whole files, and the same command goes on.
#include <gtest/gtest.h>

#include <filesystem>

#include "luts/fit/fit.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"
#include "tests/tools/test_images.h"

namespace warplut {
namespace {

// A training on one small image, of these stages and iterations, to `fit`.
std::vector<std::string> Training(const TemporaryFolder& folder, const std::string& fit,
                                  const char* stages, const char* iterations,
                                  const std::vector<std::string>& more = {}) {
  return WithDefaults({"train"},
                      {{"--data", WriteWavyImage(folder / "image.png", 256, 256)},
                       {"--out", fit},
                       {"--name", "fit"},
                       {"--horizons", "2"},
                       {"--crops", "16"},
                       {"--iterations", iterations},
                       {"--stages", stages}},
                      more);
}

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
  std::vector<std::string> train = Training(folder, fit, "1000", "1");
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
  const auto train = [&](const std::string& name, const std::string& limit) {
    return Training(folder, folder / (name + ".json"), "1", "12", {"--max-seconds", limit});
  };
  ASSERT_EQ(RunWarplut(train("whole", "100000")).code, 0);
  // The checkpoint is there after the first evaluation.
  ExpectRefused(RunWarplut(train("fit", "100000"),
                           {.standard_output = {}, .signal_when = folder / "fit.json.checkpoint"}),
                2, "--resume");
  EXPECT_FALSE(std::filesystem::exists(folder / "fit.json"));
  ASSERT_TRUE(std::filesystem::exists(folder / "fit.json.checkpoint"));
  std::vector<std::string> resume = train("fit", "200000");
  resume.push_back("--resume");
  const ProgramResult resumed = RunWarplut(resume);
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(ReadFit(folder / "fit.json").parameters, ReadFit(folder / "whole.json").parameters);
}

TEST(Interruption, ATimeLimitIsToldAndALargerOneGoesOn) {
  const TemporaryFolder folder;
  const std::string fit = folder / "fit.json";
  std::vector<std::string> train = Training(folder, fit, "1", "4", {"--max-seconds", "0.000001"});
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
