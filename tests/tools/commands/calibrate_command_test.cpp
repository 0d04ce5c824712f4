#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "datasets/file.h"
#include "runtime/parameters.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"
#include "tests/train/replay/pan_sequence.h"
#include "train/replay/parameters_file.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CalibrateCommand : public testing::Test {
 protected:
  // One rendered sequence for all tests.
  static void SetUpTestSuite() {
    scenes_ = std::make_unique<TemporaryFolder>();
    const ProgramResult rendered =
        RunWarplut({"dataset", "render", "street", "--out", *scenes_ / "", "--width", "64",
                    "--height", "48", "--scale", "2", "--frames", "4"});
    ASSERT_EQ(rendered.code, 0) << rendered.err;
  }
  static void TearDownTestSuite() { scenes_.reset(); }

  std::string Path(const std::string& name) const { return folder_ / name; }
  static std::string Street() { return *scenes_ / "street"; }
  std::string Out() const { return Path("params.json"); }

  std::vector<std::string> Arguments(const std::vector<std::string>& more = {}) const {
    return WithDefaults({"calibrate"},
                        {{"--sequence", Street()},
                         {"--filter", "catmull-rom"},
                         {"--starts", "0"},
                         {"--fit", "sr_depth_threshold,blend_a"},
                         {"--out", Out()}},
                        more);
  }

  static std::unique_ptr<TemporaryFolder> scenes_;
  const TemporaryFolder folder_;
};

std::unique_ptr<TemporaryFolder> CalibrateCommand::scenes_;

TEST_F(CalibrateCommand, WritesParametersThatRunAccepts) {
  const ProgramResult result = RunWarplut(Arguments());
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("params.json: "));
  EXPECT_THAT(result.out, HasSubstr("No clip is held out"));
  EXPECT_FALSE(fs::exists(Out() + ".checkpoint"));
  const Parameters fitted = ReadParameters(Out());
  EXPECT_EQ(fitted.blend_b, Parameters{}.blend_b) << "not fitted";
  const auto calibration = nlohmann::json::parse(ReadFile(Out()))["calibration"];
  const auto& loss = calibration["loss"]["fitted"];
  EXPECT_LE(loss["calibrated"].get<double>(), loss["default"].get<double>());
  EXPECT_LE(loss["calibrated"].get<double>(), loss["paper"].get<double>());
  ASSERT_EQ(calibration["fitted"].size(), 2U);
  EXPECT_FLOAT_EQ(calibration["fitted"][1]["value"].get<float>(), fitted.blend_a);
  EXPECT_NEAR(loss["calibrated"].get<double>(), calibration["loss"]["kept"].get<double>(), 1e-6);
  EXPECT_LE(calibration["loss"]["optimum"].get<double>(),
            calibration["loss"]["kept"].get<double>());

  const ProgramResult run = RunWarplut({"run", "--mode", "sr", "--sequence", Street(), "--filter",
                                        "catmull-rom", "--params", Out(), "--out", Path("shown")});
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST_F(CalibrateCommand, JudgesByWhatIsHeldOut) {
  WritePan(folder_ / "pan");
  const ProgramResult held =
      RunWarplut(Arguments({"--sequence", Street(), Path("pan"), "--hold-out", "pan", "--json"}));
  ASSERT_EQ(held.code, 0) << held.err;
  const auto document = nlohmann::json::parse(held.out);
  EXPECT_EQ(document["parameters"], Out());
  EXPECT_TRUE(document["calibration"]["loss"].contains("held_out"));
  EXPECT_EQ(document["calibration"]["clips"][1]["clip"], "pan");
  EXPECT_EQ(document["calibration"]["clips"][1]["held_out"], true);

  const ProgramResult split =
      RunWarplut(Arguments({"--sequence", Path("pan"), "--modes", "isr", "--fit",
                            "generation_depth_threshold", "--split-frames", "--json"}));
  ASSERT_EQ(split.code, 0) << split.err;
  EXPECT_EQ(nlohmann::json::parse(split.out)["calibration"]["clips"].size(), 2U);
}

