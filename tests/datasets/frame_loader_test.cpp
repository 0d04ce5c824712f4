#include <gtest/gtest.h>

#include <limits>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/sequence/sequence.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Two frames, 3 and 4, of 4 x 2 pixels in `folder`, colour only; tests add what they need.
class LoadFrameTest : public testing::Test {
 protected:
  LoadFrameTest() {
    s_.folder = folder_.path();
    s_.name = "demo";
    s_.first = 3;
    s_.count = 2;
    s_.render = {4, 2};
    s_.output = {8, 4};
    s_.color.path = "c%d.exr";
    s_.jitter = {{0.25, -0.25}};
    s_.cuts = {4};
    Color(Filled(3, 0.5F));
  }

  static Image Filled(int channels, float value) {
    Image image(4, 2, channels);
    image.data.assign(image.data.size(), value);
    return image;
  }

  void Color(const Image& image, const std::vector<std::string>& names = {}) {
    WriteImage(folder_ / "c3.exr", image, PixelType::kFloat, names);
  }
  Image LoadColor() { return LoadFrame(s_, 0, Streams::kColor).color; }

  TemporaryFolder folder_;
  Sequence s_;
};

TEST_F(LoadFrameTest, NumberJitterAndCutNeedNoFile) {
  const Frame frame = LoadFrame(s_, 1, Streams::kNone);
  EXPECT_EQ(frame.number, 4);
  EXPECT_TRUE(frame.cut);
  EXPECT_EQ(frame.jitter.y, -0.25);
  EXPECT_FALSE(frame.camera);
  EXPECT_TRUE(frame.color.empty());
  EXPECT_FALSE(LoadFrame(s_, 0, Streams::kNone).cut);
}

TEST_F(LoadFrameTest, GreyAndAlphaBecomeRgb) {
  Image grey(4, 2, 1), rgba(4, 2, 4), grey_alpha(4, 2, 2);
  for (std::size_t i = 0; i < 8; ++i) {
    const float v = static_cast<float>(i) / 8;
    grey.data[i] = grey_alpha.data[2 * i] = v;
    grey_alpha.data[2 * i + 1] = 0;
    for (std::size_t c = 0; c < 3; ++c) rgba.data[4 * i + c] = v;
  }
  for (const Image* image : {&grey, &grey_alpha, &rgba}) {
    Color(*image);
    const Image color = LoadColor();
    ASSERT_EQ(color.channels, 3);
    for (std::size_t i = 0; i < color.data.size(); ++i) ASSERT_EQ(color.data[i], grey.data[i / 3]);
  }
  s_.color.channels = {"G"};
  Color(rgba);
  EXPECT_EQ(LoadColor().channels, 3);
}

TEST_F(LoadFrameTest, FilesAreChecked) {
  ExpectError([&] { LoadFrame(s_, 1, Streams::kColor); }, {"c4.exr", "does not exist"});
  ExpectError([&] { LoadFrame(s_, 2, Streams::kColor); }, {"'demo'", "index 2", "0 to 1"});
  ExpectError([&] { LoadFrame(s_, -1, Streams::kNone); }, {"index -1"});
  ExpectError([&] { LoadFrame(s_, 0, Streams::kMotion); },
              {"'demo'", "no stream 'motion'", "color"});
  s_.render = {4, 3};
  ExpectError([&] { LoadColor(); }, {"c3.exr", "4 x 2", "expected 4 x 3"});
}

TEST_F(LoadFrameTest, ColourIsFiniteAndInTheDisplayRangeUnlessLinear) {
  Image image = Filled(3, 0.5F);
  image.at(2, 1, 1) = kNan;
  Color(image);
  ExpectError([&] { LoadColor(); }, {"c3.exr", "pixel (2, 1)", "channel G", "nan"});
  image.at(2, 1, 1) = 1.5F;
  Color(image);
  ExpectError([&] { LoadColor(); }, {"c3.exr", "pixel (2, 1)", "1.5", "linear"});
  image.at(2, 1, 1) = 1.001F;
  Color(image);
  EXPECT_EQ(LoadColor().at(2, 1, 1), 1);
  image.at(2, 1, 1) = 150;
  Color(image);
  s_.color_space = ColorSpace::kLinear;
  EXPECT_EQ(LoadColor().at(2, 1, 1), 150);
}

