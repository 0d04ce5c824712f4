#include "tools/pictures/shown_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "datasets/images/image_io.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/test_images.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

TEST(ShownFile, IsNamedByItsTime) {
  EXPECT_EQ(ShownFileName(10, 0, ShownFormat::kPng), "0010.png");
  EXPECT_EQ(ShownFileName(10, 1, ShownFormat::kExr), "0011.exr");
  EXPECT_EQ(ShownFileName(10, 0.5, ShownFormat::kPng), "0010_500.png");
  EXPECT_EQ(ShownFileName(0, 2 + 1 / 3.0, ShownFormat::kPng), "0002_333.png");
  EXPECT_EQ(ShownFileName(0, 2.9996, ShownFormat::kPng), "0003.png");
  EXPECT_EQ(ShownFileName(12345, 0.001, ShownFormat::kPng), "12345_001.png");
}

TEST(ShownFile, HoldsTheColours) {
  const TemporaryFolder folder;
  const Image image = WavyImage(20, 10);
  const ImageBuffer buffer = ToBuffer(image, PixelFormat::kRgba8);
  const ShownFrame shown = {.time = 1.25, .image = buffer.view()};
  WriteShownFrame(folder.path(), 3, shown, ColorEncoding::kDisplay, ShownFormat::kPng);
  WriteShownFrame(folder.path(), 3, shown, ColorEncoding::kLinearHdr, ShownFormat::kExr);
  EXPECT_THAT(ReadImage(folder / "0004_250.png").data,
              testing::Pointwise(testing::FloatNear(1e-6f), ToImage(buffer.view()).data));
  const Image half = ReadImage(folder / "0004_250.exr");
  ASSERT_EQ(half.channels, 3);
  EXPECT_NEAR(half.at(5, 5, 1), image.at(5, 5, 1), 0.5 / 255 + 0x1p-12);
  EXPECT_EQ(folder.Entries(), 2U);
  ExpectError(
      [&] {
        WriteShownFrame(folder.path(), 3, shown, ColorEncoding::kLinearHdr, ShownFormat::kPng);
      },
      {"0004_250.png", "linear", ".exr"});
}

TEST(ShownFile, HoldsAlphaStraightInPngAndPremultipliedInExr) {
  const TemporaryFolder folder;
  Image image(2, 1, 3), alpha(2, 1, 1);
  image.at(0, 0, 0) = 0.25F;  // of a pixel that is half covered by 0.5; the other is empty
  alpha.at(0, 0) = 0.5F;
  const ImageBuffer buffer = ToBuffer(image, PixelFormat::kRgba32F);
  const ShownFrame shown = {.image = buffer.view()};
  for (const ShownFormat format : {ShownFormat::kPng, ShownFormat::kExr}) {
    WriteShownFrame(folder.path(), 3, shown, ColorEncoding::kDisplay, format, &alpha);
    const Image read = ReadImage(folder / ShownFileName(3, 0, format));
    ASSERT_EQ(read.channels, 4);
    EXPECT_NEAR(read.at(0, 0, 0), format == ShownFormat::kPng ? 0.5 : 0.25, 0.003);
    EXPECT_NEAR(read.at(0, 0, 3), 0.5, 0.003);
    EXPECT_EQ(read.at(1, 0, 0), 0);
    EXPECT_EQ(read.at(1, 0, 3), 0);
  }
}

}  // namespace
}  // namespace warplut
