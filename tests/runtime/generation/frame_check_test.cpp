#include "runtime/generation/frame_check.h"

#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

std::string Refusal(const FrameGenerationOptions& options) {
  std::string why;
  EXPECT_FALSE(options.IsValid(&why));
  EXPECT_FALSE(options.IsValid());
  return why;
}

TEST(FrameGenerationOptions, AreChecked) {
  const TestFrame frame(8, 4, PixelFormat::kRgba8);
  const FrameGenerationOptions good = OptionsFor(frame);
  EXPECT_TRUE(good.IsValid());
  FrameGenerationOptions bad = good;
  bad.height = 0;
  EXPECT_EQ(Refusal(bad), "The frames are 8 x 0; expected 1 to 1048576 pixels in each axis.");
  bad = good;
  bad.width = bad.height = 1 << 16;
  EXPECT_EQ(Refusal(bad), "The frames are 65536 x 65536; expected less than 2^31 pixels.");
  bad = good;
  bad.gate_width = 1.5f;
  EXPECT_EQ(Refusal(bad), "gate_width is 1.500000; expected 0 to 1.");
  bad = good;
  bad.motion_filter_limit = 0;
  EXPECT_TRUE(bad.IsValid());
  bad.motion_filter = true;
  EXPECT_FALSE(Refusal(bad).empty());
  bad = good;
  bad.warp.filter = Filter::kLut;
  EXPECT_EQ(Refusal(bad), "Warp: the lut filter has no table.");
  bad = good;
  bad.parameters.generation_depth_threshold = -1;
  EXPECT_NE(Refusal(bad).find("generation_depth_threshold"), std::string::npos);
}

class FrameCheck : public testing::Test {
 protected:
  std::string Refusal() {
    std::string why;
    EXPECT_FALSE(AreGenerable(options_, view0_, view1_, alpha_, out_, &why));
    EXPECT_FALSE(AreGenerable(options_, view0_, view1_, alpha_, out_, nullptr));
    return why;
  }

  TestFrame frame_{8, 4, PixelFormat::kRgba8};
  TestImage image_{8, 4, PixelFormat::kRgba16F};
  FrameGenerationOptions options_ = OptionsFor(frame_);
  DisplayedFrame view0_ = frame_.view(), view1_ = frame_.view();
  MutableImageView out_ = image_.view();
  float alpha_ = 0.5f;
};

TEST_F(FrameCheck, TakesWhatFits) {
  std::string why;
  EXPECT_TRUE(AreGenerable(options_, view0_, view1_, alpha_, out_, &why)) << why;
  view0_.color = {};
  EXPECT_TRUE(AreGenerable(options_, view0_, view1_, alpha_, out_, &why)) << why;
}

TEST_F(FrameCheck, RefusesAlphaOutside) {
  for (const float alpha : {0.0f, 1.0f, -0.5f, std::nanf("")}) {
    alpha_ = alpha;
    EXPECT_NE(Refusal().find("alpha is "), std::string::npos);
  }
}

TEST_F(FrameCheck, RefusesMissingData) {
  view1_.color.data = nullptr;
  EXPECT_EQ(Refusal(), "The colour of frame 1 has no data.");
  view1_ = frame_.view();
  view1_.motion.xy = nullptr;
  EXPECT_EQ(Refusal(), "The motion of frame 1 has no data.");
}

TEST_F(FrameCheck, RefusesOtherSizes) {
  view0_.depth.width = 7;
  EXPECT_EQ(Refusal(), "The depth of frame 0 is 7 x 4; expected 8 x 4.");
  view0_ = frame_.view();
  view0_.motion.height = 5;
  EXPECT_EQ(Refusal(), "The motion of frame 0 is 8 x 5; expected 8 x 4.");
}

TEST_F(FrameCheck, RefusesOtherFormats) {
  out_.format = PixelFormat::kR32F;
  EXPECT_EQ(Refusal(), "The output has the format r32f; expected rgba8, rgba16f or rgba32f.");
  out_ = image_.view();
  view1_.depth.format = PixelFormat::kRgba8;
  EXPECT_EQ(Refusal(), "The depth of frame 1 has the format rgba8; expected r32f.");
}

TEST_F(FrameCheck, RefusesShortStrides) {
  out_.stride = 8 * 8 - 2;
  EXPECT_EQ(Refusal(),
            "The output has a stride of 62 bytes; expected at least a row of whole channels.");
  out_ = image_.view();
  view0_.motion.stride = 8 * 8 + 2;
  EXPECT_EQ(
      Refusal(),
      "The motion of frame 0 has a stride of 66 bytes; expected at least a row of whole floats.");
}

}  // namespace
}  // namespace warplut::generation