TEST_F(LoadFrameTest, LinearColourMayBeInfiniteButNoNaN) {
  s_.color_space = ColorSpace::kLinear;
  Image image = Filled(3, 0.5F);
  image.at(2, 1, 1) = kInfinity;
  image.at(3, 1, 2) = -kInfinity;
  Color(image);
  EXPECT_EQ(LoadColor().data, image.data);
  image.at(2, 1, 0) = kNan;
  Color(image);
  ExpectError([&] { LoadColor(); }, {"c3.exr", "pixel (2, 1)", "channel R", "nan", "a number"});
}

TEST_F(LoadFrameTest, OneFileMayHoldSeveralStreams) {
  Image image(4, 2, 4);
  for (std::size_t i = 0; i < 8; ++i) {
    const float values[] = {0.5F, 3, -2, 40};
    for (std::size_t c = 0; c < 4; ++c) image.data[4 * i + c] = values[c];
  }
  Color(image, {"Y", "mv.x", "mv.y", "Z"});
  s_.color.channels = {"Y"};
  s_.depth.emplace();
  s_.depth->path = s_.color.path;
  s_.depth->channels = {"Z"};
  s_.depth->far = 80;
  s_.motion.emplace();
  s_.motion->path = s_.color.path;
  s_.motion->channels = {"mv.x", "mv.y"};
  const Frame frame = LoadFrame(s_, 0, Streams::kRenderGrid);
  EXPECT_EQ(frame.color.at(1, 1, 2), 0.5F);
  EXPECT_EQ(frame.depth.at(3, 0), 0.5F);
  EXPECT_EQ(frame.motion.at(3, 1, 0), 3);
  EXPECT_EQ(frame.motion.at(3, 1, 1), -2);
}

TEST_F(LoadFrameTest, DepthAndMotionFilesAreChecked) {
  s_.depth.emplace();
  s_.depth->path = "d%d.exr";
  s_.motion.emplace();
  s_.motion->path = "m%d.exr";
  Image depth = Filled(1, 0.5F), motion = Filled(2, 1);
  depth.data[2] = kInfinity;
  WriteImage(folder_ / "d3.exr", depth, PixelType::kFloat, {"Z"});
  EXPECT_EQ(LoadFrame(s_, 0, Streams::kDepth).depth.data, depth.data);
  WriteImage(folder_ / "d3.exr", motion, PixelType::kFloat, {"X", "Y"});
  ExpectError([&] { LoadFrame(s_, 0, Streams::kDepth); },
              {"d3.exr", "2 channels (X, Y)", "expected 1"});
  depth.data[5] = kNan;
  WriteImage(folder_ / "d3.exr", depth, PixelType::kFloat, {"Z"});
  ExpectError([&] { LoadFrame(s_, 0, Streams::kDepth); }, {"d3.exr", "pixel (1, 1)", "nan"});
  motion.data[6] = kInfinity;
  WriteImage(folder_ / "m3.exr", motion, PixelType::kFloat, {"X", "Y"});
  ExpectError([&] { LoadFrame(s_, 0, Streams::kMotion); }, {"m3.exr", "pixel (3, 0)", "inf"});
  s_.depth->encoding = Encoding::kRgba8Base255;
  ExpectError([&] { LoadFrame(s_, 0, Streams::kDepth); }, {"d3.exr", "32-bit float", "8-bit"});
  s_.depth->path = "d%d.png";
  WriteImage(folder_ / "d3.png", Filled(3, 0.5F), PixelType::kUint8);
  ExpectError([&] { LoadFrame(s_, 0, Streams::kDepth); }, {"d3.png", "3 channels", "expected 4"});
}

