#include "train/replay/clip_shelf.h"

#include <gtest/gtest.h>

#include "tests/datasets/expect_error.h"

namespace warplut {
namespace {

// One frame of so many rows of 64 bytes.
Clip ClipOf(int rows, int number = 0) {
  Clip clip;
  clip.name = "clip";
  clip.frames.resize(1);
  clip.frames[0].number = number;
  clip.frames[0].color = ImageBuffer(16, rows, PixelFormat::kRgba8);
  return clip;
}

TEST(ClipSource, IsItsClipOrNone) {
  const auto clip = std::make_shared<const Clip>(ClipOf(1));
  EXPECT_EQ(ClipSource(clip).Take(), clip);
  EXPECT_FALSE(ClipSource());
  EXPECT_FALSE(ClipSource(std::shared_ptr<const Clip>()));
}

TEST(ClipShelf, CountsTheBytesOfBuffers) {
  Clip clip = ClipOf(3);
  clip.frames[0].motion = MotionBuffer(8, 2);
  EXPECT_EQ(ClipBytes(clip), 5U * 64);
}

TEST(ClipShelf, WithoutALimitLoadsEachOnce) {
  ClipShelf shelf;
  std::vector<ClipSource> sources;
  for (int i = 0; i < 4; ++i) sources.push_back(shelf.Add([i] { return ClipOf(1, i); }));
  EXPECT_EQ(shelf.loads(), 0);
  for (int cycle = 0; cycle < 3; ++cycle) {
    for (int i = 0; i < 4; ++i) EXPECT_EQ(sources[i].Take()->frames[0].number, i);
  }
  EXPECT_EQ(shelf.loads(), 4);
  EXPECT_EQ(shelf.held(), 4U * 64);
}

// However many clips there are, no more than the limit is held, and a cycle loads those alone that
// have no room.
TEST(ClipShelf, HoldsNoMoreThanItsLimit) {
  for (const int clips : {3, 10, 100}) {
    ClipShelf shelf(3 * 64);
    std::vector<ClipSource> sources;
    for (int i = 0; i < clips; ++i) sources.push_back(shelf.Add([i] { return ClipOf(1, i); }));
    const auto cycle = [&] {
      for (int i = 0; i < clips; ++i) {
        EXPECT_EQ(sources[i].Take()->frames[0].number, i);
        EXPECT_EQ(sources[i].Take()->frames[0].number, i) << "again, without another load";
      }
    };
    cycle();
    EXPECT_EQ(shelf.loads(), clips);
    cycle();
    cycle();
    EXPECT_EQ(shelf.loads(), clips == 3 ? clips : clips + 2 * (clips - 2));
    EXPECT_LE(shelf.most_held(), 3U * 64);
  }
}

TEST(ClipShelf, MakesRoomForALargeOne) {
  ClipShelf shelf(4 * 64);
  const ClipSource small = shelf.Add([] { return ClipOf(1); });
  const ClipSource middle = shelf.Add([] { return ClipOf(2); });
  const ClipSource large = shelf.Add([] { return ClipOf(4); });
  for (int cycle = 0; cycle < 2; ++cycle) {
    for (const ClipSource* source : {&small, &middle, &large}) source->Take();
  }
  EXPECT_EQ(shelf.most_held(), 4U * 64);
}

TEST(ClipShelf, RefusesAClipAboveTheLimit) {
  ClipShelf shelf(std::size_t{1} << 20);
  const ClipSource source = shelf.Add([] { return ClipOf((1 << 14) + 16); });
  ExpectError([&] { source.Take(); }, {"'clip'", "1025 KiB", "limit of 1024 KiB"});
}

}  // namespace
}  // namespace warplut
