#include "runtime/gpu/pass_work.h"

#include <gtest/gtest.h>

#include "luts/baked/warplut_iir_x2.h"
#include "luts/baked/warplut_sr_x2.h"
#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

// The published time of warping and blending, 540p to 1080p on a phone (Mob-FGSR, table 4).
constexpr double kPaperMilliseconds = 1.66;
constexpr double kBytesPerSecond = 60e9, kOperationsPerSecond = 2e12;

double Milliseconds(const TableView& view, bool warp_and_blend_alone) {
  const Table table(view);
  SuperResolutionOptions options = TestOptions(960, 540, 1920, 1080);
  options.warp = {.filter = Filter::kLut, .table = &table};
  double sum = 0;
  for (const PassWork& work : WorkOf(options)) {
    if (warp_and_blend_alone && work.pass != "predict" && work.pass != "update") continue;
    sum += RooflineMilliseconds(work, kBytesPerSecond, kOperationsPerSecond);
  }
  return sum;
}

TEST(PassWork, TheSlowerOfMemoryAndArithmeticCounts) {
  const PassWork work = {"pass", 1e6, 1, 100, 10};
  EXPECT_DOUBLE_EQ(RooflineMilliseconds(work, 1e9, 1e12), 10);
  EXPECT_DOUBLE_EQ(RooflineMilliseconds(work, 1e12, 1e9), 100);
}

TEST(PassWork, WarpingAndBlendingAreWithinThePublishedTime) {
  EXPECT_LT(Milliseconds(baked::kWarplutIirX2, true), kPaperMilliseconds);
  EXPECT_GT(Milliseconds(baked::kWarplutIirX2, false), Milliseconds(baked::kWarplutSrX2, false));
}

// Extrapolation warps one frame, interpolation two; both splat alike.
TEST(PassWork, AnExtrapolatedFrameIsLessWork) {
  const Table table(baked::kWarplutSrX2);
  FrameGenerationOptions options;
  options.width = 1920;
  options.height = 1080;
  options.warp = {.filter = Filter::kLut, .table = &table};
  const std::vector<PassWork> two = WorkOf(options, true), one = WorkOf(options, false);
  ASSERT_EQ(two.size(), one.size());
  for (std::size_t i = 0; i + 1 < two.size(); ++i) {
    EXPECT_EQ(two[i].pass, one[i].pass);
    EXPECT_EQ(two[i].bytes, one[i].bytes);
  }
  EXPECT_GT(two.back().fetches, one.back().fetches + 32);
  EXPECT_GT(two.back().operations, one.back().operations);
  EXPECT_GT(two.back().bytes, one.back().bytes);
}

}  // namespace
}  // namespace warplut
