#include "tools/pictures/lut_picture.h"

#include <gtest/gtest.h>

#include <vector>

namespace warplut {
namespace {

TEST(LutPicture, ShowsTheSignOfEachTapInItsTile) {
  std::vector<Weights<float>> rows(kRows);
  rows[RowIndex(3, 5)][TapWeight(0, 1)] = 1.0f;
  rows[RowIndex(3, 5)][TapWeight(2, -1)] = -0.25f;
  const Image picture = LutPicture(Footprint::k16, rows);
  const auto at = [&](int kx, int ky, int c) {
    const int tile = kNodes * kPictureZoom + kPictureGap;
    return picture.at(kPictureGap + kx * tile + 3 * kPictureZoom,
                      kPictureGap + ky * tile + 5 * kPictureZoom, c);
  };
  EXPECT_GT(at(1, 2, 0), at(1, 2, 2)) << "positive weights are orange";
  EXPECT_LT(at(3, 0, 0), at(3, 0, 2)) << "negative weights are blue";
  for (int c = 0; c < 3; ++c) EXPECT_EQ(at(0, 0, c), 1.0f) << "zero is white";
}

}  // namespace
}  // namespace warplut
