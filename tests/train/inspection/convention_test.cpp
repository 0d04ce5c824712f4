// Inspect names the convention that frames were exported in, whatever the manifest says.
#include <gtest/gtest.h>

#include "tests/datasets/temporary_folder.h"
#include "tests/train/inspection/exported_scene.h"
#include "train/inspection/inspection.h"

namespace warplut {
namespace {

constexpr int kWidth = 320, kHeight = 180, kFrames = 5;

SceneFrames& Street() {
  static SceneFrames scene("street", kFrames, kWidth, kHeight);
  return scene;
}

// One way to export motion and jitter. tools/measure/measure_inspection.sh has all of them.
struct Export {
  MotionUnits units;
  MotionDirection direction;
  YAxis y;
  bool swapped, jitter_negated;
};

std::vector<Export> Exports() {
  std::vector<Export> exports;
  constexpr MotionUnits kUnits[] = {MotionUnits::kPixels, MotionUnits::kUv, MotionUnits::kNdc};
  for (int bits = 0; bits < 16; ++bits) {
    exports.push_back({kUnits[bits % 3],
                       (bits & 1) != 0 ? MotionDirection::kCurrentToPrevious
                                       : MotionDirection::kPreviousToCurrent,
                       (bits & 2) != 0 ? YAxis::kUp : YAxis::kDown, (bits & 4) != 0,
                       (bits & 8) != 0});
  }
  return exports;
}

// The first frames at the motion of the scene and the motion that LoadFrame now returns.
double LargestDifference(const Sequence& answered, const std::vector<Frame>& frames) {
  double largest = 0;
  for (int index = 1; index < 3; ++index) {
    const Image motion = LoadFrame(answered, index, Streams::kMotion).motion;
    const Image& expected = frames[static_cast<std::size_t>(index)].motion;
    for (std::size_t i = 0; i < motion.data.size(); ++i) {
      largest = std::max(largest, std::abs(double{motion.data[i]} - expected.data[i]));
    }
  }
  return largest;
}

TEST(Inspect, NamesTheConventionOfEveryExport) {
  const Sequence stated = Street().Stated();
  for (const Export& one : Exports()) {
    const TemporaryFolder folder;
    Sequence truth = stated;
    truth.motion->units = one.units;
    truth.motion->direction = one.direction;
    truth.motion->y = one.y;
    if (one.swapped) truth.motion->channels = {"Y", "X"};
    if (one.jitter_negated) {
      for (Vec2& v : truth.jitter) v = {-v.x, -v.y};
    }
    Sequence told = stated;
    if (one.jitter_negated) told.jitter = truth.jitter;
    Street().Write(folder.path(), truth, told);
    const Inspection found = Inspect(ReadSequence(folder.path()), [] {});
    const std::string which = testing::PrintToString(
        std::vector<int>{static_cast<int>(one.units), static_cast<int>(one.direction),
                         static_cast<int>(one.y), one.swapped, one.jitter_negated});
    EXPECT_LT(LargestDifference(found.answered, Street().frames()), 1e-3) << which;
    EXPECT_EQ(found.jitter.found.negated_x, one.jitter_negated) << which;
    EXPECT_EQ(found.jitter.found.negated_y, one.jitter_negated) << which;
    const bool as_stated = one.units == MotionUnits::kPixels && one.y == YAxis::kDown &&
                           one.direction == MotionDirection::kPreviousToCurrent && !one.swapped;
    EXPECT_EQ(found.motion.verdict, as_stated ? Verdict::kAgrees : Verdict::kContradicts) << which;
    EXPECT_EQ(found.Contradictions() > 0, !as_stated || one.jitter_negated) << which;
  }
}

TEST(Inspect, NamesTheDepthOfEveryKind) {
  const Sequence stated = Street().Stated();
  for (const DepthKind kind : {DepthKind::kLinear, DepthKind::kForward, DepthKind::kReversed}) {
    const TemporaryFolder folder;
    Sequence truth = stated;
    truth.depth->kind = kind;
    Street().Write(folder.path(), truth, stated);
    const Inspection found = Inspect(ReadSequence(folder.path()), [] {});
    ASSERT_TRUE(found.depth);
    EXPECT_EQ(found.depth->found.hyperbolic, kind != DepthKind::kLinear);
    EXPECT_EQ(found.depth->found.nearer_is_larger, kind == DepthKind::kReversed);
    EXPECT_EQ(found.answered.depth->kind, kind);
  }
}

// Forward flow of the frame: the motion of the next frame at the pixels of this one is close to its
// own where nothing accelerates.
TEST(Inspect, NamesForwardFlow) {
  const TemporaryFolder folder;
  const Sequence stated = Street().Stated();
  Street().Write(folder.path(), stated, stated);
  Sequence forward = stated;
  forward.motion->direction = MotionDirection::kCurrentToNext;
  WriteFile(folder / Sequence::kManifest, SequenceJson(forward));
  const Inspection found = Inspect(ReadSequence(folder.path()), [] {});
  EXPECT_FALSE(found.motion.found.forward);
  EXPECT_EQ(found.motion.verdict, Verdict::kContradicts);
  EXPECT_LT(LargestDifference(found.answered, Street().frames()), 1e-6);
}

TEST(Inspect, NamesMotionThatHasTheJitterInIt) {
  const TemporaryFolder folder;
  const Sequence stated = Street().Stated();
  SceneFrames& scene = Street();
  const std::vector<Frame> kept = scene.frames();
  for (int i = 1; i < kFrames; ++i) {
    Frame& frame = scene.frames()[static_cast<std::size_t>(i)];
    const Vec2 now = stated.jitter[static_cast<std::size_t>(i)];
    const Vec2 before = stated.jitter[static_cast<std::size_t>(i - 1)];
    frame.motion = Mapped(frame.motion, [&](int, int, int c, float v) {
      return v - static_cast<float>(c == 0 ? now.x - before.x : now.y - before.y);
    });
  }
  scene.Write(folder.path(), stated, stated);
  scene.frames() = kept;
  const Inspection found = Inspect(ReadSequence(folder.path()), [] {});
  EXPECT_TRUE(found.jitter.contains_jitter);
  EXPECT_GT(found.Contradictions(), 0);
  EXPECT_LT(LargestDifference(found.answered, kept), 1e-3);
}

TEST(Inspect, CannotTellWhereNothingMoves) {
  const TemporaryFolder folder;
  const SceneFrames still("still", 5, kWidth, kHeight);
  still.Write(folder.path(), still.Stated(), still.Stated());
  const Inspection found = Inspect(ReadSequence(folder.path()), [] {});
  EXPECT_EQ(found.motion.verdict, Verdict::kCannotTell);
  EXPECT_EQ(found.motion.reason, "nothing moves");
  for (const Ranking& ranking : found.motion.rankings) {
    EXPECT_EQ(ranking.verdict, Verdict::kCannotTell) << ranking.question;
  }
  EXPECT_EQ(found.Contradictions(), 0);
  EXPECT_TRUE(found.findings.empty());
}

}  // namespace
}  // namespace warplut
