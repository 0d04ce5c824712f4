#include "tools/judge/image_set.h"

#include <gtest/gtest.h>

#include <limits>

#include "datasets/hash.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/test_images.h"

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
  ExpectError([&] { LoadImages({folder / "bright.exr"}); }, {"bright.exr", "1.5", "[0, 1]"});
  bright.data[7] = std::numeric_limits<float>::quiet_NaN();
  WriteImage(folder / "unknown.exr", bright, PixelType::kFloat);
  ExpectError([&] { LoadImages({folder / "unknown.exr"}); }, {"unknown.exr", "nan", "finite"});
  const std::string file = WriteWavyImage(folder / "a.png", 20, 10);
  ExpectError([&] { LoadImages({file, file}); }, {"a.png", "twice"});
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
