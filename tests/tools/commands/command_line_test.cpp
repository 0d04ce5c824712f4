// Exit codes and sentences of the program for command lines and data that it must refuse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "datasets/file.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"
#include "tests/tools/test_images.h"

namespace warplut {
namespace {

class CommandLine : public testing::Test {
 protected:
  std::string Path(const std::string& name) const { return folder_ / name; }

  const TemporaryFolder folder_;
};

TEST_F(CommandLine, HelpAndVersionAreAnswers) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--help"},
                                                    {"--version"},
                                                    {"train", "--help"},
                                                    {"dataset", "render", "--help"}}) {
    const ProgramResult result = RunWarplut(arguments);
    EXPECT_EQ(result.code, 0);
    EXPECT_FALSE(result.out.empty());
    EXPECT_TRUE(result.err.empty()) << result.err;
  }
}

TEST_F(CommandLine, RefusesWhatItDoesNotKnow) {
  ExpectRefused(RunWarplut({}), kUsage, "no command");
  ExpectRefused(RunWarplut({"dataset"}), kUsage, "no command");
  ExpectRefused(RunWarplut({"trian"}), kUsage, "trian");
  ExpectRefused(RunWarplut({"train", "--date", "x"}), kUsage, "--date is not an option");
  // Not that its value is one folder too many.
  ExpectRefused(RunWarplut({"view", "--sequence", "a", "--nodes", "sr"}), kUsage,
                "--nodes is not an option");
  ExpectRefused(RunWarplut({"compare", "a", "b", "--frobnicate"}), kUsage, "--frobnicate");
  ExpectRefused(RunWarplut({"compare", "a"}), kUsage, "dir_b");
  ExpectRefused(RunWarplut({"dataset", "render", "atlantis", "--out", Path("out")}), kUsage,
                "atlantis");
  ExpectRefused(
      RunWarplut({"dataset", "render", "all", "--streams", "color,smell", "--out", Path("out")}),
      kUsage, "smell");
  ExpectRefused(
      RunWarplut({"dataset", "render", "all", "--streams", "depth,motion", "--out", Path("out")}),
      kUsage, "lack color");
  ExpectRefused(RunWarplut({"bake", "fit.json", "--out", Path("out"), "--format", "i4"}), kUsage,
                "i4");
}

TEST_F(CommandLine, RefusesOptionsOutOfRange) {
  const std::string image = WriteWavyImage(Path("a.png"), 64, 64);
  ExpectRefused(RunWarplut({"train", "--data", image, "--out", Path("f.json"), "--scale", "0.5"}),
                kUsage, "scale");
  ExpectRefused(RunWarplut({"train", "--data", image, "--out", Path("f.json"), "--taps", "20"}),
                kUsage, "--taps is 20; expected 16, 24 or 36");
  ExpectRefused(RunWarplut({"train", "--data", image, "--out", Path("f.json"), "--taps", "24"}),
                kUsage, "taps is 24 with prefilter iir; expected prefilter none");
  ExpectRefused(RunWarplut({"train", "--data", image, "--out", Path("no-name.json")}), kUsage,
                "no-name");
  ExpectRefused(RunWarplut({"dataset", "render", "all", "--out", Path("out"), "--scale", "0.5"}),
                kUsage, "scale");
  ExpectRefused(RunWarplut({"dataset", "render", "all", "--out", Path("out"), "--frames", "0"}),
                kUsage, "frames");
  ExpectRefused(RunWarplut({"bench", "warp", "--repeats", "0"}), kUsage, "repeats");
  EXPECT_EQ(folder_.Entries(), 1U);
}

