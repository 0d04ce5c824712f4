// Bakes every fit that ships again and compares with the files that ship.
#include <gtest/gtest.h>

#include <set>

#include "datasets/file.h"
#include "luts/bake/assets.h"
#include "luts/bake/bake.h"
#include "luts/bake/released_layout.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

const fs::path kFits = fs::path(WARPLUT_LUTS_DIR) / "fits";
const fs::path kBaked = fs::path(WARPLUT_LUTS_DIR) / "baked";

std::set<std::string> FilesOf(const fs::path& folder) {
  std::set<std::string> names;
  if (!fs::is_directory(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

TEST(BakedAssets, ExactlyTheNamedFilesShip) {
  std::set<std::string> fits;
  std::set<std::string> baked;
  for (const std::string_view asset : kAssets) {
    const std::string name(asset);
    fits.insert(name + ".json");
    baked.insert({name + ".h", name + ".json"});
    const Fit fit = ReadFit(kFits / (name + ".json"));
    if (HasReleasedLayout(fit)) baked.insert(name + ".exr");
  }
  EXPECT_EQ(FilesOf(kFits), fits);
  EXPECT_EQ(FilesOf(kBaked), baked);
}

class BakedAssetTest : public testing::TestWithParam<std::string_view> {};

INSTANTIATE_TEST_SUITE_P(Assets, BakedAssetTest, testing::ValuesIn(kAssets),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(BakedAssetTest, IsWhatItsFitBakesTo) {
  const std::string name(GetParam());
  const Fit fit = ReadFit(kFits / (name + ".json"));
  EXPECT_EQ(fit.name, name);
  const BakedFiles files = Bake(fit);
  const auto same = [&](const char* extension, const std::string& bytes) {
    return ReadFile(kBaked / (name + extension)) == bytes;
  };
  EXPECT_TRUE(same(".h", files.header)) << "bake it again";
  EXPECT_TRUE(same(".json", files.json)) << "bake it again";
  if (HasReleasedLayout(fit)) {
    EXPECT_TRUE(same(".exr", files.exr)) << "bake it again";
  }
}

}  // namespace
}  // namespace warplut
