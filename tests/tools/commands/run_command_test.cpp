#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "luts/fit/fit.h"
#include "runtime/color_encoding.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/luts/test_fits.h"
#include "tests/tools/program.h"
#include "tests/train/replay/pan_sequence.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class RunCommand : public testing::Test {
 protected:
  RunCommand() { WritePan(folder_ / "pan"); }
  std::string Path(const std::string& name) const { return folder_ / name; }

  std::vector<std::string> Arguments(const std::string& mode,
                                     const std::vector<std::string>& more = {}) const {
    return WithDefaults(
        {"run", "--mode", mode},
        {{"--sequence", Path("pan")}, {"--filter", "catmull-rom"}, {"--out", Path("out")}}, more);
  }

  std::set<std::string> Files(const std::string& name) const {
    std::set<std::string> files;
    for (const auto& entry : fs::directory_iterator(Path(name))) {
      files.insert(entry.path().filename().string());
    }
    return files;
  }

  // With the manifest's text changed.
  void Rewrite(const std::string& from, const std::string& to) const {
    const fs::path manifest = folder_ / "pan" / "sequence.json";
    std::string text = ReadFile(manifest);
    const auto place = text.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    WriteFile(manifest, text);
  }

  const TemporaryFolder folder_;
};

TEST_F(RunCommand, WritesSuperResolvedFrames) {
  const ProgramResult result = RunWarplut(Arguments("sr"));
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(result.err.empty()) << result.err;
  EXPECT_THAT(result.out, HasSubstr("6 frames of pan"));
  EXPECT_EQ(Files("out"), (std::set<std::string>{"0010.png", "0011.png", "0012.png", "0013.png",
                                                 "0014.png", "0015.png"}));
  const ImageInfo info = ReadImageInfo(Path("out/0015.png"));
  EXPECT_EQ(info.width, 80);
  EXPECT_EQ(info.bits, 8);
}

// The HUD of the pan has white stripes on a bar that halves what is behind it.
TEST_F(RunCommand, DrawsTheHudOverEveryFrame) {
  const PanOptions plain = {.frames = 3};
  WritePan(folder_ / "plain", plain);
  PanOptions pan = plain;
  pan.streams = Streams::kAll | Streams::kHud;
  WritePan(folder_ / "hud", pan);
  for (const std::string name : {"plain", "hud"}) {
    const ProgramResult result =
        RunWarplut({"run", "--mode", "isr", "--filter", "catmull-rom", "--sequence", Path(name),
                    "--out", Path("out-" + name)});
    ASSERT_EQ(result.code, 0) << result.err;
  }
  for (const std::string file : {"0010.png", "0010_500.png", "0012.png"}) {
    const Image without = ReadImage(Path("out-plain/" + file));
    const Image with = ReadImage(Path("out-hud/" + file));
    EXPECT_EQ(with.at(5, 5, 1), without.at(5, 5, 1)) << file;
    EXPECT_EQ(with.at(30, 33, 1), 1) << file;
    EXPECT_NEAR(with.at(31, 33, 1), 0.5 * without.at(31, 33, 1), 1.01 / 255) << file;
  }
}

TEST_F(RunCommand, RefusesADeviceThatThereIsNot) {
  ExpectRefused(RunWarplut(Arguments("sr", {"--device", "abacus"})), kUsage, "--device");
  EXPECT_FALSE(fs::exists(Path("out")));
}

