#include "datasets/images/image_list.h"

#include <gtest/gtest.h>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/sequence/frame_pattern.h"
#include "datasets/sequence/sequence_writer.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

using Paths = std::vector<std::filesystem::path>;

Paths Files(const std::filesystem::path& path) {
  Paths files;
  for (const ListedImage& image : ListImages(path)) files.push_back(image.file);
  return files;
}

TEST(ListImages, FileAndFolder) {
  const TemporaryFolder folder;
  CreateFolder(folder / "sub.png");
  for (const char* name : {"b.png", "a.PNG", "c.exr", ".hidden.png", "notes.txt"})
    WriteFile(folder / name, "x");
  EXPECT_EQ(Files(folder / "b.png"), Paths{folder / "b.png"});
  EXPECT_EQ(Files(folder.path()), (Paths{folder / "a.PNG", folder / "b.png", folder / "c.exr"}));
}

TEST(ListImages, SequenceGivesReferencesElseColours) {
  const TemporaryFolder folder;
  Sequence s =
      StandardSequence("s", 5, 2, {2, 2}, {4, 4}, ColorSpace::kSrgb, Streams::kReference, 0.1, 10);
  WriteFile(folder / Sequence::kManifest, SequenceJson(s));
  CreateFolder(folder / "hr/color");
  CreateFolder(folder / "lr/color");
  WriteFile(folder / "hr/color/0005.png", "x");
  ExpectError([&] { ListImages(folder.path()); }, {"hr/color/0006.png", "does not exist"});
  WriteFile(folder / "hr/color/0006.png", "x");
  const Paths references{folder / "hr/color/0005.png", folder / "hr/color/0006.png"};
  EXPECT_EQ(Files(folder.path()), references);
  EXPECT_EQ(Files(folder / Sequence::kManifest), references);

  s.reference.reset();
  s.count = 1;
  WriteFile(folder / Sequence::kManifest, SequenceJson(s));
  WriteFile(folder / "lr/color/0005.png", "x");
  EXPECT_EQ(Files(folder.path()), Paths{folder / "lr/color/0005.png"});
}

// A sequence of `count` frames, 12 x 10, whose colour is in the file beside other channels.
Sequence WriteLayered(const std::filesystem::path& folder, int count, ColorSpace color_space,
                      float red) {
  Sequence s =
      StandardSequence("s", 0, count, {12, 10}, {12, 10}, color_space, Streams::kColor, 0.1, 10);
  s.color = {.path = "%04d.exr", .channels = {"beauty.R", "beauty.G", "beauty.B"}};
  CreateFolder(folder);
  for (int i = 0; i < count; ++i) {
    Image image(12, 10, 4);
    for (std::size_t p = 0; p < image.pixels(); ++p) {
      image.data[4 * p] = 7;  // no colour
      image.data[4 * p + 1] = 0.25f;
      image.data[4 * p + 2] = 0.5f;
      image.data[4 * p + 3] = red;
    }
    WriteImage(folder / FrameFileName(s.color.path, i), image, PixelType::kFloat,
               {"Z", "beauty.B", "beauty.G", "beauty.R"});
  }
  WriteFile(folder / Sequence::kManifest, SequenceJson(s));
  return s;
}

TEST(LoadListedImage, ReadsASequenceAsItsManifestSays) {
  const TemporaryFolder folder;
  WriteLayered(folder / "a", 2, ColorSpace::kSrgb, 0.75f);
  const std::vector<ListedImage> listed = ListImages(folder / "a");
  ASSERT_EQ(listed.size(), 2U);
  EXPECT_FALSE(listed[0].IsLinear());
  const Image image = LoadListedImage(listed[1]);
  ASSERT_EQ(image.channels, 3);
  EXPECT_EQ(image.at(3, 2, 0), 0.75f);
  EXPECT_EQ(image.at(3, 2, 1), 0.5f);
  EXPECT_EQ(image.at(3, 2, 2), 0.25f);
  ExpectError([&] { LoadListedImage(ListImages(folder / "a/0001.exr")[0]); },
              {"0001.exr", "beauty.R", "expected R, G, B"});

  WriteLayered(folder / "b", 1, ColorSpace::kSrgb, 1.5f);
  ExpectError([&] { LoadListedImage(ListImages(folder / "b")[0]); }, {"0000.exr", "1.5", "linear"});
  WriteLayered(folder / "b", 1, ColorSpace::kLinear, 1.5f);
  EXPECT_TRUE(ListImages(folder / "b")[0].IsLinear());
  EXPECT_EQ(LoadListedImage(ListImages(folder / "b")[0]).at(0, 0, 0), 1.5f);
}

TEST(ListImages, AFolderOfSequencesGivesTheirImages) {
  const TemporaryFolder folder;
  WriteLayered(folder / "scenes/b", 1, ColorSpace::kSrgb, 0.5f);
  WriteLayered(folder / "scenes/a", 2, ColorSpace::kSrgb, 0.5f);
  CreateFolder(folder / "scenes/other");
  EXPECT_EQ(Files(folder / "scenes"),
            (Paths{folder / "scenes/a/0000.exr", folder / "scenes/a/0001.exr",
                   folder / "scenes/b/0000.exr"}));
  EXPECT_EQ(SequencesBelow(folder / "scenes"), (Paths{folder / "scenes/a", folder / "scenes/b"}));
  ExpectError([&] { ReadSequence(folder / "scenes"); },
              {"scenes'", "has no sequence.json", "a, b"});
  ExpectError([&] { ReadSequence(folder / "scenes/other"); }, {"other", "does not exist"});
}

TEST(ListImages, NothingIsAnError) {
  const TemporaryFolder folder;
  ExpectError([&] { ListImages(folder.path()); }, {"has no images"});
  ExpectError([&] { ListImages(folder / "none"); }, {"none", "does not exist"});
}

}  // namespace
}  // namespace warplut
