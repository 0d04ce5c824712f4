#include "tools/judge/sequence_scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "datasets/srgb_curve.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/train/replay/pan_sequence.h"
#include "train/metrics/psnr.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

class SequenceScoresTest : public testing::Test {
 protected:
  SequenceScoresTest()
      : truth_(LoadClip(WritePan(folder_ / "pan", {.speed_x = 2, .speed_y = -1}), 0, 6,
                        kTruthStreams)) {}

  // The reference of a frame, brighter by `error`.
  ImageBuffer Off(int frame, float error) const {
    Image image = ToImage(truth_.frames[static_cast<std::size_t>(frame)].reference.view());
    for (float& value : image.data) value += error;
    return ToBuffer(image, PixelFormat::kRgba32F);
  }

  void Show(SequenceJudge& judge, int frame, float error, bool generated = false,
            double seconds = 0) const {
    const ImageBuffer image = Off(frame, error);
    judge.Add({.time = static_cast<double>(frame),
               .generated = generated,
               .frame = frame,
               .image = image.view(),
               .seconds = seconds});
  }

  const TemporaryFolder folder_;
  const Clip truth_;
};

TEST_F(SequenceScoresTest, AreThoseOfAKnownError) {
  SequenceJudge judge(truth_, *FindMethod("sr"));
  for (int f = 0; f < 6; ++f) Show(judge, f, f == 0 ? 0.5f : 0.0625f, false, f == 0 ? 1 : 0.25);
  const SequenceScores scores = judge.Finish();
  EXPECT_EQ(scores.method, "sr");
  ASSERT_EQ(scores.frames.size(), 5U) << "the first has no history";
  EXPECT_EQ(scores.frames[0].name, "0011");
  EXPECT_NEAR(scores.mean.psnr, -20 * std::log10(0.0625), 1e-4);
  EXPECT_LT(scores.mean.ssim, 1);
  EXPECT_TRUE(std::isnan(scores.temporal[0])) << "its neighbour was not judged";
  EXPECT_NEAR(scores.temporal[1], 0, 1e-6);
  EXPECT_NEAR(scores.temporal_error, 0, 1e-6);
  EXPECT_DOUBLE_EQ(scores.milliseconds, 250);
}

TEST_F(SequenceScoresTest, FlickerIsATemporalError) {
  SequenceJudge judge(truth_, *FindMethod("sr"));
  for (int f = 0; f < 6; ++f) Show(judge, f, f % 2 == 0 ? 0.0625f : -0.0625f);
  const SequenceScores scores = judge.Finish();
  EXPECT_NEAR(scores.temporal_error, 0.125, 1e-6);
  EXPECT_NEAR(scores.mean.psnr, -20 * std::log10(0.0625), 1e-4);
}

TEST_F(SequenceScoresTest, GenerationIsJudgedByGeneratedFrames) {
  SequenceJudge judge(truth_, *FindMethod("i"));
  for (int f = 0; f < 5; ++f) Show(judge, f, f % 2 == 0 ? 0 : 0.0625f, f % 2 == 1, f % 2 * 0.001);
  // Between frames: nothing to judge by.
  const ImageBuffer image = Off(4, 0);
  judge.Add({.time = 4.5, .generated = true, .frame = -1, .image = image.view(), .seconds = 0.003});
  const SequenceScores scores = judge.Finish();
  ASSERT_EQ(scores.frames.size(), 2U);
  EXPECT_EQ(scores.frames[1].name, "0013");
  EXPECT_NEAR(scores.mean.psnr, -20 * std::log10(0.0625), 1e-4);
  EXPECT_NEAR(scores.temporal[0], 0.0625, 1e-6);
  EXPECT_NEAR(scores.temporal_error, 0.0625, 1e-6);
  EXPECT_NEAR(scores.milliseconds, 2, 1e-9) << "the first is left out";
}

TEST_F(SequenceScoresTest, PairsEndAtCutsAndGaps) {
  Clip truth = LoadClip(ReadSequence(folder_ / "pan"), 0, 6, kTruthStreams);
  truth.frames[3].cut = true;
  SequenceJudge judge(truth, *FindMethod("sr"));
  for (const int f : {1, 2, 3, 5}) Show(judge, f, f == 2 ? 0 : 0.0625f);
  const SequenceScores scores = judge.Finish();
  EXPECT_NEAR(scores.temporal[1], 0.0625, 1e-6);
  EXPECT_TRUE(std::isnan(scores.temporal[2])) << "a cut";
  EXPECT_TRUE(std::isnan(scores.temporal[3])) << "frame 4 was not shown";
  EXPECT_NEAR(scores.temporal_error, 0.0625, 1e-6);
}

TEST_F(SequenceScoresTest, LeavesOutTheBorder) {
  Image image = ToImage(truth_.frames[1].reference.view());
  for (int x = 0; x < image.width; ++x) image.at(x, 2, 0) = 0;
  const ImageBuffer shown = ToBuffer(image, PixelFormat::kRgba32F);
  for (const int border : {3, 2}) {
    SequenceJudge judge(truth_, *FindMethod("sr"), border);
    judge.Add({.time = 1, .frame = 1, .image = shown.view()});
    EXPECT_EQ(std::isinf(judge.Finish().mean.psnr), border == 3);
  }
}