TEST_F(RunCommand, TellsOfInfiniteLinearColour) {
  const Sequence sequence =
      WritePan(folder_ / "bright", {.frames = 3, .color_space = ColorSpace::kLinear});
  const auto rewrite = [&](float value) {
    for (int index = 0; index < sequence.count; ++index) {
      const auto file = FrameFiles(sequence, index, Streams::kColor).front();
      Image image = ReadImage(file, {}, Values::kAll);
      for (int c = 0; c < 3; ++c) image.at(5, 5, c) = value;
      WriteImage(file, image, PixelType::kHalf);
    }
  };
  std::vector<std::string> shown;
  for (const float value : {std::numeric_limits<float>::infinity(), kLargestHdr}) {
    rewrite(value);
    const ProgramResult result =
        RunWarplut(Arguments("sr", {"--sequence", Path("bright"), "--score"}));
    ASSERT_EQ(result.code, 0) << result.err;
    shown.push_back(ReadFile(folder_ / "out" / "0012.exr"));
    if (value == kLargestHdr) {
      EXPECT_TRUE(result.err.empty()) << result.err;
    } else {
      EXPECT_EQ(result.err,
                "warplut: warning: 9 channels of the linear colour of 'pan' are infinite or beyond "
                "65504; above they count as that, below as 0.\n");
    }
  }
  EXPECT_EQ(shown[0], shown[1]);
  rewrite(std::numeric_limits<float>::quiet_NaN());
  ExpectRefused(RunWarplut(Arguments("sr", {"--sequence", Path("bright")})), kFailed, "nan");
}

TEST_F(RunCommand, NamesGeneratedFramesByTheirTime) {
  ASSERT_EQ(RunWarplut(Arguments("i", {"--every", "2", "--format", "exr"})).code, 0);
  EXPECT_EQ(Files("out"),
            (std::set<std::string>{"0010.exr", "0011.exr", "0012.exr", "0013.exr", "0014.exr"}));
  EXPECT_EQ(ReadImageInfo(Path("out/0011.exr")).bits, 16);
  const ProgramResult result = RunWarplut(Arguments(
      "isr", {"--out", Path("two"), "--frames", "12:13", "--alpha", "0.25,0.5", "--json"}));
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(Files("two"),
            (std::set<std::string>{"0012.png", "0012_250.png", "0012_500.png", "0013.png"}));
  EXPECT_EQ(nlohmann::json::parse(result.out)["files"][1], "0012_250.png");
}

TEST_F(RunCommand, ScoresWhatItWrites) {
  const ProgramResult text = RunWarplut(Arguments("i", {"--every", "2", "--score"}));
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("0013"));
  EXPECT_THAT(text.out, HasSubstr("mean"));
  const ProgramResult json =
      RunWarplut(Arguments("sr", {"--score", "--json", "--motion-filter", "on", "--history",
                                  "rgba32f", "--texels", "--threads", "1"}));
  ASSERT_EQ(json.code, 0) << json.err;
  const auto document = nlohmann::json::parse(json.out);
  EXPECT_EQ(document["filter"], "catmull-rom");
  EXPECT_EQ(document["files"].size(), 6U);
  EXPECT_GT(document["scores"]["methods"][0]["psnr"].get<double>(), 20);
  EXPECT_THAT(RunWarplut(Arguments("sr", {"--score", "--settled", "3"})).out,
              HasSubstr("mean without 3"));
  ExpectRefused(RunWarplut(Arguments("sr", {"--score", "--settled", "5"})), kFailed,
                "leaves out 5 frames");
  ExpectRefused(RunWarplut(Arguments("sr", {"--settled", "3"})), kUsage, "--score");
  ExpectRefused(RunWarplut(Arguments("i", {"--score"})), kFailed, "showed no frame");
}

TEST_F(RunCommand, TakesSeveralModesEachIntoItsFolder) {
  const ProgramResult result = RunWarplut(Arguments("sr,i", {"--every", "2", "--score", "--json"}));
  ASSERT_EQ(result.code, 0) << result.err;
  const auto modes = nlohmann::json::parse(result.out)["modes"];
  EXPECT_EQ(modes["sr"]["files"].size(), 3U);
  EXPECT_EQ(modes["i"]["files"].size(), 5U);
  EXPECT_GT(modes["i"]["scores"]["methods"][0]["psnr"].get<double>(), 20);
  EXPECT_EQ(modes["sr"]["out"], Path("out/sr"));
  ASSERT_EQ(RunWarplut(Arguments("i", {"--every", "2", "--out", Path("alone")})).code, 0);
  EXPECT_EQ(Files("out/i"), Files("alone"));
  for (const std::string& file : Files("alone")) {
    EXPECT_EQ(ReadFile(Path("out/i/" + file)), ReadFile(Path("alone/" + file))) << file;
  }
  EXPECT_THAT(RunWarplut(Arguments("sr,sr-sample")).out,
              testing::AllOf(HasSubstr(Path("out/sr") + "\n"), HasSubstr("out/sr-sample")));
  ExpectRefused(RunWarplut(Arguments("sr,i,sr")), kUsage, "--mode has sr twice");
}

