#include "train/metrics/luma.h"

#include <gtest/gtest.h>

#include "tests/datasets/expect_error.h"

namespace warplut {
namespace {

TEST(Luma, WeighsRedGreenAndBlue) {
  EXPECT_DOUBLE_EQ(kLumaWeights[0] + kLumaWeights[1] + kLumaWeights[2], 1);
  Image image(4, 1, 3);
  image.at(0, 0, 0) = image.at(1, 0, 1) = image.at(2, 0, 2) = 1;
  for (int c = 0; c < 3; ++c) image.at(3, 0, c) = 0.5F;
  const Image luma = Luma(image);
  ASSERT_EQ(luma.channels, 1);
  for (int x = 0; x < 3; ++x) EXPECT_FLOAT_EQ(luma.at(x, 0), static_cast<float>(kLumaWeights[x]));
  EXPECT_FLOAT_EQ(luma.at(3, 0), 0.5F);
}

TEST(Luma, IgnoresAlphaAndPassesGreyThrough) {
  Image rgba(1, 1, 4);
  rgba.data = {0.2F, 0.2F, 0.2F, 0.9F};
  EXPECT_FLOAT_EQ(Luma(rgba).data[0], 0.2F);
  Image grey(2, 1, 1);
  grey.data = {0.1F, 7};
  EXPECT_EQ(Luma(grey).data, grey.data);
}

TEST(Luma, RefusesOtherChannels) {
  ExpectError([] { Luma(Image(2, 2, 2)); }, {"2 channels"});
  ExpectError([] { Luma(Image()); }, {"0 channels"});
}

}  // namespace
}  // namespace warplut
