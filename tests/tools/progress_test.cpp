#include "tools/terminal/progress.h"

#include <gtest/gtest.h>

namespace warplut {
namespace {

TEST(ProgressLine, TellsShareRateAndTimeLeft) {
  EXPECT_EQ(ProgressLine("warping", 10, 40, "frames", 5, ""),
            "warping 10/40 frames  25 %  2 frames/s  15 s left");
  EXPECT_EQ(ProgressLine("training", 0.5, 1, "", 300, "loss 0.1"),
            "training  50 %  5 min 00 s left  loss 0.1");
  EXPECT_EQ(ProgressLine("warping", 0, 40, "frames", 0, ""), "warping 0/40 frames  0 %");
}

TEST(Progress, IsSilentWhereNobodyLooks) {
  testing::internal::CaptureStderr();
  {
    Progress progress("warping", 2, "frames");
    progress.Add(1);
    progress.Update(2);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace warplut
