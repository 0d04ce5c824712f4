#include "train/replay/mode_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/datasets/temporary_folder.h"
#include "tests/train/replay/pan_sequence.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Shown {
  double time;
  bool generated;
  int frame;
  Image image;
};

class ModeRunTest : public testing::Test {
 protected:
  Clip Load(int every = 1, const PanOptions& pan = {}, Streams which = Streams::kAll) const {
    return LoadClip(WritePan(folder_ / "pan", pan), 0, pan.frames, which, every);
  }

  static ModeRunOptions Options(const char* method, int every = 1) {
    ModeRunOptions options;
    options.method = FindMethod(method);
    options.every = every;
    return options;
  }

  static std::vector<Shown> Run(const Clip& clip, const ModeRunOptions& options, int threads = 2) {
    std::string why;
    EXPECT_TRUE(options.IsValid(clip, &why)) << why;
    ThreadPool pool(threads);
    std::vector<Shown> all;
    RunMode(clip, options, pool, [&](const ShownFrame& shown) {
      EXPECT_GE(shown.seconds, 0);
      all.push_back({shown.time, shown.generated, shown.frame, ToImage(shown.image)});
    });
    return all;
  }

  static std::vector<double> Times(const std::vector<Shown>& all) {
    std::vector<double> times;
    for (const Shown& shown : all) times.push_back(shown.time);
    return times;
  }

  // Without the border, where what comes in is not known.
  static double Psnr(const Image& a, const Image& b) {
    constexpr int kBorder = 6;
    double sum = 0;
    int count = 0;
    for (int y = kBorder; y < a.height - kBorder; ++y) {
      for (int x = kBorder; x < a.width - kBorder; ++x, ++count) {
        for (int c = 0; c < 3; ++c) {
          sum += std::pow(static_cast<double>(a.at(x, y, c)) - b.at(x, y, c), 2) / 3;
        }
      }
    }
    return -10 * std::log10(sum / count);
  }

  static Image Reference(const Clip& clip, int frame) {
    return ToImage(clip.frames[static_cast<std::size_t>(frame)].reference.view());
  }

  const TemporaryFolder folder_;
};

TEST_F(ModeRunTest, QuantisedMotionIsFilteredOnceIfAsked) {
  Clip clip = Load();
  EXPECT_FALSE(HasQuantisedMotion(clip));
  clip.quantised_motion = true;
  EXPECT_FALSE(EffectiveSuperResolution(clip, Options("sr")).motion_filter);
  for (const bool quantised : {true, false}) {
    clip.quantised_motion = quantised;
    ModeRunOptions i = Options("i"), isr = Options("isr");
    i.filter_quantised_motion = isr.filter_quantised_motion = true;
    EXPECT_EQ(EffectiveGeneration(clip, i).motion_filter, quantised);
    EXPECT_EQ(EffectiveSuperResolution(clip, isr).motion_filter, quantised);
    EXPECT_FALSE(EffectiveGeneration(clip, isr).motion_filter) << "its motion comes filtered";
  }
}

