#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/datasets/temporary_folder.h"
#include "tests/train/replay/pan_sequence.h"
#include "tools/pipeline.h"
#include "tools/report/report_clips.h"
#include "tools/report/report_inputs.h"
#include "train/replay/mode_run.h"

namespace warplut {
namespace {

// The sequence with the motion of a zoom, rounded to whole pixels.
void WriteRounded(const Sequence& sequence, const std::filesystem::path& folder) {
  const SequenceWriter writer(folder, sequence);
  for (int i = 0; i < sequence.count; ++i) {
    Frame frame = LoadFrame(sequence, i, Streams::kAll);
    for (int y = 0; y < frame.motion.height; ++y) {
      for (int x = 0; x < frame.motion.width; ++x) {
        frame.motion.at(x, y, 0) = std::round(0.5f * static_cast<float>(x - 20));
        frame.motion.at(x, y, 1) = std::round(0.5f * static_cast<float>(y - 16));
      }
    }
    writer.Write(i, frame);
  }
  writer.Finish();
}

TEST(ReportClips, FilterMotionWhereItIsQuantised) {
  const TemporaryFolder folder;
  WriteRounded(WritePan(folder / "pan"), folder / "rounded");
  for (const bool rounded : {false, true}) {
    std::vector<ReportClip> clips, larger;
    AddSequence(folder / (rounded ? "rounded" : "pan"), {}, true, &clips, &larger);
    ASSERT_EQ(clips.size(), 1U);
    const ModeRunOptions options = ReportRunOptions(ReportInputs(), MethodOf("sr"));
    EXPECT_EQ(EffectiveSuperResolution(clips[0].dense, options).motion_filter, rounded);
    const Clip again = ReloadClip(clips[0], Streams::kRenderGrid, 3);
    EXPECT_EQ(EffectiveSuperResolution(again, options).motion_filter, rounded);
  }
}

}  // namespace
}  // namespace warplut
