// `warplut run` of a sequence whose colour has an alpha.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "datasets/images/image_io.h"
#include "datasets/sequence/sequence_writer.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/train/replay/pan_sequence.h"
#include "tools/run/mode_runner.h"
#include "tools/usage_error.h"

namespace warplut {
namespace {

constexpr double kTint[3] = {0.8, 0.5, 0.25};
constexpr Streams kAlphas = Streams::kAlpha | Streams::kReferenceAlpha;

// One colour whose alpha is the texture of a pan.
Image AlphaOf(const Image& texture) {
  Image alpha(texture.width, texture.height, 1);
  for (std::size_t i = 0; i < alpha.data.size(); ++i) alpha.data[i] = texture.data[3 * i];
  return alpha;
}

Image Tinted(const Image& alpha) {
  Image image(alpha.width, alpha.height, 3);
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    image.data[i] = static_cast<float>(kTint[i % 3]) * alpha.data[i / 3];
  }
  return image;
}

class AlphaRun : public testing::Test {
 protected:
  static constexpr int kFrames = 8;

  void Write(Streams streams) {
    const PanOptions options = {.frames = kFrames, .speed_x = 0.8, .speed_y = -0.4};
    Sequence sequence = StandardSequence("pan", 10, kFrames, options.render, options.output,
                                         ColorSpace::kSrgb, streams, 0.1, 100);
    sequence.jitter = JitterCycle(2);
    const SequenceWriter writer(folder_ / "pan", sequence);
    const Pan pan(options);
    for (int i = 0; i < kFrames; ++i) {
      Frame frame = pan.At(i, sequence.jitter[static_cast<std::size_t>(i)]);
      frame.alpha = AlphaOf(frame.color);
      frame.reference_alpha = AlphaOf(frame.reference);
      frame.color = Tinted(frame.alpha);
      frame.reference = Tinted(frame.reference_alpha);
      writer.Write(i, frame);
    }
    writer.Finish();
  }

  std::vector<ModeOutput> Run(const std::string& mode, bool score = false) const {
    RunRequest request;
    request.modes = {mode};
    request.sequence = (folder_ / "pan").string();
    request.out = (folder_ / "out").string();
    request.every = mode == "i" ? 2 : 1;
    request.score = score;
    request.pipeline.filter = "catmull-rom";
    return ModeRunner(request).Run();
  }

  // The PSNR of the alpha of two frames. Their straight colour is bounded.
  double AlphaPsnr(const ModeOutput& output) const {
    const Pan pan({.frames = kFrames, .speed_x = 0.8, .speed_y = -0.4});
    double squares = 0, sum = 0, worst = 0;
    int count = 0;
    for (int i = 4; i < 6; ++i) {
      const Image shown = ReadImage(output.folder / output.files.at(static_cast<std::size_t>(i)));
      EXPECT_EQ(shown.channels, 4);
      const Image alpha = AlphaOf(pan.At(i, {}).reference);
      for (int y = 6; y < shown.height - 6; ++y) {
        for (int x = 6; x < shown.width - 6; ++x, ++count) {
          squares += std::pow(shown.at(x, y, 3) - alpha.at(x, y), 2);
          for (int c = 0; c < 3; ++c) {
            const double error = std::abs(shown.at(x, y, c) - kTint[c]);
            worst = std::max(worst, error);
            sum += error / 3;
          }
        }
      }
    }
    // Clamps act on colour and alpha apart: their quotient is no constant.
    EXPECT_LT(sum / count, 0.01) << output.mode;
    EXPECT_LT(worst, 0.1) << output.mode;
    return -10 * std::log10(squares / count);
  }

  const TemporaryFolder folder_;
};

TEST_F(AlphaRun, SuperResolutionCarriesIt) {
  Write(Streams::kAll | kAlphas);
  EXPECT_GT(AlphaPsnr(Run("sr", true).front()), AlphaPsnr(Run("bilinear").front()) + 3);
}

TEST_F(AlphaRun, FrameGenerationCarriesThatOfReferences) {
  Write(Streams::kAll | kAlphas);
  EXPECT_GT(AlphaPsnr(Run("i").front()), 35);
}

TEST_F(AlphaRun, WithoutOneFramesHaveThreeChannels) {
  Write(Streams::kAll);
  const ModeOutput output = Run("sr").front();
  EXPECT_EQ(ReadImage(output.folder / output.files.front()).channels, 3);
}

TEST_F(AlphaRun, ScoresNeedTheAlphaOfReferences) {
  Write(Streams::kAll | Streams::kAlpha);
  EXPECT_THROW(Run("sr", true), UsageError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "0010.png"));
  EXPECT_EQ(Run("sr").front().files.size(), std::size_t{kFrames});
}

}  // namespace
}  // namespace warplut
