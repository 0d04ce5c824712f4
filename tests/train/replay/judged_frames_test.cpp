#include "train/replay/judged_frames.h"

#include <gtest/gtest.h>

#include "tests/datasets/temporary_folder.h"
#include "tests/train/replay/pan_sequence.h"

namespace warplut {
namespace {

class JudgedFramesTest : public testing::Test {
 protected:
  // What JudgedFrames foretells, after a check that it is what RunMode shows.
  std::vector<int> Judged(const char* method, int every, int generated) {
    const PanOptions pan;
    const Clip clip = LoadClip(WritePan(folder_ / "pan", pan), 0, pan.frames, Streams::kAll, every);
    ModeRunOptions options;
    options.method = FindMethod(method);
    options.every = every;
    options.generated = generated;
    std::vector<int> shown_frames;
    SerialExecutor executor;
    RunMode(clip, options, executor, [&](const ShownFrame& shown) {
      if (IsJudged(*options.method, shown)) shown_frames.push_back(shown.frame);
    });
    EXPECT_EQ(JudgedFrames(clip, options), shown_frames);
    frames_ = pan.frames;
    return shown_frames;
  }

  TemporaryFolder folder_;
  int frames_ = 0;
};

TEST_F(JudgedFramesTest, SuperResolutionFromTheSecondFrameOn) {
  const std::vector<int> judged = Judged("sr", 1, 1);
  ASSERT_EQ(judged.size(), static_cast<std::size_t>(frames_) - 1);
  EXPECT_EQ(judged.front(), 1);
  EXPECT_EQ(judged.back(), frames_ - 1);
}

TEST_F(JudgedFramesTest, EveryMethodShowsWhatIsForetold) {
  for (const MethodInfo& method : Methods()) {
    SCOPED_TRACE(method.name);
    for (const int every : {1, 2}) {
      for (const int generated : {1, 3}) Judged(method.name, every, generated);
    }
  }
}

TEST_F(JudgedFramesTest, GeneratedFramesBetweenWholeTimesAreNotJudged) {
  EXPECT_TRUE(Judged("i", 1, 1).empty());
  EXPECT_EQ(Judged("i", 2, 1).front(), 1);
  EXPECT_EQ(Judged("i", 2, 3), Judged("i", 2, 1));
}

}  // namespace
}  // namespace warplut
