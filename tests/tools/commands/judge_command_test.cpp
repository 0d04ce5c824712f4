#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "datasets/images/image_io.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"
#include "tests/train/replay/pan_sequence.h"
#include "tools/pictures/sequence_pictures.h"

namespace warplut {
namespace {

using testing::HasSubstr;

class JudgeCommand : public testing::Test {
 protected:
  JudgeCommand() { WritePan(folder_ / "pan"); }
  std::string Path(const std::string& name) const { return folder_ / name; }

  std::vector<std::string> Eval(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"eval", "--sequence", Path("pan"), "--filter",
                                          "catmull-rom"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  const TemporaryFolder folder_;
};

TEST_F(JudgeCommand, PutsBaselinesBesideTheMethods) {
  const ProgramResult result = RunWarplut(Eval({"--modes", "sr,i", "--json"}));
  ASSERT_EQ(result.code, 0) << result.err;
  const auto document = nlohmann::json::parse(result.out);
  const auto& methods = document["sequences"][0]["methods"];
  std::vector<std::string> names;
  for (const auto& method : methods) names.push_back(method["method"]);
  EXPECT_EQ(names,
            (std::vector<std::string>{"sr", "i", "bilinear", "bicubic", "repeat", "average"}));
  EXPECT_GT(methods[0]["psnr"].get<double>(), methods[3]["psnr"].get<double>()) << "bicubic";
  EXPECT_GT(methods[1]["psnr"].get<double>(), methods[5]["psnr"].get<double>()) << "average";
  EXPECT_LT(methods[1]["temporal_error"].get<double>(), methods[4]["temporal_error"].get<double>());
  EXPECT_EQ(methods[0]["frames"].size(), 5U);
  EXPECT_EQ(methods[1]["frames"].size(), 2U);
}

TEST_F(JudgeCommand, PrintsATableForEachSequenceAndTheMean) {
  WritePan(folder_ / "slow", {.speed_x = 0.5});
  const ProgramResult result =
      RunWarplut({"judge", "--sequence", Path("pan"), Path("slow"), "--modes", "sr-sample",
                  "--filter", "bilinear", "--texels", "--markdown"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("| pan, texels | PSNR dB | SSIM | temporal | ms/frame |"));
  EXPECT_THAT(result.out, HasSubstr("| mean |"));
  EXPECT_THAT(result.out, HasSubstr("| sr-sample |"));
}

TEST_F(JudgeCommand, PrintsSettledMeansBesideThoseOfAllFrames) {
  const ProgramResult result = RunWarplut(Eval({"--modes", "sr", "--settled", "2", "--json"}));
  ASSERT_EQ(result.code, 0) << result.err;
  const auto sr = nlohmann::json::parse(result.out)["sequences"][0]["methods"][0];
  ASSERT_EQ(sr["frames"].size(), 5U);
  double sum = 0;
  for (int i = 2; i < 5; ++i) sum += sr["frames"][i]["ssim"].get<double>();
  EXPECT_NEAR(sr["settled"]["ssim"].get<double>(), sum / 3, 1e-12);
  EXPECT_EQ(sr["settled"]["left_out"], 2);
  EXPECT_THAT(RunWarplut(Eval({"--settled", "2", "--markdown"})).out, HasSubstr("without 2: PSNR"));
  ExpectRefused(RunWarplut(Eval({"--settled", "5"})), 2, "leaves out 5 frames");
  ExpectRefused(RunWarplut(Eval({"--settled", "0"})), 1, "");
}

TEST_F(JudgeCommand, AMissedTargetIsThree) {
  EXPECT_EQ(RunWarplut(Eval({"--target", "sr,20,.5"})).code, 0);
  const ProgramResult missed = RunWarplut(Eval({"--target", "sr,99,.5"}));
  EXPECT_EQ(missed.code, 3);
  EXPECT_THAT(missed.out, HasSubstr("missed: sr on pan"));
  ExpectRefused(RunWarplut(Eval({"--target", "i,20,.5"})), 1, "'i,20,.5'");
  ExpectRefused(RunWarplut(Eval({"--target", "sr,20"})), 1, "METHOD,PSNR,SSIM");
}

TEST_F(JudgeCommand, WritesPictures) {
  const ProgramResult result = RunWarplut(Eval({"--modes", "sr", "--pictures", Path("pictures")}));
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("-error.png: reference | sr | bilinear | bicubic"));
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(Path("pictures"))) {
    const ImageInfo info = ReadImageInfo(entry.path());
    EXPECT_EQ(info.width, 4 * 80 * kWindowZoom + 3 * kPicturePanelGap);
    EXPECT_EQ(info.height, 64 * kWindowZoom);
    ++pictures;
  }
  EXPECT_GE(pictures, kWindowsOfAKind);
}

TEST_F(JudgeCommand, SaysWhatPays) {
  const std::vector<std::string> judge = {"judge",       "--sequence", Path("pan"),
                                          "--modes",     "sr",         "--filter",
                                          "catmull-rom", "--against",  "bilinear,taau"};
  std::vector<std::string> as_json = judge, as_markdown = judge;
  as_json.emplace_back("--json");
  const ProgramResult result = RunWarplut(as_json);
  ASSERT_EQ(result.code, 0) << result.err;
  const auto document = nlohmann::json::parse(result.out);
  const auto& payoff = document["payoff"];
  ASSERT_EQ(payoff["tables"].size(), 1U);
  EXPECT_EQ(payoff["tables"][0]["rows"].size(), document["sequences"][0]["methods"].size());
  EXPECT_EQ(payoff["verdicts"][0]["name"], "catmull-rom");
  EXPECT_EQ(payoff["verdicts"][0]["against"], "sr with bilinear");
  as_markdown.emplace_back("--markdown");
  EXPECT_THAT(RunWarplut(as_markdown).out,
              testing::AllOf(HasSubstr("| pan | PSNR dB | SSIM | temporal | dPSNR | +- | dSSIM |"),
                             HasSubstr("| sr without color-box |"), HasSubstr("| taau |"),
                             HasSubstr("- The pass color-box")));
  ExpectRefused(RunWarplut({"judge", "--sequence", Path("pan"), "--filter", "bilinear", "--against",
                            "none.json"}),
                1, "'none.json'");
}

TEST_F(JudgeCommand, NeedsOfReferencesTheirColourAlone) {
  const Streams streams = Streams::kRenderGrid | Streams::kReference;
  WritePan(folder_ / "bare", {.streams = streams});
  const auto eval = [&](const std::string& modes, const std::string& sequence,
                        const std::vector<std::string>& more = {}) {
    return RunWarplut(
        WithDefaults({"judge", "--sequence", Path(sequence), "--filter", "catmull-rom"},
                     {{"--modes", modes}}, more));
  };
  const ProgramResult bare = eval("sr,i", "bare", {"--json"});
  ASSERT_EQ(bare.code, 0) << bare.err;
  const auto sequence = nlohmann::json::parse(bare.out)["sequences"][0];
  const auto full =
      nlohmann::json::parse(eval("sr", "pan", {"--json"}).out)["sequences"][0]["methods"][0];
  const auto& sr = sequence["methods"][0];
  EXPECT_EQ(sr["psnr"], full["psnr"]);
  EXPECT_EQ(sr["ssim"], full["ssim"]);
  EXPECT_TRUE(sr["temporal_error"].is_null());
  EXPECT_TRUE(full["temporal_error"].is_number());
  const auto& i = sequence["methods"][1];
  EXPECT_EQ(i["frames"].size(), 2U);
  EXPECT_GT(i["psnr"].get<double>(), 10);
  EXPECT_TRUE(i["temporal_error"].is_number()) << "the render grid has depth and motion";
  ASSERT_EQ(sequence["notes"].size(), 2U);
  EXPECT_THAT(sequence["notes"][0].get<std::string>(),
              testing::AllOf(HasSubstr("no reference_depth and reference_motion"),
                             HasSubstr("for sr, bilinear, bicubic")));
  EXPECT_THAT(sequence["notes"][1].get<std::string>(), HasSubstr("i, repeat, average are made"));
  EXPECT_THAT(eval("sr", "bare").out, HasSubstr("no temporal error"));
  EXPECT_EQ(eval("sr,i", "bare", {"--pictures", Path("pictures")}).code, 0);
  EXPECT_EQ(RunWarplut({"run", "--mode", "i", "--every", "2", "--score", "--sequence", Path("bare"),
                        "--filter", "bilinear", "--out", Path("out")})
                .code,
            0);
}

TEST_F(JudgeCommand, JudgesGenerationWithoutReferencesByRenderedFrames) {
  // Without jitter the rendered frames of a pan are true frames of one pan.
  WritePan(folder_ / "blind", {.streams = Streams::kRenderGrid, .jitter = false});
  const ProgramResult result = RunWarplut(
      {"judge", "--sequence", Path("blind"), "--filter", "catmull-rom", "--modes", "i", "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto methods = nlohmann::json::parse(result.out)["sequences"][0]["methods"];
  EXPECT_GT(methods[0]["psnr"].get<double>(), methods[2]["psnr"].get<double>()) << "average";
}

TEST_F(JudgeCommand, IsWhatEvalDoesOnSequences) {
  const auto methods = [&](const char* command) {
    const ProgramResult result = RunWarplut(
        {command, "--sequence", Path("pan"), "--filter", "bilinear", "--modes", "sr", "--json"});
    EXPECT_EQ(result.code, 0) << result.err;
    return nlohmann::json::parse(result.out)["sequences"][0]["methods"];
  };
  const auto judge = methods("judge"), eval = methods("eval");
  ASSERT_EQ(judge.size(), 3U);
  ASSERT_EQ(eval.size(), 3U);
  for (std::size_t i = 0; i < judge.size(); ++i) {
    EXPECT_EQ(judge[i]["psnr"], eval[i]["psnr"]);
    EXPECT_EQ(judge[i]["ssim"], eval[i]["ssim"]);
  }
}

TEST_F(JudgeCommand, RefusesWhatMakesNoSense) {
  ExpectRefused(RunWarplut({"judge", "--filter", "bilinear"}), 1, "--sequence");
  ExpectRefused(RunWarplut({"eval"}), 1, "--images or --sequence");
  ExpectRefused(RunWarplut({"eval", "--images", Path("pan")}), 1, "--lut");
  ExpectRefused(RunWarplut({"eval", "--images", Path("pan"), "--settled", "1"}), 1, "--sequence");
  ExpectRefused(RunWarplut(Eval({"--images", Path("pan")})), 1, "");
  ExpectRefused(RunWarplut(Eval({"--modes", "sr,srr"})), 1, "'srr'");
  ExpectRefused(RunWarplut(Eval({"--every", "1"})), 1, "");
  ExpectRefused(RunWarplut(Eval({"--border", "30"})), 2, "border of 30");
  ExpectRefused(RunWarplut(Eval({"--frames", "10:10"})), 2, "showed no frame");
  WritePan(folder_ / "blind", {.streams = Streams::kRenderGrid});
  ExpectRefused(RunWarplut({"judge", "--sequence", Path("blind"), "--filter", "bilinear"}), 2,
                "'reference'");
  WritePan(folder_ / "odd", {.output = {60, 64}});
  ExpectRefused(
      RunWarplut({"judge", "--sequence", Path("odd"), "--filter", "bilinear", "--texels"}), 2,
      "whole scale");
}

}  // namespace
}  // namespace warplut
