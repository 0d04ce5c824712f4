#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "datasets/error.h"
#include "tools/report/budget/budget_generation.h"
#include "tools/report/budget/budget_motion.h"
#include "tools/report/budget/budget_super_resolution.h"
#include "train/fit/rollout/noise_image.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Image Colors(const Image& luma) {
  Image image(luma.width, luma.height, 3);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = luma.data[i / 3];
  return image;
}

Image Uniform(int width, int height, std::vector<float> value) {
  Image image(width, height, static_cast<int>(value.size()));
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = value[i % value.size()];
  return image;
}

// Noise that moves to the right by `speed` pixels per frame, at constant depth; motion over `every`
// frames.
Clip PanClip(int speed, int every) {
  constexpr int kFrames = 7, kWidth = 96, kHeight = 40;
  const Image world = NoiseImage(kWidth + kFrames * speed, kHeight, 3);
  Clip clip;
  clip.name = "pan";
  clip.render = clip.output = {kWidth, kHeight};
  for (int f = 0; f < kFrames; ++f) {
    Image luma(kWidth, kHeight, 1);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) luma.at(x, y) = world.at(x + (kFrames - f) * speed, y);
    }
    ClipFrame& frame = clip.frames.emplace_back();
    frame.number = f;
    frame.color = ToBuffer(Colors(luma), PixelFormat::kRgba32F);
    frame.reference = ToBuffer(Colors(luma), PixelFormat::kRgba32F);
    const Image motion = Uniform(kWidth, kHeight, {static_cast<float>(speed * every), 0});
    const Image depth = Uniform(kWidth, kHeight, {0.5f});
    frame.motion = ToMotionBuffer(motion);
    frame.reference_motion = ToMotionBuffer(motion);
    frame.depth = ToBuffer(depth, PixelFormat::kR32F);
    frame.reference_depth = ToBuffer(depth, PixelFormat::kR32F);
  }
  return clip;
}

FrameGenerationOptions GenerationOptions(const Clip& clip) {
  FrameGenerationOptions options;
  options.width = clip.output.width;
  options.height = clip.output.height;
  return options;
}

double Sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(ErrorBudget, SharesAddUpToTheWhole) {
  ErrorBudget budget;
  for (const double error : {4.0, 5.0, 2.0, 0.5}) {
    budget.rungs.emplace_back().mean_squared_error = error;
  }
  EXPECT_EQ(budget.Shares(), (std::vector<double>{-0.25, 0.75, 0.375, 0.125}));
  EXPECT_DOUBLE_EQ(Sum(budget.Shares()), 1);
}

TEST(ErrorBudget, WithoutErrorNothingHasAShare) {
  ErrorBudget budget;
  budget.rungs.resize(3);
  EXPECT_EQ(budget.Shares(), (std::vector<double>{0, 0, 0}));
}

TEST(ErrorBudget, MeanCountsClipsAlike) {
  std::vector<ErrorBudget> budgets(2);
  budgets[0].frames = 1;
  budgets[0].rungs.emplace_back().mean_squared_error = 0.01;
  budgets[1].frames = 9;
  budgets[1].rungs.emplace_back().mean_squared_error = 0.03;
  const ErrorBudget mean = MeanBudget("mean", budgets);
  EXPECT_EQ(mean.frames, 10);
  EXPECT_DOUBLE_EQ(mean.rungs[0].mean_squared_error, 0.02);
  EXPECT_NEAR(mean.rungs[0].psnr, -10 * std::log10(0.02), 1e-12);
}

TEST(ErrorBudget, NeedsAFrame) { EXPECT_THROW(BudgetSum("empty").Finish(), Error); }

TEST(BudgetMotion, StorageRoundsToItsSteps) {
  for (const float m : {-37.3f, -0.4f, 0.0f, 1.7f, 51.9f}) {
    EXPECT_NEAR(StoredMotion(m, 960, MotionStorage::kBytes), m, 1.01 * 960 / 65025);
    EXPECT_NEAR(StoredMotion(m, 960, MotionStorage::kHalf), m, 1.01 * 960 / 2048);
  }
  EXPECT_EQ(StoredMotion(0, 960, MotionStorage::kHalf), 0);
  EXPECT_TRUE(std::isnan(StoredMotion(kNan, 960, MotionStorage::kHalf)));
}

TEST(BudgetMotion, ForwardMotionOfAPanIsThePan) {
  const Clip clip = PanClip(5, 1);
  const FrameGeometry geometry = {clip.frames[0].reference_depth.view(),
                                  clip.frames[0].reference_motion.view()};
  const ForwardMotion forward = ForwardMotionOf(geometry, geometry);
  for (int x = 0; x < clip.output.width; ++x) {
    const bool stays = x + 5 < clip.output.width;
    ASSERT_EQ(forward.known[static_cast<std::size_t>(x)] != 0, stays) << x;
    if (stays) {
      EXPECT_NEAR(forward.motion.view().Row(0)[2 * x], -5, 1e-5);
      EXPECT_NEAR(forward.motion.view().Row(0)[2 * x + 1], 0, 1e-5);
    }
  }
}

