#include "train/fit/rollout/crops.h"

#include <gtest/gtest.h>

#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

TEST(Crops, ArePiecesOfTheImagesInTurn) {
  Image ramp(kCropSize + 40, kCropSize + 10, 1);
  for (int y = 0; y < ramp.height; ++y) {
    for (int x = 0; x < ramp.width; ++x) ramp.at(x, y) = 0.02f * (x % 37) + 0.001f * y;
  }
  const auto crops = DrawCrops({ramp, NoiseImage(kCropSize, kCropSize, 1)}, 4, 9);
  ASSERT_EQ(crops.size(), 4u);
  const Image noise = NoiseImage(kCropSize, kCropSize, 1);
  EXPECT_EQ(crops[1].row(5)[7], noise.at(7, 5));
  EXPECT_EQ(crops[3].row(100)[90], noise.at(90, 100));
  EXPECT_EQ(crops[0].row(-1)[-2], crops[0].row(0)[0]);
}

TEST(Crops, SameSeedSameCropsAndFlatPlacesAreLeftOut) {
  Image image(600, 300, 1);
  const Image noise = NoiseImage(600, 300, 3);
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 600; ++x) image.at(x, y) = y < 150 ? 0.5f : noise.at(x, y);
  }
  const auto a = DrawCrops({image}, 12, 4);
  const auto b = DrawCrops({image}, 12, 4);
  const auto c = DrawCrops({image}, 12, 5);
  int different = 0;
  for (int i = 0; i < 12; ++i) {
    EXPECT_EQ(a[i].row(60)[60], b[i].row(60)[60]);
    different += a[i].row(kCropSize - 1)[3] != c[i].row(kCropSize - 1)[3];
    EXPECT_NE(a[i].row(kCropSize - 1)[3], 0.5f) << "a crop of the flat half";
  }
  EXPECT_GT(different, 6);
}

}  // namespace
}  // namespace warplut
