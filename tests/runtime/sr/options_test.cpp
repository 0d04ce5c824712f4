#include <functional>
#include <string>
#include <vector>

#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

struct BadOption {
  std::function<void(SuperResolutionOptions&)> spoil;
  const char* named;  // in the sentence
};

TEST(SuperResolutionOptions, RefuseWhatIsOutOfRangeWithASentence) {
  const std::vector<BadOption> bad = {
      {[](auto& o) { o.render_width = 0; }, "render size is 0 x 4"},
      {[](auto& o) { o.output_width = 7; }, "output size is 7 x 8"},
      {[](auto& o) { o.output_height = 17; }, "output size is 16 x 17"},
      {[](auto& o) { o.history_format = PixelFormat::kR32F; }, "history format is r32f"},
      {[](auto& o) { o.gate_width = 1.5f; }, "gate width is 1.5"},
      {[](auto& o) { o.gate_width = kNaN; }, "gate width is nan"},
      {[](auto& o) { o.warp.filter = Filter::kLut; }, "no table"},
      {[](auto& o) { o.parameters.blend_a = -1; }, "blend_a is -1"},
  };
  for (const BadOption& b : bad) {
    SuperResolutionOptions options = TestOptions(8, 4, 16, 8);
    std::string why;
    ASSERT_TRUE(options.IsValid(&why)) << why;
    b.spoil(options);
    EXPECT_FALSE(options.IsValid(&why));
    EXPECT_NE(why.find(b.named), std::string::npos) << why;
    EXPECT_FALSE(options.IsValid());
  }
}

struct BadFrame {
  std::function<void(RenderedFrame&, MutableImageView&)> spoil;
  const char* named;
};

TEST(SuperResolution, RefusesFramesThatDoNotFitWithASentence) {
  const std::vector<BadFrame> bad = {
      {[](auto& f, auto&) { f.color.data = nullptr; }, "colour has no data"},
      {[](auto& f, auto&) { f.color.width = 7; }, "colour is 7 x 4; expected 8 x 4"},
      {[](auto& f, auto&) { f.color.format = PixelFormat::kR32F; },
       "colour has the format r32f; expected"},
      {[](auto& f, auto&) { f.color.stride = 8; }, "colour has a stride of 8 bytes"},
      {[](auto& f, auto&) { f.depth.height = 5; }, "depth is 8 x 5; expected 8 x 4"},
      {[](auto& f, auto&) { f.depth.format = PixelFormat::kRgba8; },
       "depth has the format rgba8; expected r32f"},
      {[](auto& f, auto&) { f.motion.xy = nullptr; }, "motion has no data"},
      {[](auto& f, auto&) { f.motion.stride = 8 * 4; }, "motion has a stride of 32 bytes"},
      {[](auto& f, auto&) { f.jitter_x = 1.25f; }, "jitter is (1.25"},
      {[](auto& f, auto&) { f.jitter_y = kNaN; }, "jitter is"},
      {[](auto&, auto& out) { out.width = 8; }, "output is 8 x 8; expected 16 x 8"},
      {[](auto&, auto& out) { out.stride += 1; }, "output has a stride"},
  };
  const SuperResolutionOptions options = TestOptions(8, 4, 16, 8);
  SerialExecutor executor;
  const SuperResolution sr(options, executor);
  const TestFrame frame(8, 4);
  ImageBuffer out = OutputOf(options);
  for (const BadFrame& b : bad) {
    RenderedFrame view = frame.View();
    MutableImageView out_view = out.view();
    std::string why;
    ASSERT_TRUE(sr.IsProcessable(view, out_view, &why)) << why;
    b.spoil(view, out_view);
    EXPECT_FALSE(sr.IsProcessable(view, out_view, &why)) << b.named;
    EXPECT_NE(why.find(b.named), std::string::npos) << why;
  }
}

TEST(SuperResolution, MemoryIsFarBelowSixImagesOfTheOutput) {
  const SuperResolutionOptions options = TestOptions(960, 540, 1920, 1080);
  SerialExecutor executor;
  const SuperResolution sr(options, executor);
  const std::size_t image = std::size_t{1920} * 1080 * 8;
  EXPECT_LT(sr.MemoryBytes(), 4 * image);
  EXPECT_GT(sr.MemoryBytes(), 2 * image);
}

}  // namespace
}  // namespace warplut
