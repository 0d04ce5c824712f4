// Fits of every version load, and bake to the bytes that the program of their time baked.
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "datasets/file.h"
#include "datasets/hash.h"
#include "luts/bake/bake.h"
#include "luts/fit/fit.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

const fs::path kReleased = WARPLUT_RELEASED;

struct ReleasedFit {
  const char* file;
  const char* name;
  double scale;
  const char* objective;
  Footprint footprint;
  PrefilterKind prefilter;
  bool cut;
  const char* baked;       // table that was baked of it then, or null
  const char* baked_sha1;  // of the table that is baked of it, in place of a file
};

constexpr ReleasedFit kFits[] = {
    {"version1_warp", "warplut_x4", 4, "warp", Footprint::k16, PrefilterKind::kNone, false,
     "version1_i16", nullptr},
    {"version1_sr", "warplut_sr_x1_5", 1.5, "sr", Footprint::k16, PrefilterKind::kNone, false,
     "version1_sr", nullptr},
    {"version2_recursive", "warplut_iir_x1_7", 1.7, "warp", Footprint::k16,
     PrefilterKind::kRecursive, false, "version2_recursive", nullptr},
    {"version2_taps24", "warplut_t24_x2", 2, "warp", Footprint::k24, PrefilterKind::kNone, false,
     "version2_taps24", nullptr},
    {"version2_taps36_cut", "taps36", 2, "warp", Footprint::k36, PrefilterKind::kNone, true,
     nullptr, "2afbad66ac3e70b9480d2486f5fc0cd0b280166d"},
    {"version2_fir", "fir", 2, "warp", Footprint::k16, PrefilterKind::kFir, false, nullptr,
     "6a4767dd996a86b38c7e831eb23e10bfd5455b15"},
};

class ReleasedFitTest : public testing::TestWithParam<ReleasedFit> {
 protected:
  static fs::path File() { return kReleased / "fits" / (std::string(GetParam().file) + ".json"); }
};

INSTANTIATE_TEST_SUITE_P(Fits, ReleasedFitTest, testing::ValuesIn(kFits),
                         [](const auto& test) { return std::string(test.param.file); });

TEST_P(ReleasedFitTest, LoadsWithItsValues) {
  const Fit fit = ReadFit(File());
  EXPECT_EQ(fit.name, GetParam().name);
  EXPECT_EQ(fit.scale, GetParam().scale);
  EXPECT_EQ(fit.objective, GetParam().objective);
  EXPECT_EQ(fit.footprint, GetParam().footprint);
  EXPECT_EQ(fit.prefilter.kind, GetParam().prefilter);
  EXPECT_EQ(fit.cut, GetParam().cut);
}

TEST_P(ReleasedFitTest, IsWrittenAsItWas) {
  const fs::path again = fs::path(testing::TempDir()) / (std::string(GetParam().file) + ".json");
  WriteFit(again, ReadFit(File()));
  EXPECT_EQ(ReadFile(again), ReadFile(File()));
  fs::remove(again);
}

TEST_P(ReleasedFitTest, BakesToTheBytesOfItsTime) {
  const std::string json = Bake(ReadFit(File())).json;
  if (GetParam().baked != nullptr) {
    const fs::path then = kReleased / "tables" / (std::string(GetParam().baked) + ".json");
    EXPECT_TRUE(json == ReadFile(then)) << "the table differs from " << then;
  } else {
    EXPECT_EQ(Sha1(json), GetParam().baked_sha1);
  }
}

// The lines of a header that hold weights.
std::vector<std::string> WeightLines(const std::string& header) {
  std::vector<std::string> lines;
  std::istringstream text(header);
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("    ") && line.find_first_not_of(" -0123456789,") == std::string::npos) {
      lines.push_back(line);
    }
  }
  return lines;
}

TEST(ReleasedFits, BakeToTheWeightsOfHeadersAndTheExrOfTheirTime) {
  const BakedFiles first = Bake(ReadFit(kReleased / "fits" / "version1_warp.json"));
  const std::vector<std::string> weights =
      WeightLines(ReadFile(kReleased / "tables" / "version1_header.inc"));
  EXPECT_EQ(weights.size(), 1024U);
  EXPECT_EQ(WeightLines(first.header), weights);
  EXPECT_TRUE(first.exr == ReadFile(kReleased / "tables" / "version1.exr"));
  const BakedFiles prefiltered = Bake(ReadFit(kReleased / "fits" / "version2_recursive.json"));
  EXPECT_EQ(WeightLines(prefiltered.header),
            WeightLines(ReadFile(kReleased / "tables" / "version2_recursive_header.inc")));
}

// The first fit in the formats of a table that it was not stored in.
TEST(ReleasedFits, BakeToTheBytesOfTheirTimeInEveryFormat) {
  constexpr std::pair<TableFormat, const char*> kBaked[] = {
      {TableFormat::kI8, "0ff5601c02ae1b83a699220a261f39f30b60b76d"},
      {TableFormat::kF16, "49d089c8c1d9318d3e84d89bc9f5a6b2f2c62765"},
      {TableFormat::kF32, "e88a34899d6c4440c4be5804d7e0dde5c58a3ca4"}};
  const Fit fit = ReadFit(kReleased / "fits" / "version1_warp.json");
  for (const auto& [format, sha1] : kBaked) {
    EXPECT_EQ(Sha1(Bake(fit, {.format = format}).json), sha1) << Name(format);
  }
}

}  // namespace
}  // namespace warplut
