#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"
#include "tests/tools/test_images.h"
#include "tests/train/replay/pan_sequence.h"
#include "tools/judge/images/compare.h"

namespace warplut {
namespace {

TEST(CompareImages, EqualImagesHaveNoError) {
  const Image image = WavyImage(40, 30);
  const FrameScore score = CompareImages("frame", image, image, 0);
  EXPECT_TRUE(std::isinf(score.psnr));
  EXPECT_NEAR(score.ssim, 1, 1e-6);
}

TEST(CompareImages, AnOffsetOfATenthIsTwentyDecibels) {
  const Image image = WavyImage(40, 30);
  Image brighter = image;
  for (float& value : brighter.data) value += 0.1f;
  EXPECT_NEAR(CompareImages("frame", brighter, image, 0).psnr, 20, 1e-4);
}

TEST(CompareImages, TheBorderDoesNotCountAndAlphaNeither) {
  const Image image = WavyImage(40, 30, 4);
  Image other = image;
  for (int x = 0; x < 40; ++x) other.at(x, 0, 1) = 0;
  other.at(20, 15, 3) = 0;
  EXPECT_TRUE(std::isfinite(CompareImages("frame", image, other, 0).psnr));
  EXPECT_TRUE(std::isinf(CompareImages("frame", image, other, 1).psnr));
}

TEST(CompareImages, RefusesWhatCannotBeCompared) {
  const Image image = WavyImage(40, 30);
  ExpectError([&] { CompareImages("frame 7", image, WavyImage(40, 31), 0); },
              {"frame 7", "40 x 30", "40 x 31"});
  ExpectError([&] { CompareImages("frame 7", image, WavyImage(40, 30, 4), 0); },
              {"frame 7", "3 channels", "with 4"});
  ExpectError([&] { CompareImages("frame 7", WavyImage(40, 10), WavyImage(40, 10), 0); },
              {"frame 7", "11 x 11"});
  ExpectError([&] { CompareImages("frame 7", image, image, 10); }, {"frame 7", "31 x 31"});
}

class CompareCommand : public testing::Test {
 protected:
  CompareCommand() {
    for (const char* name : {"a", "b"}) {
      std::filesystem::create_directory(folder_ / name);
      for (const char* frame : {"0.png", "1.png"})
        WriteWavyImage(Folder(name) + "/" + frame, 32, 24);
    }
  }
  std::string Folder(const std::string& name) const { return folder_ / name; }

  const TemporaryFolder folder_;
};

TEST_F(CompareCommand, ScoresEveryFrameAndTheMean) {
  const ProgramResult text = RunWarplut({"compare", Folder("a"), Folder("b")});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_TRUE(text.err.empty()) << text.err;
  EXPECT_THAT(text.out, testing::AllOf(testing::HasSubstr("0.png"), testing::HasSubstr("mean"),
                                       testing::HasSubstr("Compared as stored, border 0.\n")));

  const ProgramResult json = RunWarplut({"compare", Folder("a"), Folder("b"), "--json"});
  const auto document = nlohmann::json::parse(json.out);
  EXPECT_EQ(document["frames"].size(), 2U);
  EXPECT_TRUE(document["mean"]["psnr"].is_null());
  EXPECT_NEAR(document["mean"]["ssim"].get<double>(), 1, 1e-6);
}

TEST_F(CompareCommand, AMissedTargetIsThree) {
  WriteImage(Folder("b") + "/1.png", Image(32, 24, 3), PixelType::kUint8);
  EXPECT_EQ(
      RunWarplut({"compare", Folder("a"), Folder("b"), "--min-psnr", "1", "--min-ssim", "0.99"})
          .code,
      3);
}

TEST_F(CompareCommand, NamesTheFileWithoutAPartner) {
  WriteWavyImage(Folder("b") + "/2.png", 32, 24);
  ExpectRefused(RunWarplut({"compare", Folder("a"), Folder("b")}), 2, "2.png");
  ExpectRefused(RunWarplut({"compare", Folder("b"), Folder("a")}), 2, "2.png");
}

TEST_F(CompareCommand, LinearFramesScoreAsRunScoresThem) {
  WritePan(folder_ / "pan", {.frames = 4, .color_space = ColorSpace::kLinear});
  const ProgramResult run =
      RunWarplut({"run", "--mode", "sr", "--sequence", Folder("pan"), "--filter", "bilinear",
                  "--out", Folder("out"), "--score", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto scores = nlohmann::json::parse(run.out)["scores"];
  EXPECT_THAT(scores["notes"][0].get<std::string>(), testing::HasSubstr("as displayed"));
  // Against the sequence, which says that it is linear, and against files, of which the option says
  // it.
  for (const std::string& against : {Folder("pan"), Folder("pan") + "/hr/color"}) {
    std::vector<std::string> arguments = {"compare",  Folder("out"), against,
                                          "--border", "5",           "--json"};
    if (against != Folder("pan")) arguments.push_back("--linear");
    const ProgramResult compare = RunWarplut(arguments);
    ASSERT_EQ(compare.code, 0) << compare.err;
    const auto document = nlohmann::json::parse(compare.out);
    EXPECT_EQ(document["domain"], "displayed");
    EXPECT_EQ(document["border"], 5);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& judged = scores["methods"][0]["frames"][i];
      EXPECT_NEAR(document["frames"][i + 1]["psnr"].get<double>(), judged["psnr"].get<double>(),
                  1e-6);
      EXPECT_NEAR(document["frames"][i + 1]["ssim"].get<double>(), judged["ssim"].get<double>(),
                  1e-9);
    }
  }
  const ProgramResult stored =
      RunWarplut({"compare", Folder("out"), Folder("pan") + "/hr/color", "--border", "5"});
  EXPECT_THAT(stored.out, testing::HasSubstr("as stored, border 5. Of linear HDR, --linear"));
  ExpectRefused(RunWarplut({"compare", Folder("b"), Folder("b"), "--linear"}), 2, "0.png");
}

}  // namespace
}  // namespace warplut
