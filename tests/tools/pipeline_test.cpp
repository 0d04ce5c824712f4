#include "tools/pipeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "luts/fit/fit.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

Sequence TenFrames() {
  Sequence sequence;
  sequence.name = "ten";
  sequence.first = 10;
  sequence.count = 10;
  sequence.render = {40, 32};
  sequence.output = {80, 64};
  return sequence;
}

TEST(ParseFrames, TakesNumbersOfFrames) {
  EXPECT_EQ(ParseFrames("", TenFrames()).count, 10);
  const FrameRange range = ParseFrames("12:15", TenFrames());
  EXPECT_EQ(range.first, 2);
  EXPECT_EQ(range.count, 4);
  EXPECT_EQ(ParseFrames("19:19", TenFrames()).first, 9);
}

TEST(ParseFrames, RefusesWhatIsNotThere) {
  for (const char* text : {"12", "a:b", "12:", ":12", "12:11", "12:13:14", "1.5:3"}) {
    ExpectError([&] { ParseFrames(text, TenFrames()); }, {text, "A:B"});
  }
  for (const char* text : {"9:12", "12:20"}) {
    ExpectError([&] { ParseFrames(text, TenFrames()); }, {text, "'ten' has frames 10 to 19"});
  }
}

TEST(MethodOf, ListsTheMethods) {
  EXPECT_STREQ(MethodOf("sr").name, "sr");
  ExpectError([] { MethodOf("srr"); }, {"'srr'", "sr", "isr-paper", "bicubic"});
}

TEST(Pipeline, RefusesArgumentsThatMakeNoSense) {
  ExpectError([] { CheckArguments({}); }, {"--lut FILE or --filter NAME"});
  ExpectError([] { CheckArguments({.lut = "a.json", .filter = "bilinear"}); }, {"--lut FILE"});
  ExpectError([] { CheckArguments({.filter = "lanczos"}); }, {"'lanczos'"});
  for (const float alpha : {0.0f, 1.0f}) {
    ExpectError([&] { CheckArguments({.filter = "bilinear", .alphas = {alpha}}); }, {"alpha is"});
  }
  ExpectError([] { CheckArguments({.filter = "bilinear", .generated = 0}); }, {"generated is 0"});
}

TEST(Pipeline, PutsTheArgumentsIntoOptions) {
  const PipelineArguments arguments = {
      .filter = "keys:-0.58", .generated = 3, .motion_filter = "on", .history = "rgba8"};
  const Pipeline pipeline(arguments);
  EXPECT_EQ(pipeline.filter_name(), "keys:-0.58");
  const ModeRunOptions isr = pipeline.Options(MethodOf("isr"), 2);
  EXPECT_STREQ(isr.method->name, "isr");
  EXPECT_EQ(isr.every, 2);
  EXPECT_EQ(isr.generated, 3);
  EXPECT_EQ(isr.super_resolution.warp.filter, Filter::kKeys);
  EXPECT_FLOAT_EQ(isr.generation.warp.keys_a, -0.58f);
  EXPECT_EQ(isr.super_resolution.history_format, PixelFormat::kRgba8);
  EXPECT_TRUE(isr.super_resolution.motion_filter);
  EXPECT_TRUE(pipeline.Options(MethodOf("i"), 1).generation.motion_filter);
  EXPECT_FALSE(isr.filter_quantised_motion);
  const Pipeline automatic({.filter = "bilinear"});
  EXPECT_TRUE(automatic.Options(MethodOf("sr"), 1).filter_quantised_motion);
  EXPECT_FALSE(automatic.Options(MethodOf("sr"), 1).super_resolution.motion_filter);
  const Pipeline raw({.filter = "bilinear", .motion_filter = "off"});
  EXPECT_FALSE(raw.Options(MethodOf("sr"), 1).filter_quantised_motion);
  EXPECT_FALSE(pipeline.ScaleWarning(TenFrames())) << "a kernel fits any scale";
}

TEST(Pipeline, WarnsOfAnotherScale) {
  const TemporaryFolder folder;
  Fit fit;
  fit.name = "zero";
  fit.optimizer = "lbfgs";
  fit.options = "{}";
  fit.horizons = {6};
  fit.parameters.assign(kMlpParameters, 0.0);
  fit.data = {{.name = "none.png", .sha1 = std::string(40, '0'), .width = 64, .height = 64}};
  fit.scale = 2;
  WriteFit(folder / "zero.json", fit);
  const Pipeline pipeline({.lut = folder / "zero.json"});
  EXPECT_EQ(pipeline.filter_name(), "zero");
  EXPECT_EQ(pipeline.Options(MethodOf("sr"), 1).super_resolution.warp.filter, Filter::kLut);
  Sequence sequence = TenFrames();
  EXPECT_FALSE(pipeline.ScaleWarning(sequence));
  sequence.output = {120, 96};
  const auto warning = pipeline.ScaleWarning(sequence);
  ASSERT_TRUE(warning);
  EXPECT_THAT(*warning,
              testing::AllOf(testing::HasSubstr("'zero' was fitted for x2"),
                             testing::HasSubstr("'ten' has x3"),
                             testing::HasSubstr("72 times in a jitter cycle instead of 32"),
                             testing::HasSubstr("warps are safe")));
}

}  // namespace
}  // namespace warplut
