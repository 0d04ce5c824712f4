#include "datasets/images/image_io.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "datasets/file.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Values i / 255 in no special order, so that files do not shrink to nothing.
Image Pattern(int width, int height, int channels) {
  Image image(width, height, channels);
  unsigned state = 1;
  for (float& v : image.data) {
    state = state * 1664525U + 1013904223U;
    v = static_cast<float>(state >> 24) / 255.0F;
  }
  return image;
}

TEST(ImageIo, EightAndSixteenBitsComeBack) {
  const TemporaryFolder folder;
  for (const int channels : {1, 2, 3, 4}) {
    const Image image = Pattern(37, 21, channels);
    WriteImage(folder / "8.png", image, PixelType::kUint8);
    WriteImage(folder / "16.png", image, PixelType::kUint16);
    for (const char* name : {"8.png", "16.png"}) {
      const Image read = ReadImage(folder / name);
      ASSERT_EQ(read.channels, channels);
      for (std::size_t i = 0; i < image.data.size(); ++i) {
        ASSERT_NEAR(read.data[i], image.data[i], 1e-7) << name << " " << channels;
      }
    }
    EXPECT_EQ(ReadImageInfo(folder / "8.png").bits, 8);
    EXPECT_EQ(ReadImageInfo(folder / "16.png").bits, 16);
  }
}

TEST(ImageIo, ColourUnderZeroAlphaIsKept) {
  const TemporaryFolder folder;
  Image image(1, 1, 4);
  image.data = {1.0F, 0.2F, 0.4F, 0.0F};
  WriteImage(folder / "a.png", image, PixelType::kUint8);
  const Image read = ReadImage(folder / "a.png");
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(read.data[c], image.data[c], 1e-7);
}

TEST(ImageIo, IntegersAreClampedAndRoundedToNearest) {
  const TemporaryFolder folder;
  Image image(5, 1, 1);
  image.data = {-1, 2, 0.4F / 255, 0.6F / 255, kInfinity};
  WriteImage(folder / "a.png", image, PixelType::kUint8);
  const Image read = ReadImage(folder / "a.png");
  const float expected[] = {0, 1, 0, 1.0F / 255, 1};
  for (int x = 0; x < 5; ++x) EXPECT_NEAR(read.at(x, 0), expected[x], 1e-8);
}

TEST(ImageIo, FloatAndHalfKeepValuesAndNames) {
  const TemporaryFolder folder;
  Image image = Pattern(16, 40, 2);
  image.data[3] = -12.75F;
  image.data[5] = 60000;
  WriteImage(folder / "f.exr", image, PixelType::kFloat, {"X", "Y"});
  EXPECT_EQ(ReadImage(folder / "f.exr", {"X", "Y"}).data, image.data);
  const Image y = ReadImage(folder / "f.exr", {"Y"});
  const Image swapped = ReadImage(folder / "f.exr", {"Y", "X"});
  for (std::size_t i = 0; i < y.data.size(); ++i) {
    ASSERT_EQ(y.data[i], image.data[2 * i + 1]);
    ASSERT_EQ(swapped.data[2 * i], image.data[2 * i + 1]);
  }
  WriteImage(folder / "h.exr", image, PixelType::kHalf, {"X", "Y"});
  const Image half = ReadImage(folder / "h.exr");
  for (std::size_t i = 0; i < half.data.size(); ++i) {
    ASSERT_NEAR(half.data[i], image.data[i], std::abs(image.data[i]) / 2048);
  }
  EXPECT_EQ(ReadImageInfo(folder / "h.exr"), (ImageInfo{16, 40, {"X", "Y"}, 16, false}));
}

TEST(ImageIo, SameImageSameBytes) {
  const TemporaryFolder folder;
  const Image image = Pattern(64, 64, 3);
  for (const auto& [name, type] :
       {std::pair("a.exr", PixelType::kHalf), std::pair("a.png", PixelType::kUint8)}) {
    WriteImage(folder / name, image, type);
    const std::string bytes = ReadFile(folder / name);
    WriteImage(folder / name, image, type);
    EXPECT_EQ(ReadFile(folder / name), bytes);
    EXPECT_EQ(bytes.find("2026"), std::string::npos);
  }
}

TEST(ImageIo, FiniteIsCheckedWhereAsked) {
  const TemporaryFolder folder;
  Image image = Pattern(6, 4, 2);
  image.at(2, 3, 1) = kInfinity;
  WriteImage(folder / "a.exr", image, PixelType::kFloat, {"X", "Y"});
  ExpectError([&] { ReadImage(folder / "a.exr"); }, {"a.exr", "pixel (2, 3)", "channel Y", "inf"});
  for (const Values values : {Values::kNumbers, Values::kAll}) {
    EXPECT_EQ(ReadImage(folder / "a.exr", {}, values).at(2, 3, 1), kInfinity);
  }
  EXPECT_NO_THROW(ReadImage(folder / "a.exr", {"X"}));
}

