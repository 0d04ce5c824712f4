#include "tools/judge/images/image_set.h"

#include <gtest/gtest.h>

#include <limits>

#include "datasets/hash.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/test_images.h"
#include "tests/train/replay/pan_sequence.h"
#include "train/metrics/displayed_color.h"

namespace warplut {
namespace {

TEST(LoadImages, RecordsNamesBehindTheGivenFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "frames");
  const std::string file = WriteWavyImage(folder / "frames" / "0001.png", 20, 10);
  for (const std::string& given :
       {(folder / "frames").string(), (folder / "frames").string() + "/", file}) {
    const std::vector<TrainImage> images = LoadImages({given});
    ASSERT_EQ(images.size(), 1U);
    EXPECT_EQ(images[0].record.name, "frames/0001.png") << given;
    EXPECT_EQ(images[0].record.sha1, Sha1OfFile(file));
    EXPECT_EQ(images[0].record.width, 20);
    EXPECT_EQ(images[0].image.channels, 3);
  }
}

TEST(LoadImages, RecordsAnyName) {
  const TemporaryFolder folder;
  WriteWavyImage(folder / "caf\xe9\n\\.png", 20, 10);
  const std::vector<TrainImage> images = LoadImages({folder.path()});
  ASSERT_EQ(images.size(), 1U);
  std::string why;
  EXPECT_TRUE(images[0].record.IsValid(&why)) << why;
  EXPECT_NE(images[0].record.name.find("/caf\xef\xbf\xbd\xef\xbf\xbd\\.png"), std::string::npos);
}

TEST(LoadImages, RefusesWhatIsNotADisplayImage) {
  const TemporaryFolder folder;
  Image bright(12, 12, 3);
  bright.data[7] = 1.5f;
  WriteImage(folder / "bright.exr", bright, PixelType::kFloat);
  ExpectError([&] { LoadImages({folder / "bright.exr"}); },
              {"bright.exr", "1.5", "[0, 1]", "color_space"});
  bright.data[7] = std::numeric_limits<float>::quiet_NaN();
  WriteImage(folder / "unknown.exr", bright, PixelType::kFloat);
  ExpectError([&] { LoadImages({folder / "unknown.exr"}); }, {"unknown.exr", "nan", "finite"});
  const std::string file = WriteWavyImage(folder / "a.png", 20, 10);
  ExpectError([&] { LoadImages({file, file}); }, {"a.png", "twice"});
}

TEST(LoadImages, ToneMapsLinearSequences) {
  const TemporaryFolder folder;
  const Sequence linear =
      WritePan(folder / "linear", {.frames = 2, .color_space = ColorSpace::kLinear});
  WriteWavyImage(folder / "a.png", 20, 10);
  int tone_mapped = 0;
  const std::vector<TrainImage> images =
      LoadImages({folder / "linear", folder / "a.png"}, &tone_mapped);
  ASSERT_EQ(images.size(), 3U);
  EXPECT_EQ(tone_mapped, 2);
  EXPECT_EQ(ToneMappedText(0, 3), "");
  EXPECT_NE(ToneMappedText(2, 3).find("2 of 3 images"), std::string::npos);
  Image expected = LoadFrame(linear, 1, Streams::kReference).reference;
  for (std::size_t p = 0; p < expected.pixels(); ++p) {
    ToDisplay(ColorEncoding::kLinearHdr, &expected.data[3 * p]);
  }
  EXPECT_EQ(images[1].image.data, expected.data);
}

TEST(DisplayedImage, GreyCountsAsThreeEqualChannels) {
  Image grey(1, 1, 1), rgb(1, 1, 3);
  grey.data = {3};
  rgb.data = {3, 3, 3};
  EXPECT_EQ(DisplayedImage(grey, ColorEncoding::kLinearHdr).data[0],
            DisplayedImage(rgb, ColorEncoding::kLinearHdr).data[1]);
  EXPECT_EQ(DisplayedImage(rgb, ColorEncoding::kDisplay).data, rgb.data);
}

TEST(LoadImages, DropsAlpha) {
  const TemporaryFolder folder;
  WriteImage(folder / "rgba.png", WavyImage(12, 12, 4), PixelType::kUint8);
  EXPECT_EQ(LoadImages({folder / "rgba.png"})[0].image.channels, 3);
}

TEST(CenterCrop, CutsTheMiddle) {
  Image image(5, 4, 1);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = static_cast<float>(i);
  const Image crop = CenterCrop(image, 2);
  EXPECT_EQ(crop.width, 2);
  EXPECT_EQ(crop.height, 2);
  EXPECT_EQ(crop.at(0, 0), image.at(1, 1));
  EXPECT_EQ(CenterCrop(image, 0).data, image.data);
  EXPECT_EQ(CenterCrop(image, 4).width, 4);
}

}  // namespace
}  // namespace warplut
