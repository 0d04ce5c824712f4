#include "train/fit/trainer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "datasets/file.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "train/fit/objective/gain_limit.h"
#include "train/fit/rivals/kaiser_family.h"
#include "train/fit/rivals/spline_family.h"
#include "train/fit/rollout/crops.h"
#include "train/fit/rollout/noise_image.h"

namespace warplut {
namespace {

std::vector<TrainImage> Images() {
  std::vector<TrainImage> images(2);
  for (std::size_t i = 0; i < images.size(); ++i) {
    FitData& record = images[i].record;
    record.name = fmt::format("noise{}.png", i);
    record.sha1 = fmt::format("{:040}", i);
    record.width = 160;
    record.height = 140;
    images[i].image = NoiseImage(record.width, record.height, i);
  }
  return images;
}

TrainOptions Small() {
  TrainOptions options;
  options.horizons = {2, 6};
  options.crops = 4;
  options.stages = 2;
  options.iterations = 4;
  return options;
}

TEST(Trainer, BeatsCatmullRomAndRecordsWhatItDid) {
  TrainOptions options = Small();
  options.iterations = 12;
  TrainResult result = Train(options, Images());
  EXPECT_FALSE(result.interrupted);
  result.fit.name = "test";
  std::string why;
  EXPECT_TRUE(result.fit.IsValid(&why)) << why;
  ASSERT_EQ(result.fit.loss.size(), 2u);
  EXPECT_LT(result.fit.loss[1].loss, 1.05);
  EXPECT_EQ(result.fit.horizons, options.horizons);
  EXPECT_EQ(result.fit.data.size(), 2u);
  // The score after the most warps.
  const auto score = [&](const std::string& filter, const std::string& offsets) {
    FitScore longest;
    for (const FitScore& s : result.fit.validation) {
      if (s.filter == filter && s.offsets == offsets && s.warps > longest.warps) longest = s;
    }
    EXPECT_GE(longest.warps, options.horizons.back()) << filter << " " << offsets;
    return longest.ssim;
  };
  EXPECT_GT(score("lut", "half"), score("catmull-rom", "half"));
  EXPECT_GT(score("lut", "random"), score("catmull-rom", "random"));
  EXPECT_GE(score("keys", "half"), score("catmull-rom", "half"));
}

TEST(Trainer, ObjectiveSrBeatsCatmullRomInItsLoopAndIsRecorded) {
  TrainOptions options = Small();
  options.objective = TrainObjective::kSr;
  options.scale = 1.3;
  options.blend_a = 0.2;
  options.blend_b = 0.8;
  options.iterations = 12;
  TrainResult result = Train(options, Images());
  result.fit.name = "test";
  std::string why;
  EXPECT_TRUE(result.fit.IsValid(&why)) << why;
  EXPECT_EQ(result.fit.objective, "sr");
  EXPECT_NE(result.fit.options.find("\"blend_a\":0.2,\"blend_b\":0.8"), std::string::npos);
  double lut = 0, catmull_rom = 0;
  for (const FitScore& score : result.fit.validation) {
    EXPECT_NE(score.offsets, "half");
    if (score.filter == "lut") lut += score.ssim;
    if (score.filter == "catmull-rom") catmull_rom += score.ssim;
  }
  EXPECT_GT(lut, catmull_rom);
}

TEST(Trainer, OfMoreTapsStaysWithinTheGainAndKeepsWhatItStartsFrom) {
  for (const Footprint footprint : {Footprint::k24, Footprint::k36}) {
    TrainOptions options = Small();
    options.footprint = footprint;
    options.prefilter = TrainPrefilter::kNone;
    TrainResult result = Train(options, Images());
    result.fit.name = "test";
    std::string why;
    EXPECT_TRUE(result.fit.IsValid(&why)) << why;
    EXPECT_EQ(result.fit.footprint, footprint);
    EXPECT_GE(result.fit.kaiser_b, kFirstKaiser);
    EXPECT_LE(result.fit.kaiser_b, kLastKaiser);
    double lut = 0, kaiser = 0, catmull_rom = 0;
    for (const FitScore& score : result.fit.validation) {
      if (score.filter == "lut") lut += score.ssim;
      if (score.filter == "kaiser6-4.5") kaiser += score.ssim;
      if (score.filter == "catmull-rom") catmull_rom += score.ssim;
    }
    EXPECT_GT(kaiser, catmull_rom);
    EXPECT_GT(lut, catmull_rom);
    ResamplerModel model(footprint, result.fit.kaiser_b);
    EXPECT_LE(LargestNodeGain(model.Forward(result.fit.parameters.data())),
              LargestGain(DefaultGainBound(options.horizons.back())) + 1e-12);
  }
}

TEST(Trainer, RefusesAGainThatNoKernelOfMoreTapsKeeps) {
  TrainOptions options = Small();
  options.footprint = Footprint::k36;
  options.prefilter = TrainPrefilter::kNone;
  options.gain_bound = 1;
  ExpectError([&] { Train(options, Images()); }, {"36 taps", "the bound of 1", "a larger one"});
}

TEST(Trainer, SameBitsForAnyNumberOfThreads) {
  TrainOptions options = Small();
  options.threads = 1;
  const auto one = Train(options, Images()).fit.parameters;
  options.threads = 3;
  EXPECT_EQ(one, Train(options, Images()).fit.parameters);
  options.seed = 2;
  EXPECT_NE(one, Train(options, Images()).fit.parameters);
}

TEST(Trainer, ResumesToTheSameBitsAfterAnInterruption) {
  const TemporaryFolder folder;
  for (const Optimizer optimizer : {Optimizer::kLbfgs, Optimizer::kAdam}) {
    TrainOptions options = Small();
    options.optimizer = optimizer;
    const auto whole = Train(options, Images()).fit.parameters;

    // Inside the first stage, at its end, inside the second.
    for (const int iterations : {1, 3, 4, 6}) {
      options.checkpoint = folder.path() / "fit.checkpoint";
      options.resume = false;
      int calls = 0;
      const auto interrupted =
          Train(options, Images(), [&](const TrainProgress&) { return ++calls < iterations; });
      EXPECT_TRUE(interrupted.interrupted);
      ASSERT_TRUE(std::filesystem::exists(options.checkpoint));
      options.resume = true;
      // Twice: what was taken up can be interrupted again.
      calls = 0;
      Train(options, Images(), [&](const TrainProgress&) { return ++calls < 2; });
      const auto resumed = Train(options, Images());
      EXPECT_FALSE(resumed.interrupted);
      EXPECT_EQ(whole, resumed.fit.parameters) << iterations;
      EXPECT_FALSE(std::filesystem::exists(options.checkpoint));
    }
  }
}

TEST(Trainer, TellsWhatATimeLimitCutAndGoesOnWithALargerOne) {
  const TemporaryFolder folder;
  TrainOptions options = Small();
  const auto whole = Train(options, Images());
  EXPECT_FALSE(whole.cut);
  EXPECT_FALSE(whole.fit.cut);
  options.checkpoint = folder.path() / "fit.checkpoint";
  // Less than any clock tells: over before the first evaluation.
  options.max_seconds = 1e-12;
  auto cut = Train(options, Images());
  EXPECT_TRUE(cut.cut);
  EXPECT_FALSE(cut.interrupted);
  ASSERT_TRUE(cut.fit.cut);
  cut.fit.name = "cut";
  WriteFit(folder / "fit.json", cut.fit);
  EXPECT_TRUE(ReadFit(folder / "fit.json").cut);
  ASSERT_TRUE(std::filesystem::exists(options.checkpoint));
  options.resume = true;
  const auto cut_again = Train(options, Images());
  EXPECT_TRUE(cut_again.cut);
  EXPECT_EQ(cut_again.fit.parameters, cut.fit.parameters);
  options.max_seconds = 1e6;
  const auto resumed = Train(options, Images());
  EXPECT_FALSE(resumed.cut);
  EXPECT_EQ(resumed.fit.parameters, whole.fit.parameters);
}

TEST(Trainer, ProgressGoesFromNothingToAll) {
  double last = 0;
  std::int64_t evaluations = 0;
  Train(Small(), Images(), [&](const TrainProgress& progress) {
    EXPECT_GE(progress.fraction, last);
    EXPECT_GT(progress.evaluations, evaluations);
    last = progress.fraction;
    evaluations = progress.evaluations;
    return true;
  });
  EXPECT_EQ(last, 1);
}

TEST(Trainer, RefusesBadDataAndForeignCheckpoints) {
  ExpectError([] { Train(Small(), {}); }, {"no training images", "expected"});
  std::vector<TrainImage> images = Images();
  images[1].image = NoiseImage(kCropSize - 1, 200, 1);
  ExpectError([&] { Train(Small(), images); }, {"noise1.png", "127 x 200", "128 x 128"});
  for (const float value : {std::numeric_limits<float>::quiet_NaN(), -0.01f, 40.0f}) {
    images = Images();
    images[0].image.at(5, 7) = value;
    ExpectError([&] { Train(Small(), images); }, {"noise0.png", "(5, 7)", "[0, 1]"});
  }
  images = Images();
  for (TrainImage& image : images) {
    std::fill(image.image.data.begin(), image.image.data.end(), 0.25f);
  }
  ExpectError([&] { Train(Small(), images); }, {"one value", "expected"});
  images[1].image.at(80, 70) = 0.5f;
  EXPECT_TRUE(std::isfinite(Train(Small(), images).fit.loss.back().validation));
  TrainOptions bad = Small();
  bad.scale = 0.5;
  ExpectError([&] { Train(bad, Images()); }, {"scale"});

  const TemporaryFolder folder;
  TrainOptions options = Small();
  options.checkpoint = folder.path() / "fit.checkpoint";
  int calls = 0;
  Train(options, Images(), [&](const TrainProgress&) { return ++calls < 6; });
  options.resume = true;
  options.seed = 99;
  ExpectError([&] { Train(options, Images()); }, {"fit.checkpoint", "seed is 1 there and 99 here"});
}

}  // namespace
}  // namespace warplut
