#include "luts/bake/exr.h"

#include <gtest/gtest.h>

#include "datasets/images/image_io.h"
#include "tests/luts/test_fits.h"

namespace warplut {
namespace {

TEST(Exr, IsReadBackByOpenImageIO) {
  Image image(7, 5, 1);
  for (std::size_t i = 0; i < image.data.size(); ++i)
    image.data[i] = 0.1f * static_cast<float>(i) - 1;
  const std::filesystem::path path = TestFolder() / "image.exr";
  WriteFile(path, EncodeExr(image));
  const Image read = ReadImage(path, {"Y"});
  EXPECT_EQ(read.width, 7);
  EXPECT_EQ(read.height, 5);
  EXPECT_EQ(read.channels, 1);
  EXPECT_EQ(read.data, image.data);
}

}  // namespace
}  // namespace warplut
