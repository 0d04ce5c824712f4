#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "datasets/file.h"
#include "luts/fit/fit.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/luts/test_fits.h"
#include "tests/tools/program.h"
#include "tests/tools/test_images.h"

namespace warplut {
namespace {

// A fit whose residual is zero: Catmull-Rom.
class EvalCommand : public testing::Test {
 protected:
  EvalCommand() {
    WriteFit(Path("zero.json"), MakeFit(0, 1, "zero"));
    WriteWavyImage(Path("image.png"), 80, 72);
  }
  std::string Path(const std::string& name) const { return folder_ / name; }
  std::vector<std::string> Eval(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {
        "eval", "--lut",     Path("zero.json"),      "--images", Path("image.png"), "--warps",
        "2,4",  "--against", "bilinear,catmull-rom", "--json",   "--trajectories",  "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  const TemporaryFolder folder_;
};

TEST_F(EvalCommand, ATableOfCatmullRomScoresLikeIt) {
  const ProgramResult result = RunWarplut(Eval());
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(result.err.empty()) << result.err;
  const auto document = nlohmann::json::parse(result.out);
  ASSERT_EQ(document["protocols"].size(), 6U) << "half, random and pan";
  for (std::size_t i = 0; i < 6; ++i) {
    const double lut = document["judged"]["ssim"][i];
    EXPECT_GT(lut, document["others"][0]["ssim"][i].get<double>()) << "bilinear";
    EXPECT_NEAR(lut, document["others"][1]["ssim"][i].get<double>(), 1e-3) << "catmull-rom";
  }
}

TEST_F(EvalCommand, ComparesWithSplinesAndSixTaps) {
  const std::vector<std::string> against = {"spline:1/84", "o-moms", "kaiser6:4.5", "lanczos3",
                                            "best-spline"};
  const ProgramResult result =
      RunWarplut({"eval", "--lut", Path("zero.json"), "--images", Path("image.png"), "--warps", "2",
                  "--against", "spline:1/84,o-moms,kaiser6:4.5", "lanczos3,best-spline", "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto others = nlohmann::json::parse(result.out)["others"];
  ASSERT_EQ(others.size(), against.size());
  for (std::size_t i = 0; i < against.size(); ++i) {
    EXPECT_EQ(others[i]["filter"], against[i]);
    EXPECT_GT(others[i]["mean"].get<double>(), 0.9) << against[i];
  }
  EXPECT_EQ(others[4]["spline_k"].size(), 3U);
}

TEST_F(EvalCommand, TheSameForAnyNumberOfThreads) {
  EXPECT_EQ(RunWarplut(Eval({"--threads", "1"})).out, RunWarplut(Eval({"--threads", "2"})).out);
}

TEST_F(EvalCommand, BakesThatItReadsBackAndPictures) {
  ASSERT_EQ(RunWarplut({"bake", Path("zero.json"), "--out", Path("baked")}).code, 0);
  for (const char* ending : {".h", ".json", ".exr", ".png"}) {
    EXPECT_TRUE(std::filesystem::exists(Path(std::string("baked/zero") + ending))) << ending;
  }
  for (const char* file : {"baked/zero.json", "baked/zero.exr"}) {
    const ProgramResult result = RunWarplut(
        {"eval", "--lut", Path(file), "--images", Path("image.png"), "--warps", "2", "--offsets",
         "half", "--against", "catmull-rom", "--markdown", "--pictures", Path("pictures")});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_THAT(result.out, testing::StartsWith("| SSIM after | 2 half |"));
  }
  EXPECT_FALSE(std::filesystem::is_empty(Path("pictures")));
}

TEST_F(EvalCommand, AMissedTargetIsThree) {
  EXPECT_EQ(RunWarplut(Eval({"--target", "bilinear,0"})).code, 0);
  EXPECT_EQ(RunWarplut(Eval({"--target", "catmull-rom,0.5,random"})).code, 3);
  EXPECT_EQ(RunWarplut(Eval({"--target", "bilinear,0,mean"})).code, 0);
  EXPECT_EQ(RunWarplut(Eval({"--target", "bilinear,0,pan,2"})).code, 0);
  EXPECT_EQ(RunWarplut(Eval({"--target", "catmull-rom,0.5,mean"})).code, 3);
  ExpectRefused(RunWarplut(Eval({"--target", "best-keys,0"})), 1, "best-keys");
  ExpectRefused(RunWarplut(Eval({"--target", "bilinear"})), 1, "bilinear");
}

TEST_F(EvalCommand, RefusesWhatMakesNoSense) {
  ExpectRefused(RunWarplut(Eval({"--against", "lanczos"})), 1, "lanczos");
  ExpectRefused(RunWarplut(Eval({"--against", "keys:-7"})), 1, "keys:-7");
  ExpectRefused(RunWarplut(Eval({"--against", "spline:1"})), 1, "spline:1");
  ExpectRefused(RunWarplut(Eval({"--warps", "3"})), 1, "--warps has 3");
  ExpectRefused(RunWarplut(Eval({"--warps", "1", "--offsets", "pan"})), 1, "--warps has 1");
  ExpectRefused(RunWarplut(Eval({"--crop", "10"})), 1, "--crop is 10");
  ExpectRefused(RunWarplut(Eval({"--images", WriteWavyImage(Path("small.png"), 42, 60)})), 2,
                "small.png");
  ExpectRefused(RunWarplut(Eval({"--images", Path("image.png")})), 2, "twice");
}

TEST_F(EvalCommand, RefusesABrokenTable) {
  std::string text = ReadFile(Path("zero.json"));
  text.replace(text.find("\"version\""), 9, "\"vorsion\"");
  WriteFile(Path("broken.json"), text);
  ExpectRefused(RunWarplut({"eval", "--lut", Path("broken.json"), "--images", Path("image.png")}),
                2, "broken.json");
}

}  // namespace
}  // namespace warplut
