// Scenes exported from Blender, where there is one.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "datasets/sequence/camera_fill.h"
#include "datasets/sequence/sequence.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

const fs::path kSources = WARPLUT_SOURCE;

bool HasBlender() { return std::system("command -v blender > /dev/null 2>&1") == 0; }

// Everything in the scene of make_scene.py stands still.
constexpr int kFrames = 3;
constexpr double kFar = 100, kWall = 10, kBox = 5;

class BlenderExport : public testing::Test {
 protected:
  void SetUp() override {
    if (!HasBlender()) GTEST_SKIP() << "there is no blender";
    const ProgramResult made = RunProgram(
        "blender", {"--background", "--factory-startup", "--python-exit-code", "3", "--python",
                    (kSources / "tests/datasets/blender/make_scene.py").string(), "--",
                    (folder_.path() / "scene.blend").string()});
    ASSERT_EQ(made.code, 0) << made.out << made.err;
  }

  ProgramResult Export(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {
        "--background", (folder_.path() / "scene.blend").string(),
        "--python",     (kSources / "datasets/blender/export_sequence.py").string(),
        "--",           "--out",
        Out().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram("blender", arguments);
  }

  fs::path Out() const { return folder_.path() / "shot"; }

  TemporaryFolder folder_;
};

// The share of pixels whose motion is that of the camera, to a hundredth of a pixel.
double ShareWithCameraMotion(const Frame& before, const Frame& frame, const Image& motion,
                             const Image& depth, Vec2 jitter) {
  const CameraStep step(*before.camera, *frame.camera, motion.width, motion.height, jitter);
  int right = 0;
  for (int y = 0; y < motion.height; ++y) {
    for (int x = 0; x < motion.width; ++x) {
      const double z = depth.at(x, y, 0) >= 1 ? INFINITY : depth.at(x, y, 0) * kFar;
      const std::optional<Vec2> expected = step.MotionAt(x, y, z);
      right += expected && std::hypot(motion.at(x, y, 0) - expected->x,
                                      motion.at(x, y, 1) - expected->y) < 0.01;
    }
  }
  return right / (1.0 * motion.width * motion.height);
}

TEST_F(BlenderExport, HasTheDepthMotionAndCamerasOfTheScene) {
  const ProgramResult exported = Export({"--samples", "4", "--light-samples", "1"});
  ASSERT_EQ(exported.code, 0) << exported.out << exported.err;
  const Sequence sequence = ReadSequence(Out());
  ASSERT_EQ(sequence.count, kFrames);
  EXPECT_EQ(sequence.output.width, 64);
  EXPECT_EQ(sequence.render.height, 24);
  const Streams all = AvailableStreams(sequence);
  Frame before = LoadFrame(sequence, 0, all);
  // The bottom of the image is the wall, the box is right of the middle, the top is sky.
  EXPECT_NEAR(before.reference_depth.at(3, 45, 0), kWall / kFar, 1e-5);
  EXPECT_NEAR(before.depth.at(2, 22, 0), kWall / kFar, 1e-5);
  EXPECT_GE(before.reference_depth.at(3, 1, 0), 1);
  int box = 0;
  for (int x = 0; x < 64; ++x) {
    box += std::abs(before.reference_depth.at(x, 28, 0) - kBox / kFar) < 1e-5;
  }
  EXPECT_GT(box, 6);
  for (int i = 1; i < kFrames; ++i) {
    Frame frame = LoadFrame(sequence, i, all);
    // The camera goes 0.5 to the right and turns by 0.01 a frame.
    EXPECT_LT(frame.reference_motion.at(3, 45, 0), -2);
    EXPECT_GT(
        ShareWithCameraMotion(before, frame, frame.reference_motion, frame.reference_depth, {}),
        0.999);
    EXPECT_GT(ShareWithCameraMotion(before, frame, frame.motion, frame.depth, frame.jitter), 0.999);
    before = std::move(frame);
  }
  EXPECT_EQ(RunWarplut({"dataset", "inspect", Out().string()}).code, 0);
}

TEST_F(BlenderExport, TakesUpWhereItWasInterrupted) {
  ASSERT_EQ(Export({"--samples", "1", "--light-samples", "1", "--frames", "1:2"}).code, 0);
  const auto written = fs::last_write_time(Out() / "hr/0001.exr");
  fs::remove(Out() / "hr/0002.exr");
  fs::remove(Out() / "sequence.json");
  ASSERT_EQ(Export({"--samples", "1", "--light-samples", "1", "--frames", "1:2", "--resume"}).code,
            0);
  EXPECT_EQ(fs::last_write_time(Out() / "hr/0001.exr"), written);
  EXPECT_EQ(ReadSequence(Out()).count, 2);
  for (const auto& entry : fs::recursive_directory_iterator(Out())) {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
  }
}

TEST_F(BlenderExport, RefusesOptionsInASentence) {
  for (const auto& [option, value, piece] :
       {std::array{"--scale", "5", "--scale is 5.0; expected 1 to 4"},
        std::array{"--frames", "2", "--frames is '2'; expected A:B"},
        std::array{"--frames", "3:1", "expected 0 <= A <= B"},
        std::array{"--width", "4", "the size is 4 x 48; expected 16 to 16384"}}) {
    const ProgramResult refused = Export({option, value});
    EXPECT_EQ(refused.code, kFailed);
    EXPECT_NE(refused.err.find(piece), std::string::npos) << refused.err;
    EXPECT_FALSE(fs::exists(Out() / "sequence.json"));
  }
}

}  // namespace
}  // namespace warplut
