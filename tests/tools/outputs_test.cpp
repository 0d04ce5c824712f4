// Results are never lost to a name, and what cannot be written is refused before the work.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "datasets/file.h"
#include "luts/fit/fit.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"
#include "tests/tools/test_images.h"
#include "tests/train/replay/pan_sequence.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Latin-1 for cafe with an accent; as UTF-8 it is not valid.
constexpr const char* kForeign = "caf\xe9";
constexpr const char* kReplaced = "caf\xef\xbf\xbd";

class Outputs : public testing::Test {
 protected:
  std::string Path(const std::string& name) const { return folder_ / name; }

  std::vector<std::string> Train(const std::vector<std::string>& more) const {
    return WithDefaults({"train"},
                        {{"--prefilter", "none"},
                         {"--horizons", "2"},
                         {"--crops", "1"},
                         {"--iterations", "1"},
                         {"--stages", "1"}},
                        more);
  }

  const TemporaryFolder folder_;
};

TEST_F(Outputs, AnImageWithAForeignNameIsTrainedOnAndRecorded) {
  fs::create_directory(Path(kForeign));
  WriteWavyImage(Path(std::string(kForeign) + "/" + kForeign + "\n.png"), 160, 160);
  const std::string out = Path(std::string(kForeign) + "/" + kForeign + ".json");
  const ProgramResult result =
      RunWarplut(Train({"--data", Path(kForeign), "--out", out, "--name", "foreign", "--json"}));
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(nlohmann::json::parse(result.out)["fit"].get<std::string>(), HasSubstr(kReplaced));
  EXPECT_THAT(ReadFit(out).data.at(0).name, HasSubstr(kReplaced));

  const std::string baked = Path(std::string("baked") + kForeign);
  const ProgramResult bake = RunWarplut({"bake", out, "--out", baked, "--json"});
  ASSERT_EQ(bake.code, 0) << bake.err;
  EXPECT_THAT(bake.out, HasSubstr(kReplaced));
  EXPECT_TRUE(fs::exists(baked + "/foreign.json"));
}

TEST_F(Outputs, FramesOfAForeignFolderAreShownAndJudged) {
  WritePan(folder_ / kForeign, {.frames = 2});
  const ProgramResult run =
      RunWarplut({"run", "--mode", "sr", "--sequence", Path(kForeign), "--filter", "bilinear",
                  "--out", Path(std::string("out") + kForeign), "--score", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr(kReplaced));
  fs::rename(Path(std::string("out") + kForeign + "/0010.png"),
             Path(std::string("out") + kForeign + "/" + kForeign + ".png"));
  const ProgramResult compare = RunWarplut({"compare", Path(std::string("out") + kForeign),
                                            Path(std::string("out") + kForeign), "--json"});
  ASSERT_EQ(compare.code, 0) << compare.err;
  EXPECT_THAT(compare.out, HasSubstr(kReplaced));
  const ProgramResult missing =
      RunWarplut({"dataset", "inspect", Path(std::string("none") + kForeign)});
  EXPECT_EQ(missing.code, kFailed);
}

TEST_F(Outputs, WhatCannotBeWrittenIsRefusedBeforeTheWork) {
  const std::string image = WriteWavyImage(Path("a.png"), 160, 160);
  WritePan(folder_ / "pan", {.frames = 3});
  WriteFile(Path("file"), "x");
  fs::create_directory(Path("taken.json"));
  fs::create_directory(Path("b.json.checkpoint"));
  const std::vector<std::string> of_pan = {"--sequence", Path("pan"), "--filter", "bilinear"};
  const auto on_pan = [&](std::vector<std::string> command, std::vector<std::string> more) {
    command.insert(command.end(), of_pan.begin(), of_pan.end());
    command.insert(command.end(), more.begin(), more.end());
    return command;
  };
  // Paths through a file, and into a folder that takes none.
  for (const std::string& folder : {Path("file/sub"), std::string("/proc/warplut")}) {
    const std::string file = folder + "/out.json";
    for (const std::vector<std::string>& command :
         {Train({"--data", Path("none.png"), "--out", file}),
          on_pan({"calibrate"}, {"--out", file, "--frames", "0:0"}),
          on_pan({"profile"}, {"--out", file, "--mode", "sr"}),
          on_pan({"run"}, {"--mode", "sr", "--out", folder}),
          on_pan({"eval"}, {"--pictures", folder}),
          {"eval", "--images", Path("none.png"), "--lut", "none.json", "--pictures", folder},
          {"bake", Path("none.json"), "--out", folder},
          {"dataset", "render", "still", "--out", folder},
          {"report", "--out", folder, "--quick"}}) {
      // Each also has an input that is missing or wrong, which work on the inputs would find.
      const ProgramResult result = RunWarplut(command);
      ExpectRefused(result, kFailed, "cannot write");
      EXPECT_THAT(result.err, HasSubstr(folder));
    }
  }
  ExpectRefused(RunWarplut(Train({"--data", image, "--out", Path("taken.json")})), kFailed,
                "is a folder");
  ExpectRefused(RunWarplut(Train({"--data", image, "--out", Path("b.json")})), kFailed,
                "b.json.checkpoint");
}

TEST_F(Outputs, TrainingTakesLinearSequencesAsDisplayedAndSaysSo) {
  WritePan(folder_ / "scenes" / "pan",
           {.frames = 2, .output = {160, 128}, .color_space = ColorSpace::kLinear});
  const ProgramResult text = RunWarplut(Train({"--data", Path("scenes"), "--out", Path("f.json")}));
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("2 of 2 images are linear HDR"));
  const ProgramResult json =
      RunWarplut(Train({"--data", Path("scenes/pan"), "--out", Path("f.json"), "--json"}));
  ASSERT_EQ(json.code, 0) << json.err;
  EXPECT_EQ(nlohmann::json::parse(json.out)["tone_mapped"], 2);
}

}  // namespace
}  // namespace warplut