TEST_F(CalibrateCommand, KeepsTheOptimumIfAskedTo) {
  const ProgramResult near = RunWarplut(Arguments({"--fit", "blend_a,clamp_gamma", "--json"}));
  ASSERT_EQ(near.code, 0) << near.err;
  const ProgramResult optimum =
      RunWarplut(Arguments({"--fit", "blend_a,clamp_gamma", "--keep", "optimum", "--json"}));
  ASSERT_EQ(optimum.code, 0) << optimum.err;
  const auto of_near = nlohmann::json::parse(near.out)["calibration"];
  const auto of_optimum = nlohmann::json::parse(optimum.out)["calibration"];
  EXPECT_EQ(of_near["loss"]["optimum"], of_optimum["loss"]["optimum"]);
  EXPECT_EQ(of_optimum["loss"]["kept"], of_optimum["loss"]["optimum"]);
  EXPECT_NE(of_near["loss"]["kept"], of_near["loss"]["optimum"]);
  EXPECT_EQ(of_optimum["fitted"][1]["value"], of_near["fitted"][1]["optimum"]);
  ExpectRefused(RunWarplut(Arguments({"--keep", "nothing"})), kUsage, "--keep");
}

TEST_F(CalibrateCommand, GoesOnWithTheSameBytesAfterAnInterruption) {
  ASSERT_EQ(RunWarplut(Arguments()).code, 0);
  const std::string out = Path("again/params.json");
  const ProgramResult stopped = RunWarplut(
      Arguments({"--out", out}), {.standard_output = {}, .signal_when = out + ".checkpoint"});
  ExpectRefused(stopped, kFailed, "--resume");
  EXPECT_FALSE(fs::exists(out));
  const ProgramResult resumed = RunWarplut(Arguments({"--out", out, "--resume"}));
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(ReadFile(out), ReadFile(Out()));
  EXPECT_FALSE(fs::exists(out + ".checkpoint"));
}

TEST_F(CalibrateCommand, ATimeLimitLeavesTheBestSoFarAndACheckpoint) {
  const ProgramResult limited = RunWarplut(Arguments({"--max-seconds", "1e-9"}));
  ASSERT_EQ(limited.code, 0) << limited.err;
  EXPECT_THAT(limited.out, HasSubstr("The time limit ended the work: 0 of 2 starts"));
  EXPECT_THAT(limited.out, HasSubstr("Kept are the defaults"));
  EXPECT_THAT(limited.out, HasSubstr("best so far"));
  for (const char* unknown : {"0.00000", "inf", "nan", "does not tell", "optima", "One optimum"}) {
    EXPECT_THAT(limited.out, testing::Not(HasSubstr(unknown)));
  }
  const auto calibration = nlohmann::json::parse(ReadFile(Out()))["calibration"];
  EXPECT_EQ(calibration["ended"], "time limit");
  EXPECT_EQ(calibration["kept_is_judged"], false);
  EXPECT_TRUE(calibration["loss"]["standard_error"].is_null());
  EXPECT_EQ(ReadParameters(Out()), Parameters());
  EXPECT_TRUE(ReadParameters(Out()).IsValid());
  EXPECT_TRUE(fs::exists(Out() + ".checkpoint"));
  ExpectRefused(RunWarplut(Arguments({"--resume", "--seed", "7"})), kFailed, "other options");
}

TEST_F(CalibrateCommand, TheSameFileForAnyNumberOfThreads) {
  ASSERT_EQ(RunWarplut(Arguments({"--threads", "1"})).code, 0);
  ASSERT_EQ(RunWarplut(Arguments({"--threads", "3", "--out", Path("three.json")})).code, 0);
  EXPECT_EQ(ReadFile(Out()), ReadFile(Path("three.json")));
}

// A clip for super resolution and one for generation, of which the limit lets one stay.
TEST_F(CalibrateCommand, TheSameFileHoweverFewClipsAreInMemory) {
  const auto calibrate = [&](const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> all = {"--modes", "sr,i", "--out", Path(out)};
    all.insert(all.end(), more.begin(), more.end());
    const ProgramResult result = RunWarplut(Arguments(all));
    EXPECT_EQ(result.code, 0) << result.err;
    nlohmann::json json = nlohmann::json::parse(ReadFile(Path(out)));
    json["calibration"].erase("seconds");
    return json;
  };
  EXPECT_EQ(calibrate("all.json", {}), calibrate("few.json", {"--memory", "200K"}));
  ExpectRefused(RunWarplut(Arguments({"--memory", "9K"})), kFailed, "the limit of 9 KiB");
  ExpectRefused(RunWarplut(Arguments({"--memory", "much"})), kUsage, "'much'");
}

