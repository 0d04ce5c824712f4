#include "runtime/motion_tiles.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/runtime/warp/warp_fixture.h"

namespace warplut {
namespace {

constexpr int kWidth = 2 * kTileWidth + 5;
constexpr int kHeight = kTileHeight + 3;

TEST(MotionTiles, CoversTheImage) {
  const MotionTiles tiles(TestMotion(kWidth, kHeight).view());
  EXPECT_EQ(tiles.columns(), 3);
  EXPECT_EQ(tiles.rows(), 2);
}

TEST(MotionTiles, ClassifiesEachTile) {
  TestMotion motion(kWidth, kHeight, 0, 0, 6);
  for (int y = 0; y < kTileHeight; ++y) {
    for (int x = 0; x < kTileWidth; ++x) {
      motion.Set(x, y, 3, -2);
      motion.Set(x + kTileWidth, y, 0.5f, 1);
    }
  }
  motion.Set(kWidth - 1, kHeight - 1, 0, 1e-6f);
  motion.Set(1, kTileHeight, -0.0f, 0.0f);
  const MotionTiles tiles(motion.view());
  EXPECT_EQ(tiles.At(0, 0).kind, MotionKind::kWhole);
  EXPECT_EQ(tiles.At(0, 0).x, 3);
  EXPECT_EQ(tiles.At(0, 0).y, -2);
  EXPECT_EQ(tiles.At(1, 0).kind, MotionKind::kUniform);
  EXPECT_EQ(tiles.At(2, 0).kind, MotionKind::kStatic);
  EXPECT_EQ(tiles.At(0, 1).kind, MotionKind::kStatic);
  EXPECT_EQ(tiles.At(2, 1).kind, MotionKind::kGeneral);
}

TEST(MotionTiles, MotionThatIsNotFiniteIsGeneral) {
  for (const float m :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(MotionTiles(TestMotion(3, 3, m, 0).view()).At(0, 0).kind, MotionKind::kGeneral);
    EXPECT_EQ(MotionTiles(TestMotion(3, 3, 0, m).view()).At(0, 0).kind, MotionKind::kGeneral);
  }
}

}  // namespace
}  // namespace warplut
