// Reactive masks and render sizes that vary, from a sequence to shown frames.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/train/replay/pan_sequence.h"
#include "train/replay/image_views.h"
#include "train/replay/mode_run.h"

namespace warplut {
namespace {

using testing::HasSubstr;

ModeRunOptions Options(const char* method) {
  ModeRunOptions options;
  options.method = FindMethod(method);
  return options;
}

// Mean PSNR of the super-resolved frames from the third on, in dB.
double MeanPsnr(const PanOptions& pan) {
  const TemporaryFolder folder;
  const Sequence sequence = WritePan(folder / "pan", pan);
  const ModeRunOptions options = Options("sr");
  const Streams available = AvailableStreams(sequence);
  const Clip clip = LoadClip(sequence, 0, pan.frames,
                             NeededStreams(*options.method, available) | Streams::kReference);
  std::string why;
  EXPECT_TRUE(options.IsValid(clip, &why)) << why;
  ThreadPool pool(2);
  double sum = 0;
  int count = 0;
  RunMode(clip, options, pool, [&](const ShownFrame& shown) {
    if (shown.frame < 2) return;
    const Image image = ToImage(shown.image);
    const Image reference =
        ToImage(clip.frames[static_cast<std::size_t>(shown.frame)].reference.view());
    double squares = 0, values = 0;
    for (int y = 6; y < image.height - 6; ++y) {
      for (int x = 6; x < image.width - 6; ++x, ++values) {
        squares += std::pow(image.at(x, y, 1) - reference.at(x, y, 1), 2);
      }
    }
    sum -= 10 * std::log10(squares / values);
    ++count;
  });
  return sum / count;
}

TEST(MaskRun, AReactiveMaskTakesTheGhostsAway) {
  PanOptions pan = {.frames = 8, .streams = Streams::kAll | Streams::kReactive, .spot = true};
  const double with = MeanPsnr(pan);
  pan.streams = Streams::kAll;
  EXPECT_GT(with, MeanPsnr(pan) + 0.5);
}

TEST(MaskRun, RenderSizesMayVary) {
  PanOptions pan = {.frames = 8, .speed_x = 0.8, .speed_y = -0.4};
  const double large = MeanPsnr(pan);
  pan.render_sizes.assign(8, {36, 28});
  const double small = MeanPsnr(pan);
  for (std::size_t i = 0; i < 8; i += 2) pan.render_sizes[i] = pan.render;
  EXPECT_GT(MeanPsnr(pan), std::min(large, small) - 0.5);
}

TEST(MaskRun, MotionIsComposedAcrossRenderSizes) {
  const TemporaryFolder folder;
  PanOptions pan = {.frames = 5, .speed_x = 3, .speed_y = -2, .streams = Streams::kRenderGrid};
  pan.render_sizes = {{40, 32}, {30, 20}, {40, 32}, {36, 28}, {20, 16}};
  const Clip clip = LoadClip(WritePan(folder / "pan", pan), 0, 5, Streams::kRenderGrid, 2);
  for (std::size_t i : {2U, 3U, 4U}) {
    const MotionView motion = clip.frames[i].motion.view();
    ASSERT_EQ(motion.width, pan.render_sizes[i].width);
    EXPECT_NEAR(motion.Row(5)[2 * 7], 2 * 3.0 * motion.width / 80, 1e-5) << i;
    EXPECT_NEAR(motion.Row(5)[2 * 7 + 1], 2 * -2.0 * motion.height / 64, 1e-5) << i;
  }
}

TEST(MaskRun, WhatNeedsOneRenderSizeSaysSo) {
  const TemporaryFolder folder;
  PanOptions pan = {.frames = 3, .streams = Streams::kRenderGrid};
  pan.render_sizes = {{40, 32}, {30, 20}, {40, 32}};
  const Sequence sequence = WritePan(folder / "pan", pan);
  const Clip clip = LoadClip(sequence, 0, 3, Streams::kRenderGrid);
  std::string why;
  EXPECT_FALSE(Options("i").IsValid(clip, &why));
  EXPECT_THAT(why, HasSubstr("the render size of 'pan' varies"));
  EXPECT_TRUE(Options("isr").IsValid(clip, &why)) << why;
  EXPECT_TRUE(Options("bilinear").IsValid(clip, &why)) << why;
}

}  // namespace
}  // namespace warplut
