#include "tools/inspection/sequence_inspection.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "datasets/error.h"
#include "datasets/file.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/train/replay/pan_sequence.h"
#include "tools/scene_rendering.h"

namespace warplut {
namespace {

TEST(InspectSequence, TellsRangesAndProblems) {
  const TemporaryFolder folder;
  const RenderOptions options{.width = 48, .height = 32, .frames = 2, .samples = 1};
  RenderScene("still", options, Streams::kAll, folder.path(), [] {});
  std::filesystem::remove(folder / "lr/depth/0001.exr");
  WriteFile(folder / "hr/color/0000.png", "damaged");

  int loads = 0;
  const std::vector<StreamInspection> streams =
      InspectSequence(ReadSequence(folder.path()), [&] { ++loads; });
  ASSERT_EQ(streams.size(), 6U);
  EXPECT_EQ(loads, 12);
  EXPECT_EQ(streams[0].name, "color");
  EXPECT_EQ(streams[0].frames, 2);
  EXPECT_GE(streams[0].least, 0);
  EXPECT_LE(streams[0].least, streams[0].mean);
  EXPECT_LE(streams[0].mean, streams[0].greatest);
  EXPECT_LE(streams[0].greatest, 1);
  EXPECT_EQ(streams[1].problems.size(), 1U);
  EXPECT_NE(streams[1].problems[0].find("0001.exr"), std::string::npos);
  EXPECT_EQ(streams[2].greatest, 0) << "nothing moves in this scene";
  EXPECT_EQ(streams[3].problems.size(), 1U);
}

TEST(InspectSequence, ChecksMasksHudsAndSizesThatVary) {
  const TemporaryFolder folder;
  PanOptions pan = {.frames = 2, .streams = Streams::kAll | Streams::kReactive | Streams::kHud};
  pan.render_sizes = {{40, 32}, {30, 20}};
  pan.spot = true;
  const Sequence sequence = WritePan(folder / "pan", pan);
  std::filesystem::remove(folder / "pan/lr/reactive/0011.png");
  const std::vector<StreamInspection> streams = InspectSequence(sequence, [] {});
  ASSERT_EQ(streams.size(), 8U);
  EXPECT_EQ(streams[6].name, "reactive");
  EXPECT_EQ(streams[6].greatest, 1);
  ASSERT_EQ(streams[6].problems.size(), 1U);
  EXPECT_NE(streams[6].problems[0].find("0011.png"), std::string::npos);
  EXPECT_EQ(streams[7].name, "hud");
  EXPECT_EQ(streams[7].frames, 2);
  EXPECT_THROW(InspectQuietly(
                   sequence, [] {}, true),
               Error);
}

TEST(ProblemText, TellsTheFirstAndHowManyMore) {
  StreamInspection stream;
  stream.name = "depth";
  EXPECT_EQ(ProblemText(stream), "");
  stream.problems = {"a is bad"};
  EXPECT_EQ(ProblemText(stream), "a is bad");
  stream.problems.push_back("b is bad");
  EXPECT_EQ(ProblemText(stream), "a is bad (1 more frame of 'depth' cannot be loaded)");
  stream.problems.resize(40);
  EXPECT_EQ(ProblemText(stream), "a is bad (39 more frames of 'depth' cannot be loaded)");
}

TEST(SelectScenes, PartsMakeTheWhole) {
  EXPECT_EQ(SelectScenes("training").size() + SelectScenes("held-out").size() +
                SelectScenes("fault").size(),
            SelectScenes("all").size());
  EXPECT_EQ(SelectScenes("still"), std::vector<std::string>{"still"});
  EXPECT_GE(SelectScenes("training").size(), 4U);
  EXPECT_GE(SelectScenes("held-out").size(), 2U);
}

TEST(ParseStreams, IsTheInverseOfStreamNames) {
  EXPECT_EQ(ParseStreams(StreamNames(Streams::kAll)), Streams::kAll);
  EXPECT_EQ(ParseStreams({"color", "reference"}), Streams::kColor | Streams::kReference);
}

}  // namespace
}  // namespace warplut
