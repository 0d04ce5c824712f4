#include "datasets/sequence/sequence_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "datasets/file.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

constexpr GridSize kRender{12, 8}, kOutput{24, 12};

Image Noise(GridSize grid, int channels, double low, double high, unsigned seed) {
  Image image(grid.width, grid.height, channels);
  for (float& v : image.data) {
    seed = seed * 1664525U + 1013904223U;
    v = static_cast<float>(low + (high - low) * (seed >> 24) / 255.0);
  }
  return image;
}

Frame SomeFrame(unsigned seed) {
  Frame frame;
  frame.color = Noise(kRender, 3, 0, 1, seed);
  frame.depth = Noise(kRender, 1, 0.1, 1, seed + 1);
  frame.motion = Noise(kRender, 2, -5, 5, seed + 2);
  frame.reference = Noise(kOutput, 3, 0, 1, seed + 3);
  frame.reference_depth = Noise(kOutput, 1, 0.1, 1, seed + 4);
  frame.reference_motion = Noise(kOutput, 2, -5, 5, seed + 5);
  return frame;
}

Sequence Standard(ColorSpace space = ColorSpace::kSrgb) {
  return StandardSequence("demo", 3, 2, kRender, kOutput, space, Streams::kAll, 0.1, 100);
}

void ExpectNear(const Image& a, const Image& b, double tolerance) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  ASSERT_EQ(a.channels, b.channels);
  for (std::size_t i = 0; i < a.data.size(); ++i) ASSERT_NEAR(a.data[i], b.data[i], tolerance) << i;
}

void ExpectNear(const Frame& a, const Frame& b, double color, double depth, double motion) {
  ExpectNear(a.color, b.color, color);
  ExpectNear(a.depth, b.depth, depth);
  ExpectNear(a.motion, b.motion, motion);
  ExpectNear(a.reference, b.reference, color);
  ExpectNear(a.reference_depth, b.reference_depth, depth);
  ExpectNear(a.reference_motion, b.reference_motion, motion);
}

// Writes `sequence`, reads it back and compares.
void RoundTrip(const Sequence& sequence, double color, double depth, double motion) {
  const TemporaryFolder folder;
  const SequenceWriter writer(folder / "seq", sequence);
  for (int i = 0; i < sequence.count; ++i) writer.Write(i, SomeFrame(static_cast<unsigned>(i)));
  writer.Finish();
  const Sequence read = ReadSequence(folder / "seq");
  EXPECT_EQ(SequenceJson(read), SequenceJson(sequence));
  for (int i = 0; i < sequence.count; ++i) {
    ExpectNear(LoadFrame(read, i, Streams::kAll), SomeFrame(static_cast<unsigned>(i)), color, depth,
               motion);
  }
}

TEST(SequenceWriter, StandardLayoutRoundTrip) { RoundTrip(Standard(), 1e-7, 1e-7, 0); }

TEST(SequenceWriter, LinearColourRoundTrip) {
  RoundTrip(Standard(ColorSpace::kLinear), 1.0 / 2048, 1e-7, 0);
}

TEST(SequenceWriter, HyperbolicDepthAndOtherMotionRoundTrip) {
  Sequence s = Standard();
  s.depth->kind = DepthKind::kForward;
  s.depth->near = 5;
  s.reference_depth->kind = DepthKind::kReversed;
  s.reference_depth->near = 5;
  s.motion->units = MotionUnits::kUv;
  s.motion->y = YAxis::kUp;
  s.reference_motion->units = MotionUnits::kNdc;
  s.reference_motion->direction = MotionDirection::kCurrentToPrevious;
  s.reference_motion->path.clear();
  s.reference_motion->path_x = "hr/x/%d.exr";
  s.reference_motion->path_y = "hr/y/%d.exr";
  RoundTrip(s, 1e-7, 2e-6, 1e-6);
}

TEST(SequenceWriter, InfiniteFarRoundTrip) {
  Sequence s = Standard();
  s.depth->kind = DepthKind::kReversed;
  s.depth->far = std::numeric_limits<double>::infinity();
  const TemporaryFolder folder;
  const SequenceWriter writer(folder.path(), s);
  Frame frame = SomeFrame(1);
  for (float& d : frame.depth.data) d = 1 + 100 * d;
  frame.depth.data[7] = std::numeric_limits<float>::infinity();
  writer.Write(0, frame);
  const Image read = LoadFrame(writer.sequence(), 0, Streams::kDepth).depth;
  EXPECT_TRUE(std::isinf(read.data[7]));
  for (std::size_t i = 0; i < read.data.size(); ++i) {
    if (i == 7) continue;
    ASSERT_NEAR(read.data[i] / frame.depth.data[i], 1, 1e-6);
  }
}