TEST_F(ModeRunTest, RepeatAndAverageAreWhatTheySay) {
  const Clip clip = Load(2);
  const auto repeated = Run(clip, Options("repeat", 2));
  EXPECT_THAT(Times(repeated), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_EQ(repeated[1].image.data, Reference(clip, 0).data);
  EXPECT_EQ(repeated[1].frame, 1);
  EXPECT_TRUE(repeated[1].generated);
  EXPECT_FALSE(repeated[2].generated);
  const auto averaged = Run(clip, Options("average", 2));
  const Image before = Reference(clip, 0), after = Reference(clip, 2);
  const Image& between = averaged[1].image;
  for (std::size_t i = 0; i < between.data.size(); ++i) {
    EXPECT_NEAR(between.data[i], (before.data[i] + after.data[i]) / 2, 0.5 / 255 + 1e-6);
  }
}

TEST_F(ModeRunTest, ShowsFramesInTheOrderOfTime) {
  const Clip clip = Load(1);
  ModeRunOptions options = Options("average");
  options.generated = 3;
  auto shown = Run(clip, options);
  EXPECT_EQ(shown.size(), 6U + 5 * 3);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_DOUBLE_EQ(shown[i].time, 0.25 * static_cast<double>(i));
    EXPECT_EQ(shown[i].frame, i % 4 == 0 ? static_cast<int>(i / 4) : -1);
    EXPECT_EQ(shown[i].generated, i % 4 != 0);
  }
  options.alphas = {0.125f, 0.75f};
  shown = Run(clip, options);
  EXPECT_EQ(shown.size(), 6U + 5 * 2);
  EXPECT_DOUBLE_EQ(shown[1].time, 0.125);
  EXPECT_DOUBLE_EQ(shown[2].time, 0.75);
  // Thirds of three frames fall on frames.
  options = Options("repeat", 3);
  options.generated = 2;
  shown = Run(Load(3), options);
  EXPECT_THAT(Times(shown), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(shown[2].frame, 2);
}

TEST_F(ModeRunTest, ExtrapolationGoesOnAfterTheLastRenderedFrame) {
  const auto shown = Run(Load(2), Options("e", 2));
  EXPECT_THAT(Times(shown), ElementsAre(0, 2, 3, 4, 5));
  EXPECT_TRUE(shown[4].generated);
  EXPECT_EQ(shown[4].frame, 5);
  EXPECT_THAT(Times(Run(Load(1), Options("e"))).back(), 5.5);
}

TEST_F(ModeRunTest, EveryMethodFollowsThePan) {
  const Clip dense = Load(1), sparse = Load(2);
  const auto bicubic = Run(dense, Options("bicubic"));
  for (const MethodInfo& method : Methods()) {
    const bool generates = method.generation != Generation::kNone;
    const Clip& clip = generates ? sparse : dense;
    const auto shown = Run(clip, Options(method.name, generates ? 2 : 1));
    for (const Shown& one : shown) {
      ASSERT_EQ(one.image.width, 80) << method.name;
      ASSERT_EQ(one.image.height, 64) << method.name;
      if (method.generator != Generator::kWarped || one.time < 2 || one.frame < 0) continue;
      EXPECT_GT(Psnr(one.image, Reference(clip, one.frame)), 20) << method.name << one.time;
    }
  }
  const auto sr = Run(dense, Options("sr"));
  EXPECT_GT(Psnr(sr[5].image, Reference(dense, 5)), Psnr(bicubic[5].image, Reference(dense, 5)));
}

TEST_F(ModeRunTest, TheMotionOfTheFirstFrameIsNotTrusted) {
  const PanOptions pan = {.frames = 4, .speed_x = 8};
  PanOptions still = pan;
  still.still_first_motion = true;
  for (const int every : {1, 2}) {
    const Clip moving = Load(every, pan), clip = Load(every, still);
    for (const MethodInfo& method : Methods()) {
      const auto expected = Run(moving, Options(method.name, every));
      const auto shown = Run(clip, Options(method.name, every));
      ASSERT_EQ(shown.size(), expected.size());
      for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_EQ(shown[i].image.data, expected[i].image.data) << method.name << " " << i;
      }
    }
  }
  const auto between = Run(Load(1, still), Options("i"));
  const Pan texture(pan);
  const auto psnr = [&](std::size_t i) {
    Image exact(pan.output.width, pan.output.height, 3);
    for (int y = 0; y < exact.height; ++y) {
      for (int x = 0; x < exact.width; ++x) {
        for (int c = 0; c < 3; ++c) {
          exact.at(x, y, c) = texture.At(x + 0.5, y + 0.5, between[i].time, c);
        }
      }
    }
    return Psnr(between[i].image, exact);
  };
  EXPECT_NEAR(psnr(1), psnr(3), 1);
  EXPECT_GT(psnr(1), 35);
}

TEST_F(ModeRunTest, TheSameBitsForAnyNumberOfThreads) {
  const Clip dense = Load(1), sparse = Load(2);
  for (const MethodInfo& method : Methods()) {
    const bool generates = method.generation != Generation::kNone;
    const ModeRunOptions options = Options(method.name, generates ? 2 : 1);
    const auto one = Run(generates ? sparse : dense, options, 1);
    const auto three = Run(generates ? sparse : dense, options, 3);
    ASSERT_EQ(one.size(), three.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].image.data, three[i].image.data) << method.name << " " << i;
    }
  }
}

TEST_F(ModeRunTest, GenerationTakesRenderedFramesWhereThereIsNoReference) {
  const Clip clip = Load(2, {.streams = Streams::kRenderGrid}, Streams::kRenderGrid);
  for (const char* method : {"i", "e", "average"}) {
    for (const Shown& shown : Run(clip, Options(method, 2))) EXPECT_EQ(shown.image.width, 40);
  }
}