TEST_F(SequenceScoresTest, SettledMeansLeaveOutTheFirstFrames) {
  const auto scores_of = [&](int settled) {
    SequenceJudge judge(truth_, *FindMethod("sr"), kScoreBorder, settled);
    for (int f = 0; f < 6; ++f) Show(judge, f, f < 4 ? 0.25f : f == 4 ? 0.125f : 0.0625f);
    return judge.Finish();
  };
  EXPECT_FALSE(scores_of(0).settled);
  const SequenceScores scores = scores_of(3);  // of the frames 1 to 5 the last two are left
  ASSERT_TRUE(scores.settled);
  EXPECT_EQ(scores.settled->left_out, 3);
  EXPECT_EQ(scores.frames.size(), 5U);
  EXPECT_NEAR(scores.settled->mean.psnr, -10 * (std::log10(0.125) + std::log10(0.0625)), 1e-4);
  EXPECT_DOUBLE_EQ(scores.settled->mean.ssim, (scores.frames[3].ssim + scores.frames[4].ssim) / 2);
  EXPECT_EQ(scores.mean.psnr, scores_of(0).mean.psnr) << "all frames";
  // The pairs 3, 4 and 4, 5.
  EXPECT_NEAR(scores.settled->temporal_error, std::sqrt((0.125 * 0.125 + 0.0625 * 0.0625) / 2),
              1e-4);
  EXPECT_NEAR(scores_of(4).settled->temporal_error, 0.0625, 1e-6);
  ExpectError([&] { scores_of(5); },
              {"leaves out 5 frames", "method sr is judged by 5 of 'pan'", "at least one more"});
}

TEST_F(SequenceScoresTest, ErrorsOfTheJitterAreScoredWhereAskedFor) {
  Clip truth = LoadClip(ReadSequence(folder_ / "pan"), 0, 6, kTruthStreams);
  for (std::size_t f = 0; f < 6; ++f) truth.frames[f].jitter = {f % 2 == 0 ? 0.25 : -0.25, 0};
  const auto scores_of = [&](const Clip& clip, const char* method, bool jitter) {
    SequenceJudge judge(clip, *FindMethod(method), kScoreBorder, 0, jitter);
    for (int f = 0; f < 6; ++f) Show(judge, f, f % 2 == 0 ? 0.125f : 0.0625f, f % 2 == 1);
    return judge.Finish();
  };
  EXPECT_FALSE(scores_of(truth, "sr", false).jitter);
  const SequenceScores scores = scores_of(truth, "sr", true);
  ASSERT_TRUE(scores.jitter);
  EXPECT_NEAR(scores.jitter->repeating, 0.03125, 1e-6);
  EXPECT_NEAR(scores.jitter->lattice, 0, 1e-6) << "the same at all pixels";
  const SequenceScores received = FromNumbers("sr", ToNumbers(scores));
  EXPECT_EQ(received.jitter->repeating, scores.jitter->repeating);
  EXPECT_EQ(received.jitter->lattice, scores.jitter->lattice);
  EXPECT_FALSE(FromNumbers("sr", ToNumbers(scores_of(truth, "sr", false))).jitter);
  EXPECT_TRUE(std::isnan(scores_of(truth, "i", true).jitter->lattice)) << "no super resolution";
  truth.frames[3].cut = true;
  EXPECT_TRUE(std::isnan(scores_of(truth, "sr", true).jitter->repeating)) << "no cycles in a row";
}

TEST_F(SequenceScoresTest, TellsWhyThereIsNoErrorOfTheJitter) {
  Sequence sequence = ReadSequence(folder_ / "pan");
  sequence.cuts.clear();
  sequence.jitter = {{0.25, 0}, {-0.25, 0}};
  EXPECT_EQ(WhyNoJitterError(sequence, 0, 6), "");
  EXPECT_EQ(
      WhyNoJitterError(sequence, 1, 5),
      "a cycle of its jitter has 2 frames, 5 of them in a row are needed and 4 follow a first "
      "one");
  sequence.cuts = {sequence.first + 3};
  EXPECT_NE(WhyNoJitterError(sequence, 0, 6).find("and 2 follow"), std::string::npos);
  sequence.numbers = {10, 20, 21, 30, 31, 32};  // the cut is a number, not an index
  sequence.cuts = {30};
  EXPECT_NE(WhyNoJitterError(sequence, 0, 6).find("and 2 follow"), std::string::npos);
  sequence.jitter.clear();
  EXPECT_EQ(WhyNoJitterError(sequence, 0, 6), "the jitter of its 6 frames has no whole cycle");
}

TEST_F(SequenceScoresTest, RefusesWhatCannotBeJudged) {
  SequenceJudge judge(truth_, *FindMethod("i"));
  Show(judge, 0, 0);
  ExpectError([&] { judge.Finish(); }, {"method i", "'pan'"});
  const ImageBuffer small(40, 32, PixelFormat::kRgba8);
  ExpectError([&] { judge.Add({.time = 1, .generated = true, .frame = 1, .image = small.view()}); },
              {"40 x 32", "80 x 64"});
  SequenceJudge wide(truth_, *FindMethod("sr"), 40);
  ExpectError([&] { Show(wide, 1, 0); }, {"0011", "border of 40"});
}

TEST(JudgedImage, IsWhatADisplayShowsWhereLinear) {
  Image hdr(1, 1, 3);
  hdr.data = {3, 1, -2};
  const ImageBuffer buffer = ToBuffer(hdr, PixelFormat::kRgba32F);
  const Image judged = JudgedImage(buffer.view(), ColorEncoding::kLinearHdr);
  EXPECT_FLOAT_EQ(judged.data[0], SrgbCurve(0.75f));
  EXPECT_FLOAT_EQ(judged.data[1], SrgbCurve(0.25f));
  EXPECT_FLOAT_EQ(judged.data[2], 0);
  EXPECT_NEAR(SrgbCurve(0.25f), 0.5371f, 1e-4f);
  EXPECT_EQ(JudgedImage(buffer.view(), ColorEncoding::kDisplay).data, hdr.data);
}

}  // namespace
}  // namespace warplut