TEST(SequenceWriter, PackedRoundTrip) {
  Sequence s = Standard();
  for (auto* depth : {&*s.depth, &*s.reference_depth}) {
    depth->encoding = Encoding::kRgba8Base255;
    depth->channels.clear();
    depth->scale = 100;
  }
  s.depth->path = "lr/depth/%04d.png";
  s.reference_depth->path = "hr/depth/%04d.png";
  for (auto* motion : {&*s.motion, &*s.reference_motion}) {
    motion->encoding = Encoding::kRgba8Base255;
    motion->channels.clear();
    motion->path.clear();
    motion->scale = {2, -2};
    motion->bias = {-1, 1};
    motion->units = MotionUnits::kUv;
  }
  s.motion->path_x = "lr/x/%d.png";
  s.motion->path_y = "lr/y/%d.png";
  s.reference_motion->path_x = "hr/x/%d.png";
  s.reference_motion->path_y = "hr/y/%d.png";
  RoundTrip(s, 1e-7, 1e-7, 1e-6);
}

TEST(SequenceWriter, ManifestComesLastAndFramesAreTakenUpAgain) {
  const TemporaryFolder folder;
  const auto manifest = folder / Sequence::kManifest;
  {
    const SequenceWriter writer(folder.path(), Standard());
    EXPECT_FALSE(writer.Has(0));
    writer.Write(0, SomeFrame(1));
    EXPECT_TRUE(writer.Has(0));
    EXPECT_FALSE(writer.Has(1));
    EXPECT_FALSE(writer.Has(2));
    ExpectError([&] { writer.Finish(); }, {"'demo'", "0004.png", "missing"});
    EXPECT_FALSE(std::filesystem::exists(manifest));
  }
  const SequenceWriter writer(folder.path(), Standard());
  EXPECT_TRUE(writer.Has(0));
  writer.Write(1, SomeFrame(2));
  writer.Finish();
  EXPECT_EQ(ReadFile(manifest), SequenceJson(Standard()));
  EXPECT_EQ(folder.Entries(), 3U);  // lr, hr and the manifest

  // A damaged frame is not there.
  WriteFile(folder / "hr/motion/0004.exr", ReadFile(folder / "hr/motion/0004.exr").substr(0, 500));
  EXPECT_FALSE(writer.Has(1));
  writer.Write(1, SomeFrame(2));
  EXPECT_FALSE(std::filesystem::exists(manifest));
  EXPECT_TRUE(writer.Has(1));
}

TEST(SequenceWriter, AnotherSequenceInTheFolderIsKept) {
  const TemporaryFolder folder;
  Sequence other = Standard();
  other.jitter = {{0.25, 0}};
  { const SequenceWriter writer(folder.path(), Standard()); }
  ExpectError([&] { SequenceWriter(folder.path(), other); }, {"partial", "another sequence"});
  WriteFile(folder / Sequence::kManifest, SequenceJson(other));
  ExpectError([&] { SequenceWriter(folder.path(), Standard()); },
              {Sequence::kManifest, "another sequence"});
}

TEST(SequenceWriter, ErrorsNameTheStream) {
  const TemporaryFolder folder;
  const SequenceWriter writer(folder.path(), Standard());
  Frame frame = SomeFrame(1);
  frame.motion = Image();
  ExpectError([&] { writer.Write(0, frame); }, {"frame 3", "'motion'", "0 x 0", "12 x 8 with 2"});
  ExpectError([&] { writer.Write(2, SomeFrame(1)); }, {"index 2"});
  frame = SomeFrame(1);
  frame.reference_depth.data[0] = -1;
  ExpectError([&] { writer.Write(0, frame); }, {"hr/depth/0003.exr", "-1"});

  const auto refused = [&](const Sequence& s, std::initializer_list<std::string> pieces) {
    ExpectError([&] { SequenceWriter(folder / "other", s); }, pieces);
    EXPECT_FALSE(std::filesystem::exists(folder / "other"));
  };
  Sequence s = Standard();
  s.count = 0;
  refused(s, {"frames.count"});
  s = Standard();
  s.depth->path = "lr/depth/%04d.png";
  refused(s, {"lr/depth", "'.png'", ".exr"});
  s = Standard();
  s.reference->path = s.color.path;
  refused(s, {"two streams"});
  s = Standard();
  s.color.channels = {"R", "G", "B"};
  refused(s, {"named channels"});
  s = Standard(ColorSpace::kLinear);
  s.color.channels = {"Y"};
  refused(s, {"one named channel"});
}

}  // namespace
}  // namespace warplut
