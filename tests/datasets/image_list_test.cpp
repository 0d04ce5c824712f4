#include "datasets/image_list.h"

#include <gtest/gtest.h>

#include "datasets/file.h"
#include "datasets/sequence_writer.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

using Paths = std::vector<std::filesystem::path>;

TEST(ListImages, FileAndFolder) {
  const TemporaryFolder folder;
  CreateFolder(folder / "sub.png");
  for (const char* name : {"b.png", "a.PNG", "c.exr", ".hidden.png", "notes.txt"})
    WriteFile(folder / name, "x");
  EXPECT_EQ(ListImages(folder / "b.png"), Paths{folder / "b.png"});
  EXPECT_EQ(ListImages(folder.path()),
            (Paths{folder / "a.PNG", folder / "b.png", folder / "c.exr"}));
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
  EXPECT_EQ(ListImages(folder.path()), references);
  EXPECT_EQ(ListImages(folder / Sequence::kManifest), references);

  s.reference.reset();
  s.count = 1;
  WriteFile(folder / Sequence::kManifest, SequenceJson(s));
  WriteFile(folder / "lr/color/0005.png", "x");
  EXPECT_EQ(ListImages(folder.path()), Paths{folder / "lr/color/0005.png"});
}

TEST(ListImages, NothingIsAnError) {
  const TemporaryFolder folder;
  ExpectError([&] { ListImages(folder.path()); }, {"has no images"});
  ExpectError([&] { ListImages(folder / "none"); }, {"none", "does not exist"});
}

}  // namespace
}  // namespace warplut