TEST(BudgetMotion, WhatIsHiddenHasNoForwardMotion) {
  // A near square at rest before a far pan: what the pan moves behind the square is not known.
  Image motion = Uniform(64, 32, {4, 0}), depth = Uniform(64, 32, {0.8f});
  for (int y = 8; y < 24; ++y) {
    for (int x = 30; x < 40; ++x) {
      motion.at(x, y, 0) = 0;
      depth.at(x, y) = 0.2f;
    }
  }
  const MotionBuffer m = ToMotionBuffer(motion);
  const ImageBuffer d = ToBuffer(depth, PixelFormat::kR32F);
  const ForwardMotion forward = ForwardMotionOf({d.view(), m.view()}, {d.view(), m.view()});
  const auto known = [&](int x) { return forward.known[16 * 64 + static_cast<std::size_t>(x)]; };
  EXPECT_EQ(known(20), 1);
  for (int x = 26; x < 30; ++x) EXPECT_EQ(known(x), 0) << x;
  EXPECT_EQ(known(35), 1);
  EXPECT_EQ(known(45), 1);
}

TEST(BudgetImages, BestBlendFindsThePlantedShare) {
  const Image a = Colors(NoiseImage(24, 20, 1)), b = Colors(NoiseImage(24, 20, 2));
  Image reference = a;
  for (std::size_t i = 0; i < a.data.size(); ++i) {
    reference.data[i] += 0.3f * (b.data[i] - a.data[i]);
  }
  for (const int radius : {0, 3}) {
    const Image best = BestBlend(a, b, reference, radius);
    for (std::size_t i = 0; i < best.data.size(); ++i) {
      ASSERT_NEAR(best.data[i], reference.data[i], 1e-5);
    }
  }
}

TEST(BudgetImages, LocalErrorSeesShadingAndNotDetail) {
  const Image reference = Uniform(32, 32, {0.5f, 0.5f, 0.5f});
  Image shaded = reference, detailed = reference;
  for (std::size_t i = 0; i < shaded.data.size(); ++i) {
    shaded.data[i] += 0.05f;
    detailed.data[i] += (i / 3) % 2 == 0 ? 0.05f : -0.05f;
  }
  const PixelMask all(32 * 32, 1), none(32 * 32, 0);
  EXPECT_GT(LocalLumaError(shaded, reference, all).at(16, 16), kShadingChange);
  EXPECT_LT(std::abs(LocalLumaError(detailed, reference, all).at(16, 16)), kShadingChange);
  EXPECT_EQ(LocalLumaError(shaded, reference, none).at(16, 16), 0);
}

// 15 pixels are a share of 1 / 128 of the stored display's width, which halves hold, and whole
// pixels need no resampling.
TEST(GenerationBudget, WholePanLosesOnlyWhatIsDisoccluded) {
  const Clip dense = PanClip(15, 1), sparse = PanClip(15, 2);
  SerialExecutor executor;
  for (const Generation generation : {Generation::kInterpolation, Generation::kExtrapolation}) {
    const ErrorBudget budget =
        GenerationBudget(dense, sparse, generation, GenerationOptions(dense), executor);
    ASSERT_EQ(static_cast<int>(budget.rungs.size()), GenerationPlan(generation).rungs());
    EXPECT_EQ(budget.rungs[0].mean_squared_error,
              budget.rungs[kExactMotionRung].mean_squared_error);
    EXPECT_LT(budget.rungs.back().mean_squared_error, 1e-12);
    const std::vector<double> shares = budget.Shares();
    if (generation == Generation::kExtrapolation) {
      EXPECT_NEAR(Sum(shares), 1, 1e-12);
      EXPECT_GT(shares[kExactMotionRung], 0.99);
      EXPECT_LT(budget.rungs[kExactMotionRung + 1].mean_squared_error, 1e-12);
    }
  }
}

TEST(GenerationBudget, LeavesOutWhatACutDivides) {
  Clip dense = PanClip(15, 1), sparse = PanClip(15, 2);
  for (Clip* clip : {&dense, &sparse}) {
    for (ClipFrame& frame : clip->frames) frame.cut = true;
  }
  SerialExecutor executor;
  EXPECT_THROW(GenerationBudget(dense, sparse, Generation::kInterpolation, GenerationOptions(dense),
                                executor),
               Error);
}

TEST(SuperResolutionBudget, WholePanOnTheOutputGridNeedsNoWarp) {
  const Clip clip = PanClip(15, 1);
  SuperResolutionOptions options;
  options.render_width = options.output_width = clip.output.width;
  options.render_height = options.output_height = clip.output.height;
  SerialExecutor executor;
  const ErrorBudget budget = SuperResolutionBudget(clip, options, executor);
  EXPECT_EQ(budget.frames, 6);
  ASSERT_EQ(static_cast<int>(budget.rungs.size()), SuperResolutionPlan().rungs());
  EXPECT_EQ(budget.rungs[0].mean_squared_error, budget.rungs[kExactMotionRung].mean_squared_error);
  EXPECT_LT(budget.rungs.back().mean_squared_error, 1e-10);
}

}  // namespace
}  // namespace warplut