TEST_F(LoadFrameTest, WhatIsInvalidHasNoMotion) {
  s_.motion.emplace();
  s_.motion->path = "m%d.exr";
  s_.motion->units = MotionUnits::kUv;
  s_.motion->direction = MotionDirection::kCurrentToPrevious;
  Image motion(4, 2, 2);
  motion.data = {-512, 0, 0.25f, 0.5f, 0, -512, kNan, 1, 1, kInfinity, 7, 7, 0.5f, 1, 0.25f, 7};
  WriteImage(folder_ / "m3.exr", motion, PixelType::kFloat, {"X", "Y"});
  const auto load = [&] { return LoadFrame(s_, 0, Streams::kMotion).motion; };
  ExpectError([&] { load(); }, {"m3.exr", "finite motion, or the field 'invalid'"});
  s_.motion->invalid = InvalidMotion{.values = {-512, 7}};
  const std::vector<float> expected = {0, 0, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, -2, -2, 0, 0};
  EXPECT_EQ(load().data, expected);
  s_.motion->invalid->values.clear();
  EXPECT_EQ(load().at(0, 0, 0), 4 * 512) << "without its value it is a motion";
  EXPECT_EQ(load().at(3, 0, 0), 0) << "NaN is invalid by itself";
}

TEST_F(LoadFrameTest, AChannelTellsWhatIsInvalid) {
  // As KITTI stores flow: 16 bits, (code - 32768) / 64 pixels, the third channel 0 where there is
  // none.
  s_.motion.emplace();
  s_.motion->path = "m%d.png";
  s_.motion->channels = {"R", "G"};
  s_.motion->scale = {65535.0 / 64, 65535.0 / 64};
  s_.motion->bias = {-512, -512};
  s_.motion->invalid = InvalidMotion{.channel = "B"};
  Image codes(4, 2, 3);
  for (std::size_t i = 0; i < 8; ++i) {
    const bool valid = i % 3 != 0;
    codes.data[3 * i] = valid ? static_cast<float>(32768 + 64 * i) / 65535 : 0;
    codes.data[3 * i + 1] = valid ? static_cast<float>(32768 - 32) / 65535 : 0;
    codes.data[3 * i + 2] = valid ? 1.0f / 65535 : 0;
  }
  WriteImage(folder_ / "m3.png", codes, PixelType::kUint16);
  const Image motion = LoadFrame(s_, 0, Streams::kMotion).motion;
  for (std::size_t i = 0; i < 8; ++i) {
    const bool valid = i % 3 != 0;
    EXPECT_NEAR(motion.data[2 * i], valid ? static_cast<double>(i) : 0, 1e-4) << i;
    EXPECT_NEAR(motion.data[2 * i + 1], valid ? -0.5 : 0, 1e-4) << i;
  }
  s_.motion->invalid = InvalidMotion{.values = {-512}};
  EXPECT_EQ(LoadFrame(s_, 0, Streams::kMotion).motion.data, motion.data) << "its value tells too";
  s_.motion->invalid = InvalidMotion{.channel = "A"};
  ExpectError([&] { LoadFrame(s_, 0, Streams::kMotion); }, {"m3.png", "no channel 'A'"});
}

TEST_F(LoadFrameTest, FloSaysItselfWhatIsUnknown) {
  s_.motion.emplace();
  s_.motion->path = "m%d.flo";
  std::string bytes = "PIEH";
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  append(std::int32_t{4});
  append(std::int32_t{2});
  for (int i = 0; i < 16; ++i) append(i == 5 ? 1e10f : static_cast<float>(i));
  WriteFile(folder_ / "m3.flo", bytes);
  const Image motion = LoadFrame(s_, 0, Streams::kMotion).motion;
  for (int i = 0; i < 16; ++i) {
    EXPECT_EQ(motion.data[static_cast<std::size_t>(i)], i / 2 == 2 ? 0 : i) << i;
  }
}

TEST_F(LoadFrameTest, FilesOfAFrame) {
  s_.motion.emplace();
  s_.motion->path_x = "x%d.exr";
  s_.motion->path_y = "y%d.exr";
  s_.reference = ColorStream{"r%d.png", {}};
  const std::vector<std::filesystem::path> expected = {folder_ / "c4.exr", folder_ / "x4.exr",
                                                       folder_ / "y4.exr", folder_ / "r4.png"};
  EXPECT_EQ(FrameFiles(s_, 1, Streams::kAll), expected);
  EXPECT_EQ(StreamNames(AvailableStreams(s_)),
            (std::vector<std::string>{"color", "motion", "reference"}));
}

}  // namespace
}  // namespace warplut
