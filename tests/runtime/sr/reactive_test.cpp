// The reactive mask: how much of the history it takes away, and that none costs nothing.
#include <random>
#include <string>

#include "tests/image_difference.h"
#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

constexpr int kWidth = 41, kHeight = 23;

SuperResolutionOptions Options() { return TestOptions(kWidth, kHeight, 70, 46); }

void Fill(ImageBuffer& mask, float value) {
  for (int y = 0; y < kHeight; ++y) {
    std::fill_n(mask.view().Row<float>(y), kWidth, value);
  }
}

// Blocks of values from 0 to 1 among values that no mask should have.
ImageBuffer RandomMask(unsigned seed) {
  ImageBuffer mask(kWidth, kHeight, PixelFormat::kR32F);
  std::mt19937 random(seed);
  const float broken[4] = {kNaN, kInfinity, -kInfinity, 2.5f};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const auto block = static_cast<unsigned>(x / 6 + 3 * (y / 5));
      mask.view().Row<float>(y)[x] =
          random() % 32 == 0 ? broken[random() % 4] : static_cast<float>(block * seed % 3) / 2;
    }
  }
  return mask;
}

TEST(Reactive, FastPassesEqualTheReference) {
  for (const MotionUpsampling motion : {MotionUpsampling::kNearest, MotionUpsampling::kDilated,
                                        MotionUpsampling::kEdgeAware, MotionUpsampling::kStatic}) {
    for (const HistoryForm form : {HistoryForm::kSample, HistoryForm::kAdaptive}) {
      SuperResolutionOptions options = Options();
      options.history_format = PixelFormat::kRgba32F;
      options.motion = motion;
      options.form = form;
      options.clamp = form == HistoryForm::kSample ? ColorClamp::kNone : ColorClamp::kVariance;
      options.reactive = true;
      SerialExecutor executor;
      SuperResolution fast(options, executor);
      options.reference = true;
      SuperResolution plain(options, executor);
      ImageBuffer fast_out = OutputOf(options), plain_out = OutputOf(options);
      TestFrame frame(kWidth, kHeight);
      for (unsigned i = 0; i < 5; ++i) {
        frame.Randomise(i, i == 2);
        const ImageBuffer mask = RandomMask(i + 1);
        RenderedFrame view = frame.View();
        if (i != 3) view.reactive = mask.view();  // a frame may come without
        fast.Process(view, fast_out.view());
        plain.Process(view, plain_out.view());
        ASSERT_LE(Compare(fast_out.view(), plain_out.view()).largest, 1e-4)
            << Name(form) << ", motion " << static_cast<int>(motion) << ", frame " << i;
      }
    }
  }
}

TEST(Reactive, AMaskOfZeroChangesNoBits) {
  for (const MotionUpsampling motion : {MotionUpsampling::kEdgeAware, MotionUpsampling::kStatic}) {
    SuperResolutionOptions options = Options();
    options.motion = motion;
    SerialExecutor executor;
    SuperResolution without(options, executor);
    options.reactive = true;
    SuperResolution with(options, executor), absent(options, executor);
    ImageBuffer a = OutputOf(options), b = OutputOf(options), c = OutputOf(options);
    ImageBuffer zero(kWidth, kHeight, PixelFormat::kR32F), nan(kWidth, kHeight, PixelFormat::kR32F);
    Fill(nan, kNaN);
    TestFrame frame(kWidth, kHeight);
    for (unsigned i = 0; i < 4; ++i) {
      frame.Randomise(i, i == 2);
      RenderedFrame view = frame.View();
      without.Process(view, a.view());
      absent.Process(view, c.view());
      view.reactive = (i == 1 ? nan : zero).view();
      with.Process(view, b.view());
      ASSERT_TRUE(SameBits(a, b)) << i;
      ASSERT_TRUE(SameBits(a, c)) << i;
    }
  }
}

TEST(Reactive, AMaskOfOneIsTheCurrentFrameAlone) {
  for (const MotionUpsampling motion : {MotionUpsampling::kEdgeAware, MotionUpsampling::kStatic}) {
    SuperResolutionOptions options = Options();
    options.motion = motion;
    options.reactive = true;
    SuperResolutionOptions alone = options;
    alone.history = false;
    SerialExecutor executor;
    SuperResolution with(options, executor), without_history(alone, executor);
    ImageBuffer a = OutputOf(options), b = OutputOf(options);
    ImageBuffer mask(kWidth, kHeight, PixelFormat::kR32F);
    Fill(mask, 1);
    TestFrame frame(kWidth, kHeight);
    for (unsigned i = 0; i < 3; ++i) {
      frame.Randomise(i);
      RenderedFrame view = frame.View();
      view.reactive = mask.view();
      with.Process(view, a.view());
      without_history.Process(view, b.view());
      ASSERT_TRUE(SameBits(a, b)) << i;
    }
  }
}

