#include "runtime/generation/color_repair.h"

#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

TEST(ColorRepair, TexelsThatAreNoNumbersCountAsZero) {
  for (const PixelFormat format : {PixelFormat::kRgba16F, PixelFormat::kRgba32F}) {
    TestImage image(24, 12, format);
    image.Fill(0.5f);
    TestImage clean = image;
    TestMotion motion(24, 12);
    motion.Randomise(3, 2);
    image.Set(7, 5, 1, std::numeric_limits<float>::quiet_NaN());
    image.Set(15, 2, 0, -std::numeric_limits<float>::infinity());
    clean.Set(7, 5, 1, 0);
    clean.Set(15, 2, 0, 0);
    const Table wide(MakeWideTable(TableFormat::kI16, Footprint::k24).view());
    for (const WarpOptions& options :
         {WarpOptions(), WarpOptions{.filter = Filter::kLut, .table = &wide}}) {
      TestImage expected(24, 12, format), warped(24, 12, format);
      WarpReference(clean.view(), motion.view(), options, expected.view());
      WarpReference(image.view(), motion.view(), options, warped.view());
      for (int y = 0; y < 12; ++y) {
        RepairRow(image.view(), motion.view(), options, y, warped.view());
        for (int x = 0; x < 24; ++x) {
          for (int c = 0; c < 4; ++c) {
            EXPECT_NEAR(warped.Get(x, y, c), expected.Get(x, y, c), 1e-3f) << x << " " << y;
          }
        }
      }
    }
  }
}

TEST(ColorRepair, LeavesFinitePixelsAlone) {
  TestImage image(9, 3, PixelFormat::kRgba8), warped(9, 3, PixelFormat::kRgba8);
  image.Randomise(1);
  warped.Randomise(2);
  const TestImage before = warped;
  RepairRow(image.view(), TestMotion(9, 3).view(), WarpOptions(), 1, warped.view());
  EXPECT_TRUE(before == warped);
}

}  // namespace
}  // namespace warplut::generation
