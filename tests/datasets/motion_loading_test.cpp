// Motion that lies in another file, has the jitter in it, or is missing.
#include <gtest/gtest.h>

#include <cmath>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/sequence/camera_fill.h"
#include "datasets/sequence/forward_flow.h"
#include "datasets/sequence/sequence.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

constexpr int kWidth = 16, kHeight = 8;

Image Constant(const std::vector<float>& values) {
  Image image(kWidth, kHeight, static_cast<int>(values.size()));
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = values[i % values.size()];
  return image;
}

// Three frames; the motion of frame i is (1 + i, 0).
Sequence WriteFrames(const std::filesystem::path& folder) {
  Sequence s;
  s.folder = folder;
  s.name = "frames";
  s.count = 3;
  s.render = s.output = {kWidth, kHeight};
  s.color.path = "c%d.png";
  s.motion.emplace();
  s.motion->path = "m%d.exr";
  s.motion->channels = {"X", "Y"};
  for (int i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i);
    WriteImage(folder / ("c" + number + ".png"), Constant({0.5F, 0.5F, 0.5F}), PixelType::kUint8);
    WriteImage(folder / ("m" + number + ".exr"), Constant({1.0F + static_cast<float>(i), 0}),
               PixelType::kFloat, {"X", "Y"});
    WriteImage(folder / ("d" + number + ".exr"), Constant({2}), PixelType::kFloat, {"Z"});
  }
  return s;
}

float MotionX(const Sequence& s, int index) {
  return LoadFrame(s, index, Streams::kMotion).motion.at(8, 4, 0);
}

TEST(LoadFrame, TakesMotionOfTheFileThatIsStated) {
  const TemporaryFolder folder;
  Sequence s = WriteFrames(folder.path());
  EXPECT_EQ(MotionX(s, 1), 2);
  s.motion->frame_offset = 1;
  EXPECT_EQ(MotionX(s, 1), 3);
  EXPECT_EQ(MotionX(s, 2), 0) << "there is no such file";
  s.motion->frame_offset = -1;
  EXPECT_EQ(MotionX(s, 1), 1);
}

TEST(LoadFrame, TakesForwardFlowOfTheFrameBefore) {
  const TemporaryFolder folder;
  Sequence s = WriteFrames(folder.path());
  s.motion->direction = MotionDirection::kCurrentToNext;
  EXPECT_EQ(MotionX(s, 0), 0);
  EXPECT_EQ(MotionX(s, 1), 1);
  EXPECT_EQ(MotionX(s, 2), 2);
}

TEST(LoadFrame, TakesTheJitterOutOfTheMotion) {
  const TemporaryFolder folder;
  Sequence s = WriteFrames(folder.path());
  s.jitter = {{0.25, 0}, {-0.25, 0}, {0.5, 0}};
  s.motion->contains_jitter = true;
  EXPECT_FLOAT_EQ(MotionX(s, 1), 1.5F) << "2 and -0.25 - 0.25";
  EXPECT_FLOAT_EQ(MotionX(s, 2), 3.75F);
}