// A grey wall, and in frame 1 alone a white square of 8 x 8 samples on it.
double GreatestGhost(float reactive) {
  SuperResolutionOptions options = Options();
  options.clamp = ColorClamp::kNone;
  options.reactive = true;
  SerialExecutor executor;
  SuperResolution sr(options, executor);
  ImageBuffer out = OutputOf(options);
  for (int i = 0; i < 3; ++i) {
    TestFrame frame(kWidth, kHeight);
    ImageBuffer mask(kWidth, kHeight, PixelFormat::kR32F);
    for (int y = 8; i == 1 && y < 16; ++y) {
      for (int x = 8; x < 16; ++x) {
        frame.SetColor(x, y, 1, 1, 1);
        mask.view().Row<float>(y)[x] = reactive;
      }
    }
    RenderedFrame view = frame.View();
    view.reactive = mask.view();
    sr.Process(view, out.view());
  }
  double most = 0;
  for (int y = 0; y < options.output_height; ++y) {
    for (int x = 0; x < options.output_width; ++x) {
      most = std::max(most, std::abs(At(out, x, y, 0) - 0.5));
    }
  }
  return most;
}

TEST(Reactive, LeavesNoGhost) {
  EXPECT_GT(GreatestGhost(0), 0.1);
  EXPECT_LT(GreatestGhost(1), 1e-3);
}

// A grey history under a white frame.
TEST(Reactive, MoreOfItLeavesLessHistory) {
  double before = 1;
  for (const float reactive : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
    SuperResolutionOptions options = Options();
    options.clamp = ColorClamp::kNone;
    options.form = HistoryForm::kResidual;
    options.reactive = true;
    SerialExecutor executor;
    SuperResolution sr(options, executor);
    ImageBuffer out = OutputOf(options), mask(kWidth, kHeight, PixelFormat::kR32F);
    TestFrame grey(kWidth, kHeight), white(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) white.SetColor(x, y, 1, 1, 1);
    }
    sr.Process(grey.View(), out.view());
    Fill(mask, reactive);
    RenderedFrame view = white.View();
    view.reactive = mask.view();
    sr.Process(view, out.view());
    const double kept = 1 - At(out, 30, 20, 0);
    EXPECT_LT(kept, before) << reactive;
    before = kept;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(Reactive, IsCheckedAndAllocatesOnlyWhereItMayCome) {
  SuperResolutionOptions options = Options();
  SerialExecutor executor;
  const SuperResolution without(options, executor);
  options.reactive = true;
  const SuperResolution with(options, executor);
  EXPECT_LT(without.MemoryBytes(), with.MemoryBytes());
  const TestFrame frame(kWidth, kHeight);
  ImageBuffer out = OutputOf(options);
  ImageBuffer mask(kWidth, kHeight, PixelFormat::kR32F);
  const ImageBuffer small(kWidth - 1, kHeight, PixelFormat::kR32F);
  const ImageBuffer color(kWidth, kHeight, PixelFormat::kRgba8);
  RenderedFrame view = frame.View();
  std::string why;
  EXPECT_TRUE(with.IsProcessable(view, out.view(), &why)) << why;
  view.reactive = mask.view();
  EXPECT_TRUE(with.IsProcessable(view, out.view(), &why)) << why;
  EXPECT_FALSE(without.IsProcessable(view, out.view(), &why));
  EXPECT_NE(why.find("SuperResolutionOptions::reactive"), std::string::npos) << why;
  view.reactive = small.view();
  EXPECT_FALSE(with.IsProcessable(view, out.view(), &why));
  EXPECT_NE(why.find("reactive mask is 40 x 23; expected 41 x 23"), std::string::npos) << why;
  view.reactive = color.view();
  EXPECT_FALSE(with.IsProcessable(view, out.view(), &why));
  EXPECT_NE(why.find("reactive mask has the format rgba8; expected r32f"), std::string::npos)
      << why;
}

}  // namespace
}  // namespace warplut