TEST_F(CommandLine, RefusesMissingEmptyAndDamagedData) {
  const std::string out = Path("f.json");
  ExpectRefused(RunWarplut({"train", "--data", Path("none"), "--out", out}), kFailed, "none");
  std::filesystem::create_directory(Path("empty"));
  ExpectRefused(RunWarplut({"train", "--data", Path("empty"), "--out", out}), kFailed, "empty");
  WriteFile(Path("text.png"), "not an image");
  ExpectRefused(RunWarplut({"train", "--data", Path("text.png"), "--out", out}), kFailed,
                "text.png");
  const std::string whole = ReadFile(WriteWavyImage(Path("whole.png"), 200, 200));
  WriteFile(Path("half.png"), whole.substr(0, whole.size() / 2));
  ExpectRefused(RunWarplut({"train", "--data", Path("half.png"), "--out", out}), kFailed,
                "half.png");
  ExpectRefused(
      RunWarplut({"train", "--data", WriteWavyImage(Path("tiny.png"), 8, 8), "--out", out}),
      kFailed, "8");
  Image holed(64, 64, 3);
  holed.at(3, 5) = std::nanf("");
  WriteImage(Path("nan.exr"), holed, PixelType::kFloat);
  ExpectRefused(RunWarplut({"train", "--data", Path("nan.exr"), "--out", out}), kFailed, "nan.exr");
  ExpectRefused(RunWarplut({"bake", Path("none.json"), "--out", Path("baked")}), kFailed,
                "none.json");
  ExpectRefused(RunWarplut({"dataset", "inspect", Path("none")}), kFailed, "none");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(CommandLine, RefusesToTrainIntoAFileAsFolder) {
  WriteFile(Path("file"), "x");
  ExpectRefused(RunWarplut({"train", "--data", WriteWavyImage(Path("a.png"), 64, 64), "--out",
                            Path("file/f.json")}),
                kFailed, "file");
}

TEST_F(CommandLine, TellsWhenTheDiskIsFull) {
  ExpectRefused(
      RunWarplut({"dataset", "scenes"}, {.standard_output = "/dev/full", .signal_when = {}}),
      kFailed, "standard output");
  const ProgramResult render =
      RunWarplut({"dataset", "render", "still", "--out", Path("out"), "--width", "64", "--height",
                  "48", "--frames", "1", "--samples", "1"},
                 {.standard_output = {}, .file_size_limit = 600, .signal_when = {}});
  ExpectRefused(render, kFailed, Path("out"));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(Path("out"))) {
    EXPECT_FALSE(entry.is_regular_file()) << entry.path();
  }
}

TEST_F(CommandLine, ListsTheScenes) {
  const ProgramResult text = RunWarplut({"dataset", "scenes"});
  EXPECT_EQ(text.code, 0);
  EXPECT_THAT(text.out,
              testing::AllOf(testing::HasSubstr("training"), testing::HasSubstr("held-out")));
  EXPECT_THAT(RunWarplut({"dataset", "scenes", "--json"}).out, testing::HasSubstr("\"purpose\""));
}

TEST_F(CommandLine, RendersASequenceThatInspectAccepts) {
  const ProgramResult render =
      RunWarplut({"dataset", "render", "still", "--out", Path("out"), "--width", "64", "--height",
                  "48", "--frames", "2", "--samples", "1"});
  ASSERT_EQ(render.code, 0) << render.err;
  EXPECT_TRUE(render.err.empty()) << "progress does not belong in a pipe: " << render.err;
  EXPECT_EQ(render.out, Path("out/still/sequence.json") + "\n");

  const ProgramResult inspect = RunWarplut({"dataset", "inspect", Path("out/still"), "--json"});
  EXPECT_EQ(inspect.code, 0) << inspect.err;
  EXPECT_THAT(inspect.out, testing::HasSubstr("\"reference_motion\""));

  // Two damaged files, of which libpng would tell as well: the first and how many more.
  const std::string whole = ReadFile(Path("out/still/lr/color/0000.png"));
  for (const char* name : {"0000.png", "0001.png"}) {
    WriteFile(Path("out/still/lr/color/") + name, whole.substr(0, whole.size() / 2));
  }
  const ProgramResult halves = RunWarplut({"dataset", "inspect", Path("out/still")});
  EXPECT_EQ(halves.code, kFailed);
  EXPECT_EQ(std::count(halves.err.begin(), halves.err.end(), '\n'), 1) << halves.err;
  EXPECT_THAT(halves.out, testing::HasSubstr("0000.png"));
  EXPECT_THAT(halves.out, testing::HasSubstr("(1 more frame of 'color' cannot be loaded)"));
  EXPECT_THAT(halves.out, testing::Not(testing::HasSubstr("0001.png")));
  for (const char* name : {"0000.png", "0001.png"}) {
    WriteFile(Path("out/still/lr/color/") + name, whole);
  }

  std::filesystem::remove(Path("out/still/hr/color/0001.png"));
  const ProgramResult damaged = RunWarplut({"dataset", "inspect", Path("out/still")});
  ExpectRefused(damaged, kFailed, "1 missing or damaged");
  EXPECT_THAT(damaged.out, testing::HasSubstr("0001.png"));
}

}  // namespace
}  // namespace warplut
