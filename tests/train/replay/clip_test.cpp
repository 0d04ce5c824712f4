#include "train/replay/clip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "datasets/images/image_io.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/train/replay/pan_sequence.h"
#include "train/replay/clip_texels.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

using testing::FloatNear;
using testing::Pointwise;

TEST(Clip, HasTheStreamsInTheFormsOfTheRuntime) {
  const TemporaryFolder folder;
  const Sequence sequence = WritePan(folder / "pan");
  const Clip clip = LoadClip(sequence, 1, 3, Streams::kAll);
  EXPECT_EQ(clip.name, "pan");
  EXPECT_EQ(clip.render, sequence.render);
  EXPECT_EQ(clip.output, sequence.output);
  EXPECT_EQ(clip.encoding, ColorEncoding::kDisplay);
  ASSERT_EQ(clip.frames.size(), 3U);
  const Frame expected = LoadFrame(sequence, 2, Streams::kAll);
  const ClipFrame& frame = clip.frames[1];
  EXPECT_EQ(frame.number, 12);
  EXPECT_EQ(frame.jitter.x, expected.jitter.x);
  EXPECT_EQ(frame.color.view().format, PixelFormat::kRgba8);
  EXPECT_EQ(frame.reference.view().format, PixelFormat::kRgba8);
  EXPECT_THAT(ToImage(frame.color.view()).data, Pointwise(FloatNear(1e-6f), expected.color.data));
  EXPECT_EQ(ToImage(frame.depth.view()).data, expected.depth.data);
  EXPECT_EQ(ToImage(frame.motion.view()).data, expected.motion.data);
  EXPECT_THAT(ToImage(frame.reference.view()).data,
              Pointwise(FloatNear(1e-6f), expected.reference.data));
  EXPECT_EQ(ToImage(frame.reference_depth.view()).data, expected.reference_depth.data);
  EXPECT_EQ(ToImage(frame.reference_motion.view()).data, expected.reference_motion.data);
  const RenderedFrame rendered = frame.Rendered();
  EXPECT_EQ(rendered.color.data, frame.color.view().data);
  EXPECT_EQ(rendered.jitter_y, static_cast<float>(expected.jitter.y));
  EXPECT_EQ(frame.Displayed().color.data, frame.reference.view().data);
}

// A zoom: less of the rounding of its motion to whole pixels is left in what is filtered before it
// is composed.
TEST(Clip, FiltersQuantisedMotionBeforeItIsComposed) {
  constexpr int kWidth = 320, kHeight = 240, kFrames = 3;
  constexpr double kZoom = 0.05;
  constexpr Streams kStreams = Streams::kReferenceMotion | Streams::kReferenceDepth;
  const auto write = [&](const std::filesystem::path& folder, bool rounded) {
    const SequenceWriter writer(
        folder, StandardSequence("zoom", 0, kFrames, {kWidth / 2, kHeight / 2}, {kWidth, kHeight},
                                 ColorSpace::kSrgb, kStreams, 0.1, 100));
    Frame frame;
    frame.color = Image(kWidth / 2, kHeight / 2, 3);
    frame.reference_motion = Image(kWidth, kHeight, 2);
    frame.reference_depth = Image(kWidth, kHeight, 1);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const double mx = kZoom * (x + 0.5 - kWidth / 2), my = kZoom * (y + 0.5 - kHeight / 2);
        frame.reference_motion.at(x, y, 0) = static_cast<float>(rounded ? std::round(mx) : mx);
        frame.reference_motion.at(x, y, 1) = static_cast<float>(rounded ? std::round(my) : my);
        frame.reference_depth.at(x, y) =
            static_cast<float>(0.3 + 0.05 * std::sin(0.1 * x) * std::sin(0.07 * y));
      }
    }
    for (int i = 0; i < kFrames; ++i) writer.Write(i, frame);
    writer.Finish();
    return ReadSequence(folder);
  };
  const TemporaryFolder folder;
  const Sequence exact = write(folder / "exact", false);
  const Sequence rounded = write(folder / "rounded", true);
  const auto load = [&](const Sequence& sequence, MotionFiltering filtering, int every) {
    return LoadClip(sequence, 0, kFrames, kStreams, every, filtering);
  };
  const auto motion = [&](const Sequence& sequence, MotionFiltering filtering, int every) {
    const Clip clip = load(sequence, filtering, every);
    return ToImage(clip.frames.back().reference_motion.view()).data;
  };
  const std::vector<float> truth = motion(exact, MotionFiltering::kOff, 2);
  const auto error = [&](MotionFiltering filtering) {
    const std::vector<float> data = motion(rounded, filtering, 2);
    double sum = 0;
    for (std::size_t i = 0; i < data.size(); ++i) sum += std::pow(data[i] - truth[i], 2);
    return std::sqrt(sum / static_cast<double>(data.size()));
  };
  EXPECT_GT(error(MotionFiltering::kOff), 0.3);
  EXPECT_LT(error(MotionFiltering::kOn), 0.1);
  EXPECT_EQ(error(MotionFiltering::kQuantised), error(MotionFiltering::kOn));
  EXPECT_EQ(motion(exact, MotionFiltering::kQuantised, 2), truth);
  EXPECT_EQ(motion(rounded, MotionFiltering::kOn, 1), motion(rounded, MotionFiltering::kOff, 1));

  EXPECT_TRUE(HasQuantisedMotion(load(rounded, MotionFiltering::kOff, 1)));
  EXPECT_FALSE(HasQuantisedMotion(load(exact, MotionFiltering::kOff, 1)));
  EXPECT_FALSE(HasQuantisedMotion(load(rounded, MotionFiltering::kQuantised, 2)));
}

