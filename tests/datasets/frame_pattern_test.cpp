#include "datasets/sequence/frame_pattern.h"

#include <gtest/gtest.h>

namespace warplut {
namespace {

TEST(FramePattern, FormatsAsPrintf) {
  EXPECT_EQ(FrameFileName("lr/color/%04d.png", 7), "lr/color/0007.png");
  EXPECT_EQ(FrameFileName("%04d.png", 12345), "12345.png");
  EXPECT_EQ(FrameFileName("%d", 0), "0");
  EXPECT_EQ(FrameFileName("a%3d", 7), "a  7");
  EXPECT_EQ(FrameFileName("100%%_%02d", 3), "100%_03");
}

TEST(FramePattern, TakesOneConversionBelowTheFolder) {
  for (const char* good : {"%d", "%4d", "%04d.exr", "a/b..c/%d", "%%%d"})
    EXPECT_TRUE(IsFramePattern(good)) << good;
  for (const char* bad :
       {"", "a.png", "%d%d", "%s", "%n%d", "%-4d", "%0d", "%012d", "%ld", "%", "%d%", "/%d",
        "../%d", "a/../%d", "./%d", "a//%d", "%d/", "a\\%d", "a\n%d"}) {
    std::string why;
    EXPECT_FALSE(IsFramePattern(bad, &why)) << bad;
    EXPECT_NE(why.find("expected"), std::string::npos) << why;
  }
}

TEST(FramePattern, MayBeginWithAsManyLevelsUpAsAllowed) {
  for (const char* good : {"../%d", "../../a/%d", "a/%d"}) {
    EXPECT_TRUE(IsFramePattern(good, nullptr, 2)) << good;
  }
  for (const char* bad : {"../../../%d", "a/../%d", "../a/../%d", "/../%d", ".././%d", "..//%d"}) {
    std::string why;
    EXPECT_FALSE(IsFramePattern(bad, &why, 2)) << bad;
    EXPECT_NE(why.find("at most 2 '..'"), std::string::npos) << why;
  }
}

}  // namespace
}  // namespace warplut
