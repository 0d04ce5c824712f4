// Sequences that were rendered elsewhere, in the folder that WARPLUT_DATA names.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <vector>

#include "datasets/sequence/sequence.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> StoredSequences() {
  std::vector<fs::path> folders;
  const char* data = std::getenv("WARPLUT_DATA");
  if (data == nullptr || !fs::is_directory(data)) return folders;
  for (const auto& entry : fs::directory_iterator(data)) {
    if (fs::exists(entry.path() / Sequence::kManifest)) folders.push_back(entry.path());
  }
  return folders;
}

struct Similarity {
  double warped = 0, still = 0;  // PSNR in dB
};

// Of `current` to the bilinear sample of `previous` at p - m, and to `previous` itself, where that
// sample is inside.
Similarity Compare(const Image& previous, const Image& current, const Image& motion) {
  double warped = 0, still = 0, n = 0;
  for (int y = 0; y < current.height; ++y) {
    for (int x = 0; x < current.width; ++x) {
      const double sx = x - double{motion.at(x, y, 0)}, sy = y - double{motion.at(x, y, 1)};
      const int ix = static_cast<int>(std::floor(sx)), iy = static_cast<int>(std::floor(sy));
      if (ix < 0 || iy < 0 || ix + 1 >= current.width || iy + 1 >= current.height) continue;
      const double dx = sx - ix, dy = sy - iy;
      for (int c = 0; c < 3; ++c) {
        const double top = std::lerp(previous.at(ix, iy, c), previous.at(ix + 1, iy, c), dx);
        const double low =
            std::lerp(previous.at(ix, iy + 1, c), previous.at(ix + 1, iy + 1, c), dx);
        const double value = current.at(x, y, c);
        warped += std::pow(std::lerp(top, low, dy) - value, 2);
        still += std::pow(double{previous.at(x, y, c)} - value, 2);
        n += 1;
      }
    }
  }
  return {-10 * std::log10(warped / n), -10 * std::log10(still / n)};
}

TEST(StoredSequences, MotionBringsThePreviousReferenceToTheCurrentOne) {
  const std::vector<fs::path> folders = StoredSequences();
  if (folders.empty()) GTEST_SKIP() << "WARPLUT_DATA names no folder of sequences";
  for (const fs::path& folder : folders) {
    const Sequence sequence = ReadSequence(folder);
    if (!sequence.reference || !sequence.reference_motion) continue;
    Similarity mean;
    Frame previous = LoadFrame(sequence, 0, Streams::kReference);
    for (int index = 1; index < sequence.count; ++index) {
      Frame frame = LoadFrame(sequence, index, Streams::kReference | Streams::kReferenceMotion);
      const Similarity s = Compare(previous.reference, frame.reference, frame.reference_motion);
      EXPECT_GT(s.warped, s.still) << folder << " frame " << frame.number;
      mean.warped += s.warped / (sequence.count - 1);
      mean.still += s.still / (sequence.count - 1);
      previous = std::move(frame);
    }
    std::cout << sequence.name << ": warped " << mean.warped << " dB, as it is " << mean.still
              << " dB\n";
  }
}

TEST(StoredSequences, AllStreamsOfAFrameLoad) {
  const std::vector<fs::path> folders = StoredSequences();
  if (folders.empty()) GTEST_SKIP() << "WARPLUT_DATA names no folder of sequences";
  for (const fs::path& folder : folders) {
    const Sequence sequence = ReadSequence(folder);
    for (const int index : {0, sequence.count - 1}) {
      const Frame frame = LoadFrame(sequence, index, AvailableStreams(sequence));
      EXPECT_EQ(frame.number, sequence.first + index);
      EXPECT_EQ(frame.color.width, sequence.render.width);
      EXPECT_EQ(frame.color.channels, 3);
      if (sequence.depth) {
        for (const float d : frame.depth.data) ASSERT_TRUE(d >= 0);
      }
    }
  }
}

}  // namespace
}  // namespace warplut
