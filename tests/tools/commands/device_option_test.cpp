// --device of run and judge: every API of a GPU beside the processor, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "datasets/images/image_io.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"
#include "tests/train/replay/pan_sequence.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::HasSubstr;

// A device, and the variables of the environment with which its loader finds no driver.
struct TestedDevice {
  const char* name;
  const char* missing;
  std::vector<const char*> hiding;
};

class DeviceOption : public testing::TestWithParam<TestedDevice> {
 protected:
  DeviceOption() {
    WritePan(folder_ / "pan");
    WritePan(folder_ / "linear", {.color_space = ColorSpace::kLinear});
    WritePan(folder_ / "varied",
             {.streams = Streams::kAll | Streams::kReactive,
              .render_sizes = {{40, 32}, {40, 32}, {30, 20}, {37, 29}, {40, 32}, {20, 16}},
              .spot = true});
  }
  std::string Path(const std::string& name) const { return folder_ / name; }

  ProgramResult Run(const std::string& modes, const std::string& device,
                    const std::vector<std::string>& more = {}) const {
    return RunWarplut(WithDefaults({"run", "--mode", modes},
                                   {{"--sequence", Path("pan")},
                                    {"--filter", "catmull-rom"},
                                    {"--device", device},
                                    {"--out", Path(device)}},
                                   more));
  }

  ProgramResult Judge(const std::string& device) const {
    return RunWarplut({"judge", "--sequence", Path("linear"), "--modes", "sr,i", "--filter",
                       "catmull-rom", "--history", "rgba32f", "--device", device, "--json"});
  }

  // The frames of the device are those of the processor, a code apart at most.
  void ExpectSameFrames(std::size_t least_files) const {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(Path("cpu"))) {
      if (entry.is_regular_file()) files.insert(fs::relative(entry, Path("cpu")));
    }
    EXPECT_GE(files.size(), least_files);
    for (const std::string& file : files) {
      const Image expected = ReadImage(Path("cpu/" + file)),
                  found = ReadImage(Path(device_ + "/" + file));
      ASSERT_EQ(found.data.size(), expected.data.size()) << file;
      for (std::size_t i = 0; i < expected.data.size(); ++i)
        ASSERT_NEAR(found.data[i], expected.data[i], 1.01 / 255) << file;
    }
  }

  const std::string device_ = GetParam().name;
  const TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(
    Gpus, DeviceOption,
    testing::Values(
        TestedDevice{"vulkan", "there is no Vulkan", {"VK_ICD_FILENAMES", "VK_DRIVER_FILES"}},
        TestedDevice{"gles", "there is no OpenGL ES", {"__EGL_VENDOR_LIBRARY_FILENAMES"}}),
    [](const auto& test) { return test.param.name; });

// A loader that finds no driver, or a build without the API: a sentence, and nothing is left
// behind.
TEST_P(DeviceOption, WithoutAGpuNothingIsLeftBehind) {
  for (const char* variable : GetParam().hiding) setenv(variable, "/none", 1);
  const ProgramResult result = Run("i", device_);
  for (const char* variable : GetParam().hiding) unsetenv(variable);
  EXPECT_NE(result.code, 0);
  EXPECT_THAT(result.err, AnyOf(HasSubstr(GetParam().missing),
                                HasSubstr("no passes for the device " + device_)));
  EXPECT_FALSE(fs::exists(Path(device_)));
}

// The default history is in halves, and the files have 8 bits.
TEST_P(DeviceOption, RunWritesTheFramesOfTheProcessor) {
  const ProgramResult gpu = Run("sr,i", device_, {"--every", "2"});
  if (gpu.code != 0) GTEST_SKIP() << gpu.err;
  ASSERT_EQ(Run("sr,i", "cpu", {"--every", "2"}).code, 0);
  ExpectSameFrames(7);
}

// A reactive mask, render sizes that vary, and filtered motion.
TEST_P(DeviceOption, RunTakesWhatTheProcessorTakes) {
  const std::vector<std::string> more = {"--sequence", Path("varied"), "--motion-filter", "on"};
  const ProgramResult gpu = Run("sr", device_, more);
  if (gpu.err.find(GetParam().missing) != std::string::npos) GTEST_SKIP() << gpu.err;
  ASSERT_EQ(gpu.code, 0) << gpu.err;
  ASSERT_EQ(Run("sr", "cpu", more).code, 0);
  ExpectSameFrames(6);
}

// Scores are those of the processor within what whole runs may differ (tests/runtime/gpu). History
// and frames are in floats: to round them to halves, or to 8 bits before they are blended, moves
// the scores of so few pixels by more.
TEST_P(DeviceOption, JudgeScoresAsTheProcessor) {
  const ProgramResult gpu = Judge(device_);
  if (gpu.code != 0) GTEST_SKIP() << gpu.err;
  const ProgramResult cpu = Judge("cpu");
  ASSERT_EQ(cpu.code, 0) << cpu.err;
  const auto found = nlohmann::json::parse(gpu.out)["sequences"][0]["methods"];
  const auto expected = nlohmann::json::parse(cpu.out)["sequences"][0]["methods"];
  ASSERT_EQ(found.size(), expected.size());
  ASSERT_EQ(found.size(), 6U);  // the baselines too
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(found[i]["method"], expected[i]["method"]);
    EXPECT_NEAR(found[i]["psnr"].get<double>(), expected[i]["psnr"].get<double>(), 0.02);
  }
}

// Before a frame of any mode is written.
TEST_P(DeviceOption, OptionsThatTheGpuLacksLeaveNothingBehind) {
  const ProgramResult gpu = Run("i,sr", device_, {"--every", "2", "--history", "rgba8"});
  if (gpu.code == kUsage || gpu.err.find(GetParam().missing) != std::string::npos) {
    GTEST_SKIP() << gpu.err;
  }
  ExpectRefused(gpu, kFailed, "the history format is rgba8; the GPU takes rgba16f or rgba32f");
  ExpectRefused(Run("sr", device_, {"--coherent-share", "0.7"}), kFailed,
                "a share of coherent residuals");
  EXPECT_FALSE(fs::exists(Path(device_)));
}

}  // namespace
}  // namespace warplut