TEST(Clip, LeavesOutWhatIsNotAskedFor) {
  const TemporaryFolder folder;
  const Clip clip = LoadClip(WritePan(folder / "pan"), 0, 1, Streams::kColor);
  EXPECT_EQ(clip.frames[0].color.view().width, 40);
  EXPECT_EQ(clip.frames[0].depth.view().width, 0);
  EXPECT_EQ(clip.frames[0].motion.view().width, 0);
  EXPECT_EQ(clip.frames[0].reference.view().data, nullptr);
}

TEST(Clip, IsFloatWhereTheSequenceIsLinear) {
  const TemporaryFolder folder;
  const Sequence sequence =
      WritePan(folder / "pan", {.frames = 1, .color_space = ColorSpace::kLinear});
  const Clip clip = LoadClip(sequence, 0, 1, Streams::kColor);
  EXPECT_EQ(clip.encoding, ColorEncoding::kLinearHdr);
  EXPECT_EQ(clip.frames[0].color.view().format, PixelFormat::kRgba32F);
}

TEST(Clip, LimitsLinearColourAsTheRuntimeDoesAndCounts) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const TemporaryFolder folder;
  const Sequence sequence =
      WritePan(folder / "pan", {.frames = 2, .color_space = ColorSpace::kLinear});
  const float values[] = {kInfinity, -kInfinity, 1e9f, -1e9f, kLargestHdr, -0.5f};
  const auto file = folder / "pan" / "lr" / "color" / "0010.exr";
  Image image = ReadImage(file);
  std::copy(std::begin(values), std::end(values), image.data.begin());
  WriteImage(file, image, PixelType::kFloat);
  const Clip clip = LoadClip(sequence, 0, 2, Streams::kColor | Streams::kReference);
  EXPECT_EQ(clip.limited_color, 4);
  EXPECT_EQ(clip.limited_reference, 0);
  const Image limited = ToImage(clip.frames[0].color.view());
  for (std::size_t i = 0; i < std::size(values); ++i) {
    EXPECT_EQ(LimitHdr(limited.data[i]), LimitHdr(values[i])) << values[i];
    EXPECT_LE(std::abs(limited.data[i]), kLargestHdr);
  }
  EXPECT_EQ(limited.data[5], -0.5f) << "within the range it is as it was";
}

TEST(Clip, ComposesMotionOverSeveralFrames) {
  const TemporaryFolder folder;
  const Sequence sequence = WritePan(folder / "pan");
  const Clip clip = LoadClip(sequence, 1, 5, Streams::kMotion | Streams::kReferenceMotion, 3);
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(clip.frames[static_cast<std::size_t>(i)].cut)
        << "motion to the first frame of the sequence is not known";
  }
  for (int i = 2; i < 5; ++i) {
    const ClipFrame& frame = clip.frames[static_cast<std::size_t>(i)];
    EXPECT_FALSE(frame.cut);
    EXPECT_NEAR(frame.motion.view().Row(16)[2 * 20], 3 * 1.25, 1e-5);
    EXPECT_NEAR(frame.reference_motion.view().Row(32)[2 * 40 + 1], -3, 1e-5);
    EXPECT_EQ(frame.depth.view().width, 0);
  }
}

TEST(Clip, DoesNotComposeAcrossACut) {
  const TemporaryFolder folder;
  const Sequence sequence = WritePan(folder / "pan", {.cuts = {12}});
  std::vector<bool> cuts;
  for (const ClipFrame& frame : LoadClip(sequence, 0, 6, Streams::kMotion, 2).frames) {
    cuts.push_back(frame.cut);
  }
  EXPECT_EQ(cuts, (std::vector<bool>{true, true, true, true, false, false}));
}