TEST(ImageIo, MissingForeignAndTruncatedFilesAreRefused) {
  const TemporaryFolder folder;
  ExpectError([&] { ReadImage(folder / "none.png"); }, {"none.png", "does not exist"});
  ExpectError([&] { ReadImage(folder.path()); }, {"not a regular file"});
  WriteFile(folder / "text.png", "not an image at all");
  ExpectError([&] { ReadImage(folder / "text.png"); }, {"text.png"});
  WriteFile(folder / "empty.exr", "");
  ExpectError([&] { ReadImage(folder / "empty.exr"); }, {"empty.exr"});
  const Image image = Pattern(64, 64, 3);
  WriteImage(folder / "a.png", image, PixelType::kUint8);
  WriteImage(folder / "a.exr", image, PixelType::kFloat);
  for (const char* name : {"a.png", "a.exr"}) {
    const std::string bytes = ReadFile(folder / name);
    const std::string cut_name = std::string("cut_") + name;
    for (const double part : {0.01, 0.1, 0.5, 0.9, 0.99}) {
      WriteFile(
          folder / cut_name,
          bytes.substr(0, static_cast<std::size_t>(part * static_cast<double>(bytes.size()))));
      ExpectError([&] { ReadImage(folder / cut_name); }, {cut_name});
    }
  }
}

TEST(ImageIo, HugeSidesAreRefusedBeforeAnyPixelIsRead) {
  const TemporaryFolder folder;
  WriteImage(folder / "a.png", Pattern(8, 8, 3), PixelType::kUint8);
  std::string bytes = ReadFile(folder / "a.png");
  // IHDR: width at byte 16, CRC of type and data at byte 29 (of 100000 x 8, 8-bit RGB).
  bytes.replace(16, 4, std::string("\x00\x01\x86\xa0", 4));
  bytes.replace(29, 4, "\xf5\x13\xd0\x4a");
  WriteFile(folder / "a.png", bytes);
  ExpectError([&] { ReadImage(folder / "a.png"); }, {"a.png", "100000 x 8", "1 to 32768"});
  const auto wide = OIIO::ImageOutput::create("wide.exr");
  const OIIO::ImageSpec spec(kMaxImageSide + 1, 1, 1, OIIO::TypeDesc::HALF);
  ASSERT_TRUE(wide->open((folder / "wide.exr").string(), spec));
  const std::vector<float> row(static_cast<std::size_t>(spec.width));
  ASSERT_TRUE(wide->write_image(OIIO::TypeDesc::FLOAT, row.data()) && wide->close());
  ExpectError([&] { ReadImage(folder / "wide.exr"); }, {"wide.exr", "32769 x 1", "1 to 32768"});
}

TEST(ImageIo, ChannelsAreCounted) {
  const TemporaryFolder folder;
  const auto file = OIIO::ImageOutput::create("five.exr");
  OIIO::ImageSpec spec(2, 2, 5, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"R", "G", "B", "Z", "id"};
  ASSERT_TRUE(file->open((folder / "five.exr").string(), spec));
  const std::vector<float> pixels(20, 0.5F);
  ASSERT_TRUE(file->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && file->close());
  ExpectError([&] { ReadImage(folder / "five.exr"); }, {"five.exr", "5 channels"});
  EXPECT_EQ(ReadImage(folder / "five.exr", {"Z"}).data, std::vector<float>(4, 0.5F));
  ExpectError([&] { ReadImage(folder / "five.exr", {"R", "W"}); }, {"five.exr", "no channel 'W'"});
}

TEST(ImageIo, DataWindowOtherThanDisplayWindowIsRefused) {
  const TemporaryFolder folder;
  const auto file = OIIO::ImageOutput::create("crop.exr");
  OIIO::ImageSpec spec(2, 2, 1, OIIO::TypeDesc::FLOAT);
  spec.x = spec.y = 1;
  spec.full_width = spec.full_height = 8;
  ASSERT_TRUE(file->open((folder / "crop.exr").string(), spec));
  const std::vector<float> pixels(4);
  ASSERT_TRUE(file->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && file->close());
  ExpectError([&] { ReadImage(folder / "crop.exr"); },
              {"crop.exr", "data window (2 x 2 at 1, 1) lacks"});
}

TEST(ImageIo, WhatCannotBeWrittenIsRefusedAndLeavesNothing) {
  const TemporaryFolder folder;
  Image image = Pattern(4, 4, 3);
  ExpectError([&] { WriteImage(folder / "a.exr", image, PixelType::kUint8); }, {"a.exr", ".png"});
  ExpectError([&] { WriteImage(folder / "a.png", image, PixelType::kHalf); }, {"a.png", ".exr"});
  ExpectError([&] { WriteImage(folder / "a.jpg", image, PixelType::kUint8); }, {"a.jpg", ".png"});
  ExpectError([&] { WriteImage(folder / "a.png", Image(), PixelType::kUint8); },
              {"a.png", "0 x 0"});
  ExpectError([&] { WriteImage(folder / "a.png", Image(2, 2, 5), PixelType::kUint8); },
              {"5 channels"});
  ExpectError([&] { WriteImage(folder / "a.exr", image, PixelType::kHalf, {"X"}); },
              {"3 channels have 1 names"});
  ExpectError([&] { WriteImage(folder / "no/a.png", image, PixelType::kUint8); }, {"no/a.png"});
  image.data[0] = 65520;
  ExpectError([&] { WriteImage(folder / "a.exr", image, PixelType::kHalf); },
              {"a.exr", "65520", "65504"});
  image.data[0] = kNan;
  ExpectError([&] { WriteImage(folder / "a.png", image, PixelType::kUint8); }, {"a.png", "NaN"});
  EXPECT_EQ(folder.Entries(), 0U);
}

}  // namespace
}  // namespace warplut