TEST_F(RunCommand, WarnsOfTheScaleOnlyWhereAHistoryIsKept) {
  WriteFit(folder_ / "fit.json", MakeFit(0, 1, "fit"));  // for x2
  WritePan(folder_ / "x1", {.output = {40, 32}});
  const auto run = [&](const std::string& mode) {
    return RunWarplut({"run", "--mode", mode, "--every", "2", "--sequence", Path("x1"), "--lut",
                       Path("fit.json"), "--out", Path("out")});
  };
  const ProgramResult sr = run("sr"), i = run("i");
  EXPECT_EQ(sr.code, 0) << sr.err;
  EXPECT_THAT(sr.err, HasSubstr("was fitted for x2"));
  EXPECT_EQ(i.code, 0);
  EXPECT_TRUE(i.err.empty()) << i.err;
}

TEST_F(RunCommand, TheSameFilesForAnyNumberOfThreads) {
  ASSERT_EQ(RunWarplut(Arguments("esr", {"--threads", "1"})).code, 0);
  ASSERT_EQ(RunWarplut(Arguments("esr", {"--threads", "3", "--out", Path("three")})).code, 0);
  for (const std::string& file : Files("out")) {
    EXPECT_EQ(ReadFile(Path("out/" + file)), ReadFile(Path("three/" + file))) << file;
  }
}

TEST_F(RunCommand, RefusesWhatMakesNoSense) {
  ExpectRefused(RunWarplut(Arguments("srr")), kUsage, "'srr' is not a method");
  ExpectRefused(RunWarplut(Arguments("sr", {"--lut", "a.json"})), kUsage, "--lut FILE or --filter");
  ExpectRefused(
      RunWarplut({"run", "--mode", "sr", "--sequence", Path("pan"), "--out", Path("out")}), kUsage,
      "--lut FILE or --filter");
  for (const char* command : {"run", "profile", "eval", "calibrate"}) {
    const std::string option =
        std::string(command) == "run" || std::string(command) == "profile" ? "--mode" : "--modes";
    std::vector<std::string> line = {command, option, "srr", "--sequence", Path("pan")};
    if (std::string(command) != "eval") line.insert(line.end(), {"--out", Path("out")});
    ExpectRefused(RunWarplut(line), kUsage, "'srr' is not a method");
  }
  ExpectRefused(RunWarplut(Arguments("i", {"--alpha", "0"})), kUsage, "alpha is 0");
  ExpectRefused(RunWarplut(Arguments("i", {"--alpha", "1.5"})), kUsage, "alpha is 1.5");
  ExpectRefused(RunWarplut(Arguments("i", {"--alpha", ".5,.2"})), kUsage, "ascending");
  ExpectRefused(RunWarplut(Arguments("i", {"--alpha", ".5", "--generated", "2"})), kUsage, "");
  ExpectRefused(RunWarplut(Arguments("i", {"--generated", "0"})), kUsage, "generated is 0");
  ExpectRefused(RunWarplut(Arguments("i", {"--every", "0"})), kUsage, "");
  ExpectRefused(RunWarplut(Arguments("sr", {"--history", "rgb"})), kUsage, "rgb");
  ExpectRefused(RunWarplut(Arguments("sr", {"--motion-filter", "maybe"})), kUsage, "maybe");
  ExpectRefused(RunWarplut(Arguments("sr", {"--frames", "12"})), kFailed, "A:B");
  ExpectRefused(RunWarplut(Arguments("sr", {"--frames", "9:12"})), kFailed, "frames 10 to 15");
  ExpectRefused(RunWarplut(Arguments("i", {"--frames", "12:12"})), kFailed, "needs two");
  EXPECT_FALSE(fs::exists(Path("out")));
}