Camera CameraAt(double x) {
  Camera camera;
  camera.view = {1, 0, 0, -x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  camera.projection = {1, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1.002, -0.2, 0, 0, -1, 0};
  return camera;
}

TEST(LoadFrame, FillsInvalidMotionFromTheCamera) {
  const TemporaryFolder folder;
  Sequence s = WriteFrames(folder.path());
  s.depth.emplace();
  s.depth->path = "d%d.exr";
  s.depth->channels = {"Z"};
  s.depth->far = 100;
  s.camera = {CameraAt(0), CameraAt(0.5), CameraAt(0.5)};
  s.motion->invalid = InvalidMotion{.values = {2}, .channel = {}};
  // The camera moves right by 0.5 at depth 2: 0.25 of NDC to the left, half of that of the width.
  EXPECT_FLOAT_EQ(MotionX(s, 1), -0.25F * kWidth / 2);
  EXPECT_EQ(MotionX(s, 2), 3) << "valid motion is kept";
}

TEST(FillMissingMotion, GivesTheSkyTheCamerasRotation) {
  const double turn = 0.1;
  Camera turned = CameraAt(0);
  turned.view = {std::cos(turn), 0, -std::sin(turn), 3, 0, 1, 0, 0,
                 std::sin(turn), 0, std::cos(turn),  0, 0, 0, 0, 1};
  const CameraStep step(CameraAt(0), turned, kWidth, kHeight, {});
  ASSERT_TRUE(step.Valid());
  Image motion = Constant({0, 0}), depth = Constant({1});
  motion.at(0, 0, 0) = 5;
  depth.at(1, 0) = 0.5F;
  const std::size_t filled = FillMissingMotion(step, depth, 100, 1, &motion);
  EXPECT_EQ(filled, motion.pixels() - 2) << "valid motion, and zero motion before the background";
  // At the centre a turn by t moves the sky by tan(t) of NDC; the position has no part.
  const auto centre = step.MotionAt(kWidth / 2, kHeight / 2, HUGE_VAL);
  ASSERT_TRUE(centre);
  EXPECT_NEAR(std::abs(centre->x), std::tan(turn) * kWidth / 2, 0.02);
}

TEST(MotionOfForwardFlow, LetsTheNearerWinAndFillsHoles) {
  Image flow = Constant({0, 0}), depth = Constant({10});
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 4; x < 8; ++x) {
      flow.at(x, y, 0) = 3;
      depth.at(x, y) = 1;
    }
  }
  const Image motion = MotionOfForwardFlow(flow, depth);
  for (int x = 7; x < 11; ++x) EXPECT_EQ(motion.at(x, 4, 0), 3) << x;
  for (const int x : {0, 3, 4, 5, 6, 11, 15}) EXPECT_EQ(motion.at(x, 4, 0), 0) << x;
}

TEST(ReadSequence, ReadsAndWritesTheFieldsOfVersion2) {
  const TemporaryFolder folder;
  Sequence s = WriteFrames(folder.path());
  EXPECT_NE(SequenceJson(s).find("\"version\": 1"), std::string::npos);
  s.depth.emplace();
  s.depth->path = "d%d.exr";
  s.depth->far = 50;
  s.depth->background = 1e10;
  s.motion->frame_offset = -1;
  s.motion->contains_jitter = true;
  s.motion->direction = MotionDirection::kCurrentToNext;
  s.numbers = {0, 1, 4};
  s.cuts = {4};
  const std::string text = SequenceJson(s);
  EXPECT_NE(text.find("\"version\": 2"), std::string::npos);
  WriteFile(folder / "sequence.json", text);
  const Sequence read = ReadSequence(folder.path());
  EXPECT_EQ(SequenceJson(read), text);
  EXPECT_EQ(read.Number(2), 4);
  EXPECT_EQ(read.LastNumber(), 4);
  std::string one = text;
  one.replace(one.find("\"version\": 2"), 12, "\"version\": 1");
  WriteFile(folder / "sequence.json", one);
  ExpectError([&] { ReadSequence(folder.path()); }, {"version", "fields of version 2"});
}

TEST(ReadSequence, RefusesWrongFieldsOfVersion2) {
  const TemporaryFolder folder;
  const Sequence s = WriteFrames(folder.path());
  const auto refused = [&](const auto& change, const std::string& field) {
    Sequence wrong = s;
    change(wrong);
    std::string why;
    EXPECT_FALSE(wrong.IsValid(&why));
    EXPECT_NE(why.find(field), std::string::npos) << why;
  };
  refused([](Sequence& w) { w.motion->frame_offset = 2; }, "frame_offset");
  refused([](Sequence& w) { w.numbers = {0, 2, 2}; }, "frames.numbers[2]");
  refused([](Sequence& w) { w.numbers = {0, 2}; }, "frames.numbers");
  refused([](Sequence& w) { w.numbers = {0, 2, 4}, w.cuts = {3}; }, "cuts[0]");
  refused(
      [](Sequence& w) {
        w.reference_motion = w.motion;
        w.reference_motion->contains_jitter = true;
      },
      "reference_motion.jitter");
}

}  // namespace
}  // namespace warplut