TEST_F(ModeRunTest, BaselinesNeedNothingButColour) {
  const PanOptions pan = {.streams = Streams::kColor};
  const Clip clip = Load(1, pan, Streams::kColor);
  EXPECT_EQ(Run(clip, Options("bicubic")).size(), 6U);
  EXPECT_EQ(Run(clip, Options("bilinear"))[0].image.width, 80);
  EXPECT_EQ(Run(clip, Options("repeat")).size(), 11U);
}

TEST_F(ModeRunTest, ALinearClipIsShownInHalfFloat) {
  const Clip clip = Load(1, {.frames = 2, .color_space = ColorSpace::kLinear});
  SerialExecutor executor;
  for (const char* method : {"sr", "isr"}) {
    RunMode(clip, Options(method), executor, [&](const ShownFrame& shown) {
      EXPECT_EQ(shown.image.format, PixelFormat::kRgba16F) << method;
    });
  }
}

TEST_F(ModeRunTest, ThePapersFormRunsWithThePapersParameters) {
  const Clip clip = Load();
  ModeRunOptions options = Options("isr-paper");
  options.super_resolution.parameters.blend_a = 2;
  EXPECT_EQ(EffectiveSuperResolution(clip, options).parameters, kPaperParameters);
  EXPECT_EQ(EffectiveGeneration(clip, options).parameters, kPaperParameters);
  options.method = FindMethod("isr");
  EXPECT_EQ(EffectiveSuperResolution(clip, options).parameters.blend_a, 2);
  EXPECT_EQ(EffectiveSuperResolution(clip, options).output_width, 80);
  EXPECT_EQ(EffectiveGeneration(clip, options).width, 80);
}

TEST_F(ModeRunTest, WhatTheSinkThrowsEndsTheRun) {
  const Clip clip = Load();
  SerialExecutor executor;
  int count = 0;
  EXPECT_THROW(RunMode(clip, Options("sr"), executor,
                       [&](const ShownFrame&) {
                         if (++count == 2) throw std::runtime_error("enough");
                       }),
               std::runtime_error);
  EXPECT_EQ(count, 2);
}

TEST_F(ModeRunTest, SaysWhyItCannotRun) {
  const Clip clip = Load();
  const auto why = [](const Clip& on, const ModeRunOptions& options) {
    std::string sentence;
    EXPECT_FALSE(options.IsValid(on, &sentence));
    EXPECT_FALSE(options.IsValid(on));
    return sentence;
  };
  EXPECT_THAT(why(clip, {}), HasSubstr("no method"));
  EXPECT_THAT(why({}, Options("sr")), HasSubstr("no frames"));
  ModeRunOptions options = Options("i");
  options.every = 0;
  EXPECT_THAT(why(clip, options), HasSubstr("every is 0"));
  options.every = 6;
  EXPECT_THAT(why(clip, options), HasSubstr("6 frames"));
  options = Options("i");
  for (const int generated : {0, 65, -1}) {
    options.generated = generated;
    EXPECT_THAT(why(clip, options), HasSubstr("generated is"));
  }
  options = Options("i");
  for (const float alpha : {0.0f, 1.0f, -0.5f, 2.0f, NAN}) {
    options.alphas = {alpha};
    EXPECT_THAT(why(clip, options), HasSubstr("alpha is"));
  }
  options.alphas = {0.5f, 0.25f};
  EXPECT_THAT(why(clip, options), HasSubstr("ascending"));
  options = Options("sr");
  options.shown_format = PixelFormat::kR32F;
  EXPECT_THAT(why(clip, options), HasSubstr("r32f"));
  options = Options("sr");
  options.super_resolution.parameters.blend_b = -1;
  EXPECT_THAT(why(clip, options), HasSubstr("blend_b"));

  const Clip flat = Load(1, {}, Streams::kColor | Streams::kMotion);
  EXPECT_THAT(why(flat, Options("sr")), HasSubstr("frame 10 of 'pan' has no stream 'depth'"));
  const Clip half = Load(1, {}, Streams::kReference | Streams::kReferenceDepth);
  EXPECT_THAT(why(half, Options("i")), HasSubstr("'reference_motion'"));
}

}  // namespace
}  // namespace warplut