TEST_F(RunCommand, RefusesDamagedInputs) {
  WriteFile(Path("params.json"),
            R"({"format": "warplut-parameters", "version": 1, "parameters": {"blend_b": 17}})");
  ExpectRefused(RunWarplut(Arguments("sr", {"--params", Path("params.json")})), kFailed, "blend_b");
  ExpectRefused(RunWarplut(Arguments("sr", {"--params", Path("none.json")})), kFailed, "none.json");
  ExpectRefused(RunWarplut(Arguments("sr", {"--sequence", Path("nowhere")})), kFailed, "nowhere");
  fs::remove(Path("pan/lr/depth/0013.exr"));  // a gap in the numbers
  ExpectRefused(RunWarplut(Arguments("sr")), kFailed, "0013.exr");
  ExpectRefused(RunWarplut({"run", "--mode", "sr", "--sequence", Path("pan"), "--lut",
                            Path("pan/sequence.json"), "--out", Path("out")}),
                kFailed, "sequence.json");
  EXPECT_FALSE(fs::exists(Path("out")));
}

TEST_F(RunCommand, RefusesGridsThatTheFilesDoNotHave) {
  Rewrite("\"width\":40", "\"width\":41");
  ExpectRefused(RunWarplut(Arguments("sr")), kFailed, "expected 41 x 32");
}

TEST_F(RunCommand, NamesTheStreamThatIsAbsent) {
  WritePan(folder_ / "flat", {.streams = Streams::kColor | Streams::kReference});
  ExpectRefused(RunWarplut(Arguments("sr", {"--sequence", Path("flat")})), kFailed, "'depth'");
  ExpectRefused(RunWarplut(Arguments("i", {"--sequence", Path("flat")})), kFailed,
                "'reference_depth'");
  ExpectRefused(RunWarplut(Arguments("bicubic,sr", {"--sequence", Path("flat")})), kFailed,
                "'depth'");
  EXPECT_FALSE(fs::exists(Path("out")));
  const ProgramResult scored =
      RunWarplut(Arguments("bicubic", {"--sequence", Path("flat"), "--score"}));
  EXPECT_EQ(scored.code, 0) << scored.err;
  EXPECT_THAT(scored.out, HasSubstr("no reference_depth and reference_motion"));
}

TEST_F(RunCommand, LinearColourIsWrittenAsExr) {
  WritePan(folder_ / "linear", {.frames = 2, .color_space = ColorSpace::kLinear});
  ExpectRefused(RunWarplut(Arguments("sr", {"--sequence", Path("linear"), "--format", "png"})),
                kUsage, "--format exr");
  ASSERT_EQ(RunWarplut(Arguments("sr", {"--sequence", Path("linear")})).code, 0);
  EXPECT_EQ(Files("out"), (std::set<std::string>{"0010.exr", "0011.exr"}));
}

TEST_F(RunCommand, LeavesWholeFilesWhereItIsStopped) {
  const ProgramResult full = RunWarplut(
      Arguments("sr"), {.standard_output = {}, .file_size_limit = 2000, .signal_when = {}});
  ExpectRefused(full, kFailed, "0010.png");
  EXPECT_TRUE(Files("out").empty());
  WritePan(folder_ / "long", {.frames = 60, .render = {200, 160}, .output = {400, 320}});
  const ProgramResult stopped =
      RunWarplut(Arguments("sr", {"--sequence", Path("long"), "--out", Path("stopped")}),
                 {.standard_output = {}, .signal_when = Path("stopped/0011.png")});
  ExpectRefused(stopped, kFailed, "interrupted");
  for (const std::string& file : Files("stopped")) {
    EXPECT_EQ(ReadImage(Path("stopped/" + file)).width, 400) << file;
  }
}

}  // namespace
}  // namespace warplut