TEST_F(CalibrateCommand, RefusesWhatMakesNoSense) {
  ExpectRefused(RunWarplut(Arguments({"--modes", "srr"})), kUsage, "'srr' is not a method");
  ExpectRefused(RunWarplut(Arguments({"--modes", "sr-paper"})), kUsage,
                "sr-paper has no parameters to calibrate");
  ExpectRefused(RunWarplut(Arguments({"--modes", "bicubic"})), kUsage, "bicubic has no parameters");
  ExpectRefused(RunWarplut(Arguments({"--modes", "sr,sr"})), kUsage, "sr twice");
  ExpectRefused(RunWarplut(Arguments({"--fit", "blend_c"})), kUsage, "'blend_c'");
  ExpectRefused(RunWarplut(Arguments({"--fit", "brightness_threshold"})), kUsage,
                "brightness_threshold, which none of the modes reads");
  ExpectRefused(RunWarplut(Arguments({"--hold-out", "harbour"})), kUsage, "'harbour'");
  ExpectRefused(RunWarplut(Arguments({"--hold-out", "street"})), kUsage, "every clip is held out");
  ExpectRefused(RunWarplut(Arguments({"--hold-out", "street", "--split-frames"})), kUsage, "");
  ExpectRefused(RunWarplut(Arguments({"--every", "1"})), kUsage, "--every");
  ExpectRefused(RunWarplut(Arguments({"--max-pixels", "-3"})), kUsage, "--max-pixels");
  EXPECT_FALSE(fs::exists(Out()));
}

TEST_F(CalibrateCommand, RefusesWhatCannotBeJudged) {
  WritePan(folder_ / "blind", {.streams = Streams::kRenderGrid});
  ExpectRefused(RunWarplut(Arguments({"--sequence", Path("blind")})), kFailed, "'reference'");
  ExpectRefused(RunWarplut(Arguments({"--sequence", Street(), Street()})), kFailed,
                "two sequences have the name 'street'");
  ExpectRefused(RunWarplut(Arguments({"--sequence", Path("nowhere")})), kFailed, "nowhere");
  ExpectRefused(RunWarplut(Arguments({"--max-frames", "1"})), kFailed, "1 frames");
  ExpectRefused(RunWarplut(Arguments({"--max-pixels", "50"})), kFailed, "50 pixels");
  EXPECT_FALSE(fs::exists(Out()));
}

TEST_F(CalibrateCommand, FitsGenerationToRenderedFramesThatItDidNotSee) {
  for (const Streams more : {Streams::kNone, Streams::kReference}) {
    WritePan(folder_ / "bare", {.streams = Streams::kRenderGrid | more, .jitter = false});
    const ProgramResult result =
        RunWarplut(Arguments({"--sequence", Path("bare"), "--modes", "i", "--fit",
                              "generation_depth_threshold", "--json"}));
    ASSERT_EQ(result.code, 0) << result.err;
    const auto clip = nlohmann::json::parse(result.out)["calibration"]["clips"][0];
    EXPECT_GT(clip["ssim"]["calibrated"].get<double>(), 0.5);
    std::filesystem::remove_all(Path("bare"));
  }
}

TEST_F(CalibrateCommand, RefusesAnOutputThatCannotBeWritten) {
  WriteFile(Path("file"), "");
  ExpectRefused(RunWarplut(Arguments({"--out", Path("file/params.json")})), kFailed, "file");
  const ProgramResult full =
      RunWarplut(Arguments(), {.standard_output = {}, .file_size_limit = 500, .signal_when = {}});
  ExpectRefused(full, kFailed, "params.json");
  EXPECT_FALSE(fs::exists(Out()));
}

}  // namespace
}  // namespace warplut