TEST(Clip, TheFirstFrameOfASequenceIsACut) {
  const TemporaryFolder folder;
  const Sequence sequence = WritePan(folder / "pan");
  const auto cuts = [&](int first, int every) {
    std::vector<bool> all;
    for (const ClipFrame& frame : LoadClip(sequence, first, 3, Streams::kMotion, every).frames) {
      all.push_back(frame.cut);
    }
    return all;
  };
  EXPECT_EQ(cuts(0, 1), (std::vector<bool>{true, false, false}));
  EXPECT_EQ(cuts(1, 1), (std::vector<bool>{false, false, false}));
  EXPECT_EQ(cuts(1, 2), (std::vector<bool>{true, false, false})) << "it begins at the first";
  EXPECT_EQ(cuts(2, 2), (std::vector<bool>{false, false, false}));
}

TEST(Clip, RefusesWhatIsNotThere) {
  const TemporaryFolder folder;
  const Sequence sequence =
      WritePan(folder / "pan", {.streams = Streams::kColor | Streams::kReference});
  ExpectError([&] { LoadClip(sequence, -1, 2, Streams::kColor); }, {"pan", "6 frames"});
  ExpectError([&] { LoadClip(sequence, 4, 3, Streams::kColor); }, {"pan", "4 to 6"});
  ExpectError([&] { LoadClip(sequence, 0, 0, Streams::kColor); }, {"pan"});
  ExpectError([&] { LoadClip(sequence, 0, 1, Streams::kColor, 0); }, {"every is 0"});
  ExpectError([&] { LoadClip(sequence, 0, 1, Streams::kDepth); }, {"pan", "'depth'"});
  std::filesystem::remove(folder / "pan" / "lr" / "color" / "0013.png");
  ExpectError([&] { LoadClip(sequence, 0, 6, Streams::kColor); }, {"0013.png"});
}

TEST(ClipTexels, AreThoseNearestToTheJitter) {
  const TemporaryFolder folder;
  const Sequence sequence = WritePan(folder / "pan");
  Clip clip = LoadClip(sequence, 0, 6, Streams::kOutputGrid);
  TakeTexels(clip);
  for (int i = 0; i < 6; ++i) {
    const ClipFrame& frame = clip.frames[static_cast<std::size_t>(i)];
    const Vec2 jitter = sequence.jitter[static_cast<std::size_t>(i)];
    EXPECT_LE(std::abs(frame.jitter.x - jitter.x), 0.25 + 1e-12);
    EXPECT_LE(std::abs(frame.jitter.y - jitter.y), 0.25 + 1e-12);
    EXPECT_EQ(std::abs(frame.jitter.x), 0.25);
    const int tx = frame.jitter.x > 0 ? 1 : 0, ty = frame.jitter.y > 0 ? 1 : 0;
    const Image reference = ToImage(frame.reference.view());
    const Image color = ToImage(frame.color.view());
    EXPECT_EQ(color.width, 40);
    EXPECT_EQ(color.at(7, 5, 1), reference.at(14 + tx, 10 + ty, 1));
    EXPECT_FLOAT_EQ(frame.motion.view().Row(5)[2 * 7], 1.25f);
    EXPECT_FLOAT_EQ(frame.motion.view().Row(5)[2 * 7 + 1], -0.5f);
    EXPECT_EQ(frame.depth.view().width, 40);
  }
}

TEST(ClipTexels, VisitABlockRowByRowWithoutJitter) {
  const TemporaryFolder folder;
  Clip clip = LoadClip(WritePan(folder / "pan"), 0, 6, Streams::kOutputGrid);
  for (ClipFrame& frame : clip.frames) frame.jitter = {};
  TakeTexels(clip);
  const double expected[6][2] = {{-0.25, -0.25}, {0.25, -0.25},  {-0.25, 0.25},
                                 {0.25, 0.25},   {-0.25, -0.25}, {0.25, -0.25}};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(clip.frames[i].jitter.x, expected[i][0]);
    EXPECT_EQ(clip.frames[i].jitter.y, expected[i][1]);
  }
}

TEST(ClipTexels, NeedAWholeScaleAndTheReference) {
  const TemporaryFolder folder;
  Clip odd = LoadClip(WritePan(folder / "odd", {.frames = 1, .output = {60, 64}}), 0, 1,
                      Streams::kOutputGrid);
  ExpectError([&] { TakeTexels(odd); }, {"40 x 32", "60 x 64", "whole"});
  Clip without = LoadClip(WritePan(folder / "pan", {.frames = 1}), 0, 1, Streams::kReference);
  ExpectError([&] { TakeTexels(without); }, {"frame 10", "reference_depth"});
}

}  // namespace
}  // namespace warplut
